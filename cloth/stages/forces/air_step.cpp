// The air's part of a step.

#include <utility>

#include "cloth/air/air_sources.h"
#include "cloth/air/gusts.h"
#include "cloth/air/shelters.h"
#include "cloth/stages/forces/air_step.h"

namespace weft {

void feel_wind(Simulation& world, Worker& worker, Cloth& cloth) {
    if (cloth.air.velocities.size() == 0) return;
    const auto timer = world.timed(Stage::wind);
    world.find_air(worker.parallel, std::as_const(cloth.state.positions).span(), cloth.air.velocities.span());
    const float scale = cloth.settings.wind_scale;
    if (scale == 1) return;
    worker.parallel.ranges(cloth.model.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            set_xyz(cloth.air.velocities[i], scale * xyz(cloth.air.velocities[i]));
    });
}

void Simulation::find_air(Parallel& threads, std::span<const Vec4> points, std::span<Vec4> velocities) const {
    WindField(settings.wind, state.wind_path, state.time).sample(threads, points, velocities);
    if (has_shelters(settings.wind)) shelter_air(threads, settings.wind, points, velocities);
    if (has_sources(settings.wind)) add_air_of_sources(threads, settings.wind, points, velocities);
}

AirForce air_force(const Simulation& world, Cloth& cloth) {
    return {.surface = world.air_is_on() ? &cloth.surface : nullptr,
            .cloth = {.wind = &world.settings.wind,
                      .wind_scale = cloth.settings.wind_scale,
                      .drag_scale = cloth.settings.drag_scale,
                      .lift_scale = cloth.settings.lift_scale,
                      .air_velocities = std::as_const(cloth.air.velocities).span(),
                      .positions = std::as_const(cloth.state.positions).span(),
                      .velocities = {},
                      .from_velocities = std::as_const(cloth.state.velocities).span()},
            .forces = cloth.air.forces.span()};
}

void find_air_forces(Simulation& world, Worker& worker, Cloth& cloth, bool keeps_normals) {
    const auto timer = world.timed(Stage::wind);
    const AirForce air = air_force(world, cloth);
    air.linearise(worker.parallel, air.cloth.from_velocities, keeps_normals);
}

}  // namespace weft
