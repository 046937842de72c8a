// Stiff cloth on a coarse mesh, into which the passes of the multilevel method put energy.

#include <algorithm>

#include "cloth/frame/simulation.h"
#include "engine/vector.h"

namespace weft {

namespace {

/// What the air that blows at it gives it [W]; drag takes.
double power_of_air(const Cloth& cloth) {
    double power = 0;
    const auto forces = std::as_const(cloth.air.forces).span();
    for (std::size_t i = 0; i < forces.size(); ++i)
        power += static_cast<double>(xyz(forces[i]).dot(xyz(cloth.state.velocities[i])));
    return power;
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
void Simulation::count_unsolved(Cloth& cloth, float h, bool unsolved) {
    constexpr float patience = ClothState::unsolved_patience, driven = 4;
    float& time = cloth.state.unsolved;
    if (time > patience)
        time -= h;
    else if (!unsolved || power_of_air(cloth) > 0 || is_moved_by_host(cloth))
        time = std::max(0.0f, time - (unsolved ? driven : 1) * h);
    else if ((time += h) > patience)
        time = patience + ClothState::in_one_pass;
}

}  // namespace weft
