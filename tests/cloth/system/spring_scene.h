#pragma once
// What the loops over springs are tested on, and the same computed one particle at a time in double
// precision.

#include <random>
#include <vector>

#include "cloth/fabric/spring_system.h"
#include "cloth/fabric/springs/membrane.h"
#include "cloth/fabric/springs/springs.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {

/// A moving cloth in moving air, a few particles pinned, and all that a step's equation refers to.
struct SpringScene {
    ClothModel model;
    ClothSettings settings;
    AlignedBuffer<Vec4> positions, velocities, base_velocities, air;
    LinearisedAbout about = LinearisedAbout::base;

    [[nodiscard]] std::uint32_t size() const { return model.particle_count; }
    [[nodiscard]] StepEquation equation() const {
        return {.settings = settings,
                .h = 1.0f / 60,
                .gamma = 1.0f / 60,
                .rigidity = settings.fabric.bending,
                .positions = positions.span(),
                .velocities = velocities.span(),
                .base_positions = positions.span(),
                .base_velocities = base_velocities.span(),
                .external = {.gravity = {0, -9.81f, 0}, .air_damping = 0.5f, .air = air.span()}};
    }
    /// Where springs are looked at.
    [[nodiscard]] Vector3 place(std::uint32_t i) const {
        const float gamma = about == LinearisedAbout::base ? 0 : equation().gamma;
        return xyz(positions[i]) + gamma * xyz(velocities[i]);
    }
};

inline SpringScene make_scene(const Mesh& mesh, float stiffness, LinearisedAbout about) {
    SpringScene scene;
    scene.model = cook(mesh).value();
    const std::uint32_t n = scene.size();
    scene.settings.fabric = {
        .warp = stiffness, .weft = stiffness, .shear = 0.3f * stiffness, .bending = 1e-4f * stiffness};
    scene.settings.fabric.damping = 0.01f;
    scene.positions = random_rows(n, 0.3f * scene.model.info.mean_edge, 1);
    scene.velocities = random_rows(n, 1, 2);
    scene.base_velocities = random_rows(n, 1, 3);
    scene.air = random_rows(n, 1e-3f, 4);
    for (std::uint32_t i = 0; i < n; ++i) {
        Vec4& x = scene.positions[i];
        const Vector3 noise = xyz(x);
        const float mass = scene.settings.fabric.areal_density * scene.model.rest_area[i];
        x = to_vec4(xyz(scene.model.positions[i]) + noise, i % 13 == 4 ? 0 : 1 / mass);
        scene.air[i].w = 1e-4f * static_cast<float>(i % 3);
    }
    scene.about = about;
    return scene;
}

/// Puts every fifth particle where its first neighbour is.
inline void make_coincident(SpringScene& scene) {
    for (std::uint32_t i = 0; i < scene.size(); i += 5) {
        const std::uint32_t j = scene.model.neighbours[scene.model.spring_offsets[i]];
        set_xyz(scene.positions[i], xyz(scene.positions[j]));
        scene.velocities[i] = scene.velocities[j];
    }
}

/// Rows that sum to 1, of nodes anywhere; those of pinned particles are 0.
inline Interpolation random_interpolation(const SpringScene& scene, std::uint32_t coarse) {
    Interpolation p(scene.size(), coarse);
    std::mt19937 random(11);
    for (std::uint32_t e = 0; e < Interpolation::width * p.fine; ++e) {
        p.nodes[e] = static_cast<std::uint32_t>(random()) % coarse;
        const float weights[] = {0.5f, 0.3f, 0.2f};
        const bool is_pinned = scene.positions[e / Interpolation::width].w == 0;
        p.weights[e] = is_pinned ? 0 : weights[e % Interpolation::width];
    }
    return p;
}

/// By how much the sides of triangles shift one another's rest lengths, of each half-edge [m]. None in a
/// sheet.
inline std::vector<double> rest_shifts(const SpringScene& scene, std::span<const float> stiffness) {
    const ClothModel& model = scene.model;
    std::vector<double> shifts(model.neighbours.size());
    for (std::uint32_t t = 0; model.rows == 0 && t < model.triangles.size(); ++t) {
        const TriangleMembrane membrane = triangle_membrane(model, t, scene.settings.fabric);
        const Triangle& corners = model.triangles[t];
        std::array<double, 3> extensions{};
        for (std::size_t m = 0; m < 3; ++m)
            extensions[m] =
                static_cast<double>((scene.place(corners[(m + 1) % 3]) - scene.place(corners[m])).norm()) -
                membrane.rest_lengths[m];
        for (std::size_t k = 0; k < 3; ++k) {
            double tension = 0;
            for (std::size_t m = 0; m < 3; ++m) tension += membrane.shared[k][m] * extensions[m];
            const std::uint32_t i = corners[k], j = corners[(k + 1) % 3];
            for (const std::uint32_t e : {half_edge_between(model, i, j), half_edge_between(model, j, i)})
                shifts[e] -= tension / static_cast<double>(stiffness[e]);
        }
    }
    return shifts;
}

/// Of each half-edge: of a sheet q [N/m] alone, of a mesh what its triangles add where particles are.
struct StiffeningOfEdges {
    std::vector<double> tensions, slopes;
};
inline StiffeningOfEdges stiffening_of(const SpringScene& scene) {
    const ClothModel& model = scene.model;
    StiffeningOfEdges result{std::vector<double>(model.neighbours.size()),
                             std::vector<double>(model.neighbours.size())};
    const auto add = [&](std::uint32_t i, std::uint32_t j, double tension, double slope) {
        for (const std::uint32_t e : {half_edge_between(model, i, j), half_edge_between(model, j, i)}) {
            result.tensions[e] += tension;
            result.slopes[e] += slope;
        }
    };
    for (std::uint32_t row = 0; row + 1 < model.rows; ++row)
        for (std::uint32_t column = 0; column + 1 < model.columns; ++column)
            for_each_stiffening_of_cell(model, scene.settings.fabric, row * model.columns + column,
                                        [&](std::uint32_t i, std::uint32_t j, double q) { add(i, j, 0, q); });
    for (std::uint32_t t = 0; model.rows == 0 && t < model.triangles.size(); ++t) {
        const Triangle& corners = model.triangles[t];
        const TriangleMembrane membrane = triangle_membrane(model, t, scene.settings.fabric);
        std::array<double, 3> extensions{};
        for (std::size_t m = 0; m < 3; ++m)
            extensions[m] =
                static_cast<double>((scene.place(corners[(m + 1) % 3]) - scene.place(corners[m])).norm()) -
                membrane.rest_lengths[m];
        const auto extra = triangle_stiffening(model, t, scene.settings.fabric).at(extensions);
        for (std::size_t k = 0; k < 3; ++k)
            add(corners[k], corners[(k + 1) % 3], extra.tension[k], extra.own[k]);
    }
    return result;
}
inline LinearSpring with_extra(double length, double rest, double k, double tension, double slope) {
    if (k + slope == 0) return {rest, 0};
    return {length - (k * (length - rest) + tension) / (k + slope), k + slope};
}

/// spring_terms and the equation, particle by particle, summed in double precision.
struct SpringReference {
    explicit SpringReference(const SpringScene& scene)
        : size(scene.size()),
          diagonal(size, Eigen::Matrix3d::Zero()),
          links(size),
          row_sums(size, 0),
          b(size) {
        const StepEquation equation = scene.equation();
        const auto gamma = static_cast<double>(equation.gamma);
        const bool about_base = scene.about == LinearisedAbout::base;
        std::vector<float> stiffness(scene.model.neighbours.size());
        spring_stiffness(scene.model, scene.settings.fabric, stiffness);
        const std::vector<double> shifts = rest_shifts(scene, stiffness);
        const bool stiffens = scene.settings.fabric.stiffening > 0;
        const StiffeningOfEdges extra = stiffens ? stiffening_of(scene) : StiffeningOfEdges{};
        const auto rigidity = static_cast<double>(scene.settings.fabric.bending);
        for (std::uint32_t i = 0; i < size; ++i) {
            b[i].setZero();
            if (scene.positions[i].w == 0) continue;
            const double mass = 1 / static_cast<double>(scene.positions[i].w);
            const Eigen::Vector3d v = velocity(scene, i);
            const auto air_damping = static_cast<double>(equation.external.air_damping);
            const auto slope = static_cast<double>(scene.air[i].w);
            row_sums[i] = mass * (1 + gamma * air_damping) + gamma * slope;
            b[i] = mass * (xyz(scene.base_velocities[i]).cast<double>() - v) +
                   gamma * mass * (equation.external.gravity.cast<double>() - air_damping * v) +
                   gamma * xyz(scene.air[i]).cast<double>();
            const double excess = rigidity * static_cast<double>(scene.model.bending_excess[i]);
            diagonal[i] = (row_sums[i] + gamma * (gamma + 0.01) * excess) * Eigen::Matrix3d::Identity();
            for (std::uint32_t e = scene.model.spring_offsets[i]; e < scene.model.spring_offsets[i + 1];
                 ++e) {
                const std::uint32_t j = scene.model.neighbours[e];
                float k = stiffness[e];
                float rest = scene.model.rest_lengths[e] + static_cast<float>(shifts[e]);
                if (stiffens) {
                    const double length = static_cast<double>((scene.place(j) - scene.place(i)).norm());
                    const LinearSpring linear =
                        scene.model.rows > 0
                            ? spring_at(length, static_cast<double>(rest), static_cast<double>(k),
                                        extra.slopes[e])
                            : with_extra(length, static_cast<double>(rest), static_cast<double>(k),
                                         extra.tensions[e], extra.slopes[e]);
                    rest = static_cast<float>(linear.rest_length);
                    k = static_cast<float>(linear.stiffness);
                }
                const SpringTerms spring = spring_terms(scene.place(j) - scene.place(i), rest, k, i, j);
                const Eigen::Vector3d n = spring.direction.cast<double>();
                const double viscous = gamma * 0.01 * static_cast<double>(k);
                const Eigen::Matrix3d elastic =
                    gamma * gamma *
                    (static_cast<double>(spring.isotropic) * Eigen::Matrix3d::Identity() +
                     static_cast<double>(spring.axial) * n * n.transpose());
                const Eigen::Matrix3d damping = viscous * n * n.transpose();
                const Eigen::Matrix3d block =
                    about_base ? Eigen::Matrix3d(elastic + damping)
                               : turning_too(scene, spring, i, j, rest,
                                             gamma * gamma * static_cast<double>(k), viscous);
                const double bending = rigidity * static_cast<double>(scene.model.bending[e]);
                const double bent = gamma * (gamma + 0.01) * bending;
                const Eigen::Matrix3d all = block + bent * Eigen::Matrix3d::Identity();
                links[i].push_back({j, all});
                diagonal[i] += all;
                b[i] += gamma * bending * (scene.place(j) - scene.place(i)).cast<double>() +
                        (bent - (about_base ? 0 : gamma * gamma * bending)) * (velocity(scene, j) - v);
                b[i] += gamma * spring.force.cast<double>() +
                        (damping + (about_base ? 1 : 0) * elastic) * (velocity(scene, j) - v);
            }
        }
    }

    /// Takes the system's blocks, which are those found here but for rounding to half precision (11 digits),
    /// to zero on some machines.
    void take_blocks(SpringSystem& system) {
        Parallel serial(1);
        const AlignedBuffer<Vec4> blocks = system.all_spring_blocks(serial);
        double largest = 0;  // beside which what is soft loses its digits, see SpringMatrix::set_unit
        for (const std::vector<Link>& row : links)
            for (const Link& link : row) largest = std::max(largest, link.block.norm());
        for (std::uint32_t i = 0; i < size; ++i) {
            for (Link& link : links[i]) {
                const Vec4& spring = blocks[system.entry_between(i, link.to)];
                const Eigen::Vector3d d = xyz(spring).cast<double>();
                const Eigen::Matrix3d block =
                    static_cast<double>(spring.w) * Eigen::Matrix3d::Identity() + d * d.transpose();
                EXPECT_LE((block - link.block).norm(), 0x1p-8 * link.block.norm() + 0x1p-34 * largest)
                    << i << " to " << link.to;
                diagonal[i] += block - link.block;
                link.block = block;
            }
        }
    }

    /// About the iterate: a I + (all - a) n n^T, where all that resists along the spring is elastic +
    /// viscous, and a is the tension over the length, damping's part included.
    static Eigen::Matrix3d turning_too(const SpringScene& scene, const SpringTerms& spring, std::uint32_t i,
                                       std::uint32_t j, float rest, double elastic, double viscous) {
        const Eigen::Vector3d n = spring.direction.cast<double>();
        const double length = (scene.place(j) - scene.place(i)).cast<double>().norm();
        const double rate = n.dot(velocity(scene, j) - velocity(scene, i));
        const double slack = length > 1e-12 ? (static_cast<double>(rest) - 0.01 * rate) / length : 1.0;
        const double a = std::clamp(elastic * (1 - slack), 0.0, elastic + viscous);
        return a * Eigen::Matrix3d::Identity() + (elastic + viscous - a) * n * n.transpose();
    }
    static Eigen::Vector3d velocity(const SpringScene& scene, std::uint32_t i) {
        return xyz(scene.velocities[i]).cast<double>();
    }
    [[nodiscard]] Eigen::Vector3d product(const AlignedBuffer<Vec4>& x, std::uint32_t i) const {
        const Eigen::Vector3d x_i = xyz(x[i]).cast<double>();
        Eigen::Vector3d sum = row_sums[i] * x_i;
        for (const Link& link : links[i]) sum += link.block * (x_i - xyz(x[link.to]).cast<double>());
        return sum;
    }
    /// Of the rounding to which the sums of row i are subject.
    [[nodiscard]] double scale(std::uint32_t i) const { return diagonal[i].trace(); }

    struct Link {
        std::uint32_t to;
        Eigen::Matrix3d block;
    };
    std::uint32_t size;
    std::vector<Eigen::Matrix3d> diagonal;
    std::vector<std::vector<Link>> links;
    std::vector<double> row_sums;
    std::vector<Eigen::Vector3d> b;
};

}  // namespace weft::test
