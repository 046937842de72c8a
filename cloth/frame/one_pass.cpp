// Stiff cloth on a coarse mesh, into which the passes of the multilevel method put energy.

#include <algorithm>
#include <utility>

#include "cloth/frame/simulation.h"
#include "cloth/system/sparse/vectors.h"

namespace weft {

namespace {

/// What the air that blows at it gives it [W]; drag takes.
double power_of_air(Parallel& parallel, Cloth& cloth) {
    return dot(parallel, std::as_const(cloth.air.forces).span(), std::as_const(cloth.state.velocities).span(),
               cloth.partial_sums.span());
}

}  // namespace

bool Simulation::is_in_one_pass(const Cloth& cloth) {
    const auto touches = [](std::uint32_t group) { return group != 0; };
    return cloth.state.unsolved > ClothState::unsolved_patience &&
           std::ranges::none_of(cloth.state.held.touching.span(), touches);
}

// It would whip to and fro for ever, where one linearisation lets it come to rest. What wind or a host drives
// is nearer to the truth by passes, and some of them get over what is hard for a moment. Were the two to
// take turns step by step, small pieces would tremble.
void Simulation::count_unsolved(Parallel& parallel, Cloth& cloth, float h, bool unsolved) {
    constexpr float patience = ClothState::unsolved_patience, driven = 4;
    float& time = cloth.state.unsolved;
    if (time > patience)
        time -= h;
    else if (!unsolved || is_moved_by_host(cloth) || power_of_air(parallel, cloth) > 0)
        time = std::max(0.0f, time - (unsolved ? driven : 1) * h);
    else if ((time += h) > patience)
        time = patience + ClothState::one_pass_lasts;
}

}  // namespace weft
