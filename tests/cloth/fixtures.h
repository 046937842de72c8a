#pragma once
// Cloths and dense references that several test files share.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <Eigen/Core>
#include <random>
#include <vector>

#include "cloth/equation/implicit_system.h"
#include "cloth/fabric/springs/membrane.h"
#include "cloth/instance/cloth.h"
#include "cloth/motion/survey.h"
#include "cloth/simulation/simulation.h"
#include "cloth/solver/make_system.h"
#include "weft/weft.h"

namespace weft::test {

inline constexpr float h = 1.0f / 60;              ///< s, a step as games take it
inline constexpr Vec3 downwards = {0, -9.81f, 0};  ///< m/s^2

inline Mesh sheet(std::uint32_t rows, std::uint32_t columns) {
    return make_sheet({.rows = rows, .columns = columns}).value();
}

inline bool same_bytes(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4)) == 0;
}

/// Root mean square over its particles [m/s].
inline double rms_speed(const ClothView& cloth) {
    double sum = 0;
    for (const Vec4& v : cloth.velocities) sum += xyz(v).cast<double>().squaredNorm();
    return std::sqrt(sum / static_cast<double>(cloth.velocities.size()));
}

inline double total_rest_area(const ClothModel& cloth) {
    double total = 0;
    for (const float area : cloth.rest_area.span()) total += static_cast<double>(area);
    return total;
}

/// A cloth without air, pins or damping, whose particles are displaced and moving at random: springs in
/// tension and in compression, all directions. Inertia and stiffness are of the same order, so that
/// iterations converge quickly.
inline Cloth crumpled(const Mesh& mesh, float displacement, float stiffness, std::uint32_t seed = 7) {
    ClothSettings settings;
    settings.fabric = {.areal_density = 2.0f,
                       .warp = stiffness,
                       .weft = stiffness,
                       .shear = 0.3f * stiffness,
                       .bending = 1e-3f * stiffness};
    settings.air_damping = 0;
    Cloth cloth(cook(mesh).value(), settings);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> offset(-displacement, displacement), speed(-1, 1);
    for (Vec4& x : cloth.state.positions.span()) {
        x.x += offset(random);
        x.y += offset(random);
        x.z += offset(random);
    }
    for (Vec4& v : cloth.state.velocities.span()) v = {speed(random), speed(random), speed(random), 0};
    return cloth;
}

/// The equation of one step of length h of backward Euler under gravity, without air.
inline StepEquation equation_of(const Cloth& cloth, float h, const Vector3& gravity = {0, -9.81f, 0}) {
    return {.settings = cloth.settings,
            .h = h,
            .gamma = h,
            .rigidity = cloth.settings.fabric.bending,
            .positions = cloth.state.positions.span(),
            .velocities = cloth.state.velocities.span(),
            .base_positions = cloth.state.positions.span(),
            .base_velocities = cloth.state.velocities.span(),
            .external = {.gravity = gravity, .air_damping = cloth.settings.air_damping, .air = {}}};
}

/// The cloth's system of that equation, linearised about the present positions.
inline std::unique_ptr<ImplicitSystem> assembled(const Cloth& cloth, float h,
                                                 const Vector3& gravity = {0, -9.81f, 0}) {
    Parallel serial(1);
    auto system = make_system(cloth.model, cloth.settings);
    system->linearise(serial, equation_of(cloth, h, gravity), cloth.state.velocities.span(),
                      LinearisedAbout::base);
    return system;
}

/// A World without air, on one thread.
inline WorldSettings vacuum(Vec3 gravity = {0, 0, 0}) {
    WorldSettings settings;
    settings.gravity = gravity;
    settings.wind.air_density = 0;
    settings.threads = 1;
    return settings;
}

/// Components uniform in [-size, size), w 0.
inline AlignedBuffer<Vec4> random_rows(std::uint32_t n, float size, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> component(-size, size);
    AlignedBuffer<Vec4> rows(n);
    for (Vec4& v : rows.span()) v = {component(random), component(random), component(random), 0};
    return rows;
}

inline Eigen::VectorXd flat(std::span<const Vec4> values);

/// What the cloth's solver found in its last solve, less the velocities that it started from.
inline Eigen::VectorXd velocity_change(const Cloth& cloth) {
    return flat(cloth.scratch_velocities.span()) - flat(cloth.state.velocities.span());
}

inline Eigen::VectorXd flat(std::span<const Vec4> values) {
    Eigen::VectorXd result(3 * static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        result.segment<3>(3 * static_cast<Eigen::Index>(i)) = xyz(values[i]).cast<double>();
    }
    return result;
}

/// W and b of a system in double precision, free particles only; rows of pinned ones are those of the
/// identity.
struct DenseSystem {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right_side;
};

/// What `apply(unit, column)` makes of unit vectors, for the free particles; the rest of a matrix is the
/// identity.
template <class Apply>
Eigen::MatrixXd matrix_of(const ImplicitSystem& system, const Apply& apply) {
    const std::size_t particles = system.right_side().size();
    const auto n = static_cast<Eigen::Index>(3 * particles);
    AlignedBuffer<Vec4> unit(particles), column(particles);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
    for (std::size_t i = 0; i < particles; ++i) {
        if (system.right_side()[i].w == 0) continue;
        for (int axis = 0; axis < 3; ++axis) {
            unit[i] = to_vec4(Vector3::Unit(axis), 0);
            apply(unit.span(), column.span());
            matrix.col(3 * static_cast<Eigen::Index>(i) + axis) = flat(column.span());
        }
        unit[i] = {};
    }
    return matrix;
}

/// Column by column, by multiplying: for systems of any kind.
inline DenseSystem dense(ImplicitSystem& system) {
    Parallel serial(1);
    return {matrix_of(system, [&](auto unit, auto column) { system.multiply(serial, unit, column); }),
            flat(system.right_side().span())};
}
/// As conjugate gradients see it: with what relaxation leaves out.
inline DenseSystem dense_coupled(ImplicitSystem& system) {
    Parallel serial(1);
    return {
        matrix_of(system, [&](auto unit, auto column) { system.multiply_coupled(serial, {}, unit, column); }),
        flat(system.right_side().span())};
}
/// D^-1, which relaxation multiplies by.
inline Eigen::MatrixXd dense_preconditioner(const ImplicitSystem& system) {
    Parallel serial(1);
    return matrix_of(system, [&](auto unit, auto column) { system.precondition(serial, unit, 1, column); });
}

}  // namespace weft::test
