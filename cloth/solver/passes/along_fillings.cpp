#include "cloth/solver/passes/along_fillings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cloth/equation/filling_row.h"
#include "cloth/equation/sparse/vectors.h"

namespace weft {

namespace {

FillingRow* filling_of(const PassMember& member) {
    return member.step.equation.external.filling;
}

}  // namespace

void linearise_filling(const PassMember& member, Parallel& threads) {
    const StepEquation& equation = member.step.equation;
    if (FillingRow* const filling = filling_of(member))
        filling->linearise(threads, member.step.model, equation.base_positions, equation.gamma,
                           member.step.velocities);
}

void find_response(std::span<const PassMember> members, const PassMember& member, const Vec4& frame,
                   bool has_change) {
    FillingRow* const filling = filling_of(member);
    if (filling == nullptr || !filling->has_slope()) return;
    Parallel& threads = member.step.parallel;
    for (const PassMember& sewn : members) {
        if (&sewn.levels != &member.levels) continue;
        PassVectors& of = sewn.vectors;  // their products are of the last pass
        std::ranges::fill(of.of_motion.span(), Vec4{});
        sewn.levels.set_vectors(sewn.part, std::as_const(of.of_motion).span(), of.correction.span());
    }
    member.levels.set_vectors(member.part, filling->gradient(), filling->response());
    member.levels.cycle(threads);
    filling->set_response(threads);
    filling->find_pressure(threads, member.system.right_side().span());
    PassVectors& of = member.vectors;
    write_motion(member, threads, frame);
    filling->relieve(threads, of.motion.span());
    if (has_change) filling->relieve(threads, of.change.span());
}

void relieve(const PassMember& member, Parallel& threads, std::span<Vec4> direction) {
    if (FillingRow* const filling = filling_of(member)) filling->relieve(threads, direction);
}

double multiply_filling(const PassMember& member, Parallel& threads, std::span<const Vec4> x,
                        std::span<Vec4> product) {
    FillingRow* const filling = filling_of(member);
    return filling != nullptr ? filling->multiply(threads, x, product) : 0;
}

// Newton's method along one direction.
void follow_filling(const PassMember& member, Parallel& threads) {
    constexpr int most = 4;
    constexpr double near = 1e-5;  // of the volume
    FillingRow* const filling = filling_of(member);
    if (filling == nullptr) return;
    PassVectors& of = member.vectors;
    for (int k = 0;; ++k) {
        linearise_filling(member, threads);
        const bool is_near = std::abs(filling->missing_volume()) <= near * filling->volume();
        if (!filling->keeps_volume() || is_near || k == most) return;
        const float by = filling->factor_to_volume();
        for (const std::span<Vec4> each : {member.step.velocities, of.motion.span(), of.change.span()})
            scale_and_add(threads, by, filling->response(), 1, each);
    }
}

}  // namespace weft
