#include "cloth/solver/step_residual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cloth/equation/contacts.h"
#include "cloth/fabric/springs/membrane.h"
#include "cloth/fabric/springs/springs.h"

namespace weft {

namespace {

constexpr std::uint64_t particles_per_sample = 1024, fewest_samples = 4;

/// Sums of squares over particles, divided by their diagonals [m^2/s^2].
struct Left {
    double now = 0;     ///< of the residual at v
    double free = 0;    ///< of the residual at v_free
    double driven = 0;  ///< of M (v_free - v_base)

    [[nodiscard]] float ratio() const {
        const double whole = std::max(free, driven);
        return whole > 0 ? static_cast<float>(std::sqrt(now / whole)) : 0.0f;
    }
    void add(const Vector3& left_now, const Vector3& left_free, const Vector3& drive, float diagonal) {
        const auto squared = [&](const Vector3& impulse) {
            return static_cast<double>((impulse / diagonal).squaredNorm());
        };
        now += squared(left_now);
        free += squared(left_free);
        driven += squared(drive);
    }
};

/// The impulses gamma f of the fabric on particles, at velocities of which velocity(j) is that of j.
template <class Velocity>
class Pulls {
  public:
    Pulls(const ClothModel& model, const StepEquation& equation, const Velocity& velocity)
        : model_(model), equation_(equation), fabric_(equation.settings.fabric), velocity_(velocity) {}

    [[nodiscard]] Vector3 bending(std::uint32_t i, std::uint32_t e) const {
        const std::uint32_t j = model_.neighbours[e];
        const float weight = equation_.gamma * equation_.rigidity * model_.bending[e];
        return weight * (apart(i, j) + fabric_.damping * (velocity_(j) - velocity_(i)));
    }
    [[nodiscard]] Vector3 spring(std::uint32_t i, std::uint32_t e, float stiffness, float stiffening) const {
        const std::uint32_t j = model_.neighbours[e];
        float rest_length = model_.rest_lengths[e];
        if (stiffening > 0) {
            const LinearSpring at =
                spring_at(static_cast<double>(apart(i, j).norm()), static_cast<double>(rest_length),
                          static_cast<double>(stiffness), static_cast<double>(stiffening));
            rest_length = static_cast<float>(at.rest_length);
            stiffness = static_cast<float>(at.stiffness);
        }
        const SpringTerms spring = spring_terms(apart(i, j), rest_length, stiffness, i, j);
        return equation_.gamma * (spring.force + viscous(i, j, stiffness, spring.direction));
    }
    /// The impulse of a triangle on its corner k.
    [[nodiscard]] Vector3 triangle(std::uint32_t t, std::size_t k, const TriangleMembrane& membrane) const {
        const Triangle& corners = model_.triangles[t];
        std::array<Vector3, 3> sides;
        std::array<double, 3> extensions{};
        for (std::size_t m = 0; m < 3; ++m) {
            sides[m] = apart(corners[m], corners[(m + 1) % 3]);
            extensions[m] = static_cast<double>(sides[m].norm()) - membrane.rest_lengths[m];
        }
        TriangleStiffening::Extra extra{};
        if (fabric_.stiffening > 0) extra = triangle_stiffening(model_, t, fabric_).at(extensions);
        Vector3 force = Vector3::Zero();
        const std::size_t behind = (k + 2) % 3;
        for (const auto& [side, sign] : {std::pair(k, 1.0f), std::pair(behind, -1.0f)}) {
            double tension = membrane.own[side] * extensions[side] + extra.tension[side];
            for (std::size_t m = 0; m < 3; ++m) tension += membrane.shared[side][m] * extensions[m];
            const Vector3 n = sign * sides[side].normalized();
            const std::uint32_t other = corners[sign > 0 ? (k + 1) % 3 : behind];
            force += static_cast<float>(tension) * n +
                     viscous(corners[k], other, static_cast<float>(membrane.own[side] + extra.own[side]), n);
        }
        return equation_.gamma * force;
    }

  private:
    [[nodiscard]] Vector3 apart(std::uint32_t i, std::uint32_t j) const {
        return (xyz(equation_.base_positions[j]) - xyz(equation_.base_positions[i])) +
               equation_.gamma * (velocity_(j) - velocity_(i));
    }
    [[nodiscard]] Vector3 viscous(std::uint32_t i, std::uint32_t j, float stiffness, const Vector3& n) const {
        return fabric_.damping * stiffness * n.dot(velocity_(j) - velocity_(i)) * n;
    }

    const ClothModel& model_;
    const StepEquation& equation_;
    const Fabric& fabric_;
    const Velocity& velocity_;
};

/// Stiffnesses of one particle's springs in a sheet, in its row's order [N/m]: at most 12 half-edges.
struct SpringsOfParticle {
    std::array<float, 12> stiffness{}, stiffening{};
};
SpringsOfParticle springs_at(const ClothModel& model, const Fabric& fabric, std::uint32_t i) {
    SpringsOfParticle result;
    const SheetModuli moduli = sheet_moduli(fabric);
    const std::uint32_t row = i / model.columns, column = i % model.columns;
    for (std::uint32_t r = row - std::min(row, 1u); r <= row && r + 1 < model.rows; ++r) {
        for (std::uint32_t c = column - std::min(column, 1u); c <= column && c + 1 < model.columns; ++c) {
            const auto add = [&](std::array<float, 12>& to, std::uint32_t a, std::uint32_t b, double part) {
                if (a != i && b != i) return;
                const std::uint32_t e = half_edge_between(model, i, a == i ? b : a);
                to[e - model.spring_offsets[i]] += static_cast<float>(part);
            };
            for_each_part_of_cell(
                model, moduli, r * model.columns + c,
                [&](std::uint32_t a, std::uint32_t b, double k) { add(result.stiffness, a, b, k); });
            if (fabric.stiffening > 0)
                for_each_stiffening_of_cell(
                    model, fabric, r * model.columns + c,
                    [&](std::uint32_t a, std::uint32_t b, double q) { add(result.stiffening, a, b, q); });
        }
    }
    for (float& stiffness : result.stiffness) stiffness = std::max(stiffness, 0.0f);
    return result;
}

Vector3 drive_of(const StepEquation& equation, const ExternalRow& external, std::uint32_t i) {
    return external.row_sum * (external.free_velocity - xyz(equation.base_velocities[i]));
}

void add_springs(const ClothModel& model, const StepEquation& equation, std::span<const Vec4> velocities,
                 std::uint32_t i, Left& sum) {
    const ExternalRow external = external_row(equation, i);
    if (external.row_sum == 0) return;
    const Fabric& fabric = equation.settings.fabric;
    const float per_stiffness = equation.gamma * (equation.gamma + fabric.damping);
    const auto velocity = [&](std::uint32_t j) -> Vector3 { return xyz(velocities[j]); };
    const auto free_velocity = [&](std::uint32_t j) {
        return j == i ? external.free_velocity : external_row(equation, j).free_velocity;
    };
    const Pulls pulls_now(model, equation, velocity);
    const Pulls pulls_free(model, equation, free_velocity);
    Vector3 now = external.row_sum * (external.free_velocity - velocity(i)), free = Vector3::Zero();
    float stiffness = 0;
    for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
        now += pulls_now.bending(i, e);
        free += pulls_free.bending(i, e);
        stiffness += equation.rigidity * std::max(model.bending[e], 0.0f);
    }
    if (model.rows > 0) {
        const SpringsOfParticle springs = springs_at(model, fabric, i);
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const float k = springs.stiffness[e - model.spring_offsets[i]];
            const float q = springs.stiffening[e - model.spring_offsets[i]];
            if (k == 0 && q == 0) continue;
            now += pulls_now.spring(i, e, k, q);
            free += pulls_free.spring(i, e, k, q);
            stiffness += k;
        }
    } else {
        for (std::uint32_t c = model.corner_offsets[i]; c < model.corner_offsets[i + 1]; ++c) {
            const std::uint32_t t = model.corner_triangles[c];
            const auto k = static_cast<std::size_t>(std::ranges::find(model.triangles[t], i) -
                                                    model.triangles[t].begin());
            const TriangleMembrane membrane = triangle_membrane(model, t, fabric);
            now += pulls_now.triangle(t, k, membrane);
            free += pulls_free.triangle(t, k, membrane);
            stiffness += static_cast<float>(membrane.own[k] + membrane.own[(k + 2) % 3]);
        }
    }
    float diagonal = external.row_sum + per_stiffness * stiffness;
    if (equation.contacts != nullptr && equation.contacts->rows().touches(i)) {
        const ContactRows& rows = equation.contacts->rows();
        const Symmetric3 block = rows.block(i);
        now += xyz(rows.impulses[i]) - block * velocity(i);
        free += xyz(rows.impulses[i]) - block * external.free_velocity;
        diagonal += (block.xx + block.yy + block.zz) / 3;
    }
    sum.add(now, free, drive_of(equation, external, i), diagonal);
}

}  // namespace

float StepResidual::operator()(Parallel& parallel, const StepEquation& equation,
                               std::span<const Vec4> velocities, ImplicitSystem* system) {
    if (system != nullptr && of_elements_) return measure_elements(parallel, equation, velocities, *system);
    const std::uint64_t n = model_->particle_count;
    const std::uint64_t samples = std::min(n, std::max(fewest_samples, n / particles_per_sample));
    Left sum;
    for (std::uint64_t s = 0; s < samples; ++s) {
        const auto i = static_cast<std::uint32_t>((2 * s + 1) * n / (2 * samples));
        add_springs(*model_, equation, velocities, i, sum);
    }
    return sum.ratio();
}

float StepResidual::measure_elements(Parallel& parallel, const StepEquation& equation,
                                     std::span<const Vec4> velocities, ImplicitSystem& system) {
    const Fabric& fabric = equation.settings.fabric;
    const float stiffness =
        equation.gamma * (equation.gamma + fabric.damping) * (fabric.warp + fabric.weft + fabric.shear);
    Left sum;
    for (std::uint32_t i = 0; i < free_.size(); ++i)
        free_[i] = to_vec4(external_row(equation, i).free_velocity, 0);
    system.residual(parallel, equation, free_.span(), left_.span());
    const auto add = [&](bool is_free) {
        for (std::uint32_t i = 0; i < free_.size(); ++i) {
            const ExternalRow external = external_row(equation, i);
            if (external.row_sum == 0) continue;
            const Vector3 none = Vector3::Zero(), left = xyz(left_[i]);
            const Vector3 drive = drive_of(equation, external, i);
            sum.add(is_free ? none : left, is_free ? left : none, is_free ? drive : none,
                    external.row_sum + stiffness);
        }
    };
    add(true);
    system.residual(parallel, equation, velocities, left_.span());
    add(false);
    return sum.ratio();
}

}  // namespace weft
