// The air's part of a step.

#include <utility>

#include "cloth/air/air_sources.h"
#include "cloth/air/gusts.h"
#include "cloth/stages/air_step.h"

namespace weft {

void feel_wind(Simulation& world, Worker& worker, Cloth& cloth) {
    if (cloth.air.velocities.size() == 0) return;
    const auto timer = world.timed(Stage::wind);
    world.find_air(worker.parallel, std::as_const(cloth.state.positions).span(), cloth.air.velocities.span());
}

void Simulation::find_air(Parallel& threads, std::span<const Vec4> points, std::span<Vec4> velocities) const {
    WindField(settings.wind, state.wind_path, state.time).sample(threads, points, velocities);
    if (has_sources(settings.wind)) add_air_of_sources(threads, settings.wind, points, velocities);
}

void air_forces(Simulation& world, Worker& worker, Cloth& cloth, bool has_moved) {
    const auto timer = world.timed(Stage::wind);
    cloth.surface.compute_air_forces(worker.parallel,
                                     {.wind = world.settings.wind,
                                      .positions = cloth.state.positions.span(),
                                      .velocities = cloth.state.velocities.span(),
                                      .air_velocities = cloth.air.velocities.span(),
                                      .has_moved = has_moved},
                                     cloth.air.forces.span());
}

}  // namespace weft
