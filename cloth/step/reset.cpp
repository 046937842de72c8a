// Puts a cloth into a given pose, at rest or in motion.

#include <algorithm>

#include "cloth/simulation/simulation.h"

namespace weft {

void Simulation::reset(Cloth& cloth, std::span<const Vec3> positions, StillPins pins) {
    ClothState& now = cloth.state;
    for (std::size_t v = 0; v < positions.size(); ++v)
        set_xyz(now.positions[cloth.model.vertex_to_particle[v]], to_vector(positions[v]));
    for (Pin& pin : now.pins)
        if (pins == StillPins::go_along)
            pin.target = xyz(now.positions[pin.particle]);
        else
            set_xyz(now.positions[pin.particle], pin.target);
    for (const Attachment& attached : cloth.attached) {
        const BodySlot* const body = state.bodies.find(attached.id);
        if (body != nullptr && now.positions[attached.particle].w > 0)
            set_xyz(now.positions[attached.particle], pose_of(body->state) * attached.own);
    }
    now.skin.stand_still();
    if (now.frame) *now.frame = {.pose = now.frame->target, .target = now.frame->target};
    cloth.stand_still();
    cloth.erase_contact_memory();
    std::ranges::fill(now.tangles.span(), TangleMemory{});
    now.halved = 0;
    cloth.wake();
    update_normals(parallel, cloth);
    cloth.extent = survey(parallel, now, cloth.partial_surveys.span());
}

void Simulation::resume(Cloth& cloth, std::span<const Vec3> positions,
                        std::span<const Vec3> previous_positions, std::span<const Vec3> velocities,
                        StillPins pins) {
    reset(cloth, positions, pins);
    ClothState& now = cloth.state;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const std::uint32_t i = cloth.model.vertex_to_particle[v];
        set_xyz(now.previous_positions[i], to_vector(previous_positions[v]));
        if (now.positions[i].w > 0) set_xyz(now.velocities[i], to_vector(velocities[v]));
    }
    for (const Attachment& attached : cloth.attached)
        set_xyz(now.velocities[attached.particle], Vector3::Zero());
    cloth.extent = survey(parallel, now, cloth.partial_surveys.span());
}

}  // namespace weft
