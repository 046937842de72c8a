// Moves the World's origin.

#include "cloth/simulation/simulation.h"

namespace weft {

namespace {

void shift(std::span<Vec4> points, const Vector3& to) {
    for (Vec4& point : points) set_xyz(point, xyz(point) - to);
}
void shift(Vec3& point, const Vector3& to) {
    point = to_vec3(to_vector(point) - to);
}

void shift(ClothState& state, const Vector3& to) {
    for (AlignedBuffer<Vec4>* points : {&state.positions, &state.previous_positions, &state.record.arrivals,
                                        &state.ahead, &state.skin.places, &state.skin.target_places})
        shift(points->span(), to);
    for (Pin& pin : state.pins) pin.target -= to;
    if (!state.frame) return;
    shift(state.frame->pose.translation, to);
    shift(state.frame->target.translation, to);
}

}  // namespace

// The path of the wind is shifted, too: so gusts stay where they are.
void Simulation::shift_origin(const Vec3& to) {
    const Vector3 by = to_vector(to);
    const RigidMotion motion{.shift = -by.cast<double>()};
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        shift(cloth->state, by);
        cloth->surface.forget();  // positions round differently, so normals change
        cloth->state.may_cross = cloth->has_features() ? 1 : 0;
        cloth->extent = survey(parallel, cloth->state, cloth->partial_surveys.span());
    });
    state.colliders.for_each([&](ColliderId, ColliderSlot& slot) {
        slot.current = moved(slot.current, motion);
        slot.target = moved(slot.target, motion);
    });
    state.bodies.for_each([&](BodyId, BodySlot& slot) { shift(slot.state.position, by); });
    for (AirSource& source : settings.wind.sources)
        if (source.kind != AirSourceKind::none) shift(source.position, by);
    for (AirShelter& shelter : settings.wind.shelters)
        if (shelter.kind != AirShelterKind::none) shift(shelter.position, by);
    place_carried_colliders();
    state.wind_path[0] -= static_cast<double>(to.x);
    state.wind_path[1] -= static_cast<double>(to.y);
    state.wind_path[2] -= static_cast<double>(to.z);
}

}  // namespace weft
