#include "cloth/solvers/step_residual.h"

#include <algorithm>
#include <cmath>

#include "cloth/system/contacts.h"
#include "cloth/system/springs/springs.h"

namespace weft {

namespace {

constexpr std::uint64_t particles_per_sample = 1024, fewest_samples = 4;

/// What acts on one particle besides fabric and contacts.
struct External {
    Vector3 free_velocity;  ///< once external forces alone have acted, drag taken implicitly
    float row_sum;          ///< mass and drag [kg]
};

External external_at(const StepEquation& equation, std::uint32_t i) {
    const ExternalForces& forces = equation.external;
    const float w = equation.base_positions[i].w;
    const Vector3 v = xyz(equation.velocities[i]);
    if (w == 0) return {v, 0};
    const Vec4 air = forces.air.empty() ? Vec4{} : forces.air[i];
    const float mass = 1 / w, gamma = equation.gamma;
    const float row_sum = mass * (1 + gamma * forces.air_damping) + gamma * air.w;
    const Vector3 impulse =
        mass * (xyz(equation.base_velocities[i]) + gamma * forces.gravity) + gamma * (xyz(air) + air.w * v);
    return {impulse / row_sum, row_sum};
}

/// Sums of squares over particles, divided by their diagonals [m^2/s^2].
struct Left {
    double now = 0;     ///< of what v leaves
    double free = 0;    ///< of what v_free leaves
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

/// The impulse gamma f of the spring from i to j on i.
Vector3 pull(const StepEquation& equation, std::uint32_t i, std::uint32_t j, float rest_length,
             float stiffness, const Vector3& v_i, const Vector3& v_j) {
    const Vector3 v = v_j - v_i;
    const Vector3 separation =
        (xyz(equation.base_positions[j]) - xyz(equation.base_positions[i])) + equation.gamma * v;
    const SpringTerms spring = spring_terms(separation, rest_length, stiffness, i, j);
    const float viscous = equation.settings.fabric.damping * stiffness * spring.direction.dot(v);
    return equation.gamma * (spring.force + viscous * spring.direction);
}

Vector3 drive_of(const StepEquation& equation, const External& external, std::uint32_t i) {
    return external.row_sum * (external.free_velocity - xyz(equation.base_velocities[i]));
}

void add_springs(const CookedCloth& model, const StepEquation& equation, std::span<const Vec4> velocities,
                 std::uint32_t i, Left& sum) {
    const External external = external_at(equation, i);
    if (external.row_sum == 0) return;
    const Fabric& fabric = equation.settings.fabric;
    const std::array<float, 3> stiffness_of = stiffnesses(fabric);
    const float per_stiffness = equation.gamma * (equation.gamma + fabric.damping);
    const Vector3 v = xyz(velocities[i]);
    Vector3 now = external.row_sum * (external.free_velocity - v), free = Vector3::Zero();
    float diagonal = external.row_sum;
    for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
        const std::uint32_t j = model.neighbours[e];
        const float stiffness = stiffness_of[static_cast<std::size_t>(model.kinds[e])];
        const float rest_length = model.rest_lengths[e];
        now += pull(equation, i, j, rest_length, stiffness, v, xyz(velocities[j]));
        free += pull(equation, i, j, rest_length, stiffness, external.free_velocity,
                     external_at(equation, j).free_velocity);
        diagonal += per_stiffness * stiffness;
    }
    if (equation.contacts != nullptr && equation.contacts->rows().touches(i)) {
        const ContactRows& rows = equation.contacts->rows();
        const Symmetric3 block = rows.block(i);
        now += xyz(rows.impulses[i]) - block * v;
        free += xyz(rows.impulses[i]) - block * external.free_velocity;
        diagonal += (block.xx + block.yy + block.zz) / 3;
    }
    sum.add(now, free, drive_of(equation, external, i), diagonal);
}

}  // namespace

StepResidual::StepResidual(const CookedCloth& model, const ClothSettings& settings) : model_(model) {
    if (!settings.finite_elements.enabled) return;
    free_ = AlignedBuffer<Vec4>(model.particle_count);
    left_ = AlignedBuffer<Vec4>(model.particle_count);
}

float StepResidual::operator()(Parallel& parallel, const StepEquation& equation,
                               std::span<const Vec4> velocities, ImplicitSystem* system) {
    if (system != nullptr && left_.size() > 0) return of_elements(parallel, equation, velocities, *system);
    const std::uint64_t n = model_.particle_count;
    const std::uint64_t samples = std::min(n, std::max(fewest_samples, n / particles_per_sample));
    Left sum;
    for (std::uint64_t s = 0; s < samples; ++s) {
        const auto i = static_cast<std::uint32_t>((2 * s + 1) * n / (2 * samples));
        add_springs(model_, equation, velocities, i, sum);
    }
    return sum.ratio();
}

float StepResidual::of_elements(Parallel& parallel, const StepEquation& equation,
                                std::span<const Vec4> velocities, ImplicitSystem& system) {
    const FiniteElements& moduli = equation.settings.finite_elements;
    const float stiffness = equation.gamma * (equation.gamma + equation.settings.fabric.damping) *
                            (moduli.warp + moduli.weft + moduli.shear);
    Left sum;
    for (std::uint32_t i = 0; i < free_.size(); ++i)
        free_[i] = to_vec4(external_at(equation, i).free_velocity, 0);
    system.residual(parallel, equation, free_.span(), left_.span());
    const auto add = [&](bool is_free) {
        for (std::uint32_t i = 0; i < free_.size(); ++i) {
            const External external = external_at(equation, i);
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
