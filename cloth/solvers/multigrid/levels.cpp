#include "cloth/solvers/multigrid/levels.h"

namespace weft {

std::unique_ptr<Multigrid> make_levels(const ClothModel& model, ImplicitSystem& system) {
    Parallel serial(1);
    const ClothSettings settings;
    const AlignedBuffer<Vec4> at_rest(model.particle_count);
    AlignedBuffer<Vec4> free(model.particle_count);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const float mass = settings.fabric.areal_density * model.rest_area[i];
        free[i] = to_vec4(xyz(model.positions[i]), mass > 0 ? 1.0f / mass : 0.0f);
    }
    const StepEquation equation{.settings = settings,
                                .h = 1.0f / 60,
                                .gamma = 1.0f / 60,
                                .positions = free.span(),
                                .velocities = at_rest.span(),
                                .base_positions = free.span(),
                                .base_velocities = at_rest.span(),
                                .external = {}};
    system.linearise(serial, equation, at_rest.span(), LinearisedAbout::base);
    return std::make_unique<Multigrid>(serial, system, free.span());
}

}  // namespace weft
