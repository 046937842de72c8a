// The air's part of a step.

#include "cloth/frame/simulation.h"
#include "cloth/surface/gusts.h"

namespace weft {

void Simulation::feel_wind(Worker& worker, Cloth& cloth) {
    if (cloth.air.velocities.size() == 0) return;
    const auto timer = timed(Stage::wind);
    WindField(settings.wind, state.wind_path, state.time)
        .sample(worker.parallel, cloth.state.positions.span(), cloth.air.velocities.span());
}

void Simulation::air_forces(Worker& worker, Cloth& cloth, bool has_moved) {
    const auto timer = timed(Stage::wind);
    cloth.surface.compute_air_forces(worker.parallel,
                                     {.wind = settings.wind,
                                      .positions = cloth.state.positions.span(),
                                      .velocities = cloth.state.velocities.span(),
                                      .air_velocities = cloth.air.velocities.span(),
                                      .has_moved = has_moved},
                                     cloth.air.forces.span());
}

}  // namespace weft
