// The World's calls for cloth that is worn, and that is moved as a whole.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "cloth/mesh/cooking/vertex_maps.h"
#include "cloth/mesh/coordinates.h"
#include "cloth/record/world_calls.h"
#include "cloth/settings/validate.h"
#include "engine/error_text.h"

namespace weft {

namespace {

constexpr float unlimited = std::numeric_limits<float>::infinity();

}  // namespace

Result<void> validate_move(const Cloth& cloth, const RigidMotion& by) {
    const std::span<const std::uint32_t> particles = cloth.model.vertex_to_particle;
    for (std::size_t v = 0; v < particles.size(); ++v) {
        const Vec3 there = to_vec3(by.point(xyz(cloth.state.positions[particles[v]])));
        if (!is_within_reach(there))
            return validate_point(("vertex " + std::to_string(v) + " once moved").c_str(), there);
    }
    for (const Pin& pin : cloth.state.pins)
        if (auto valid = validate_point("a pin's target once moved", to_vec3(by.point(pin.target))); !valid)
            return valid;
    if (!cloth.state.frame) return {};
    return validate_point("the cloth's frame once moved", by.point(cloth.state.frame->target.translation));
}

namespace {

VertexMap description_of(Map map, std::span<const float> values) {
    constexpr auto least = WhereWelded::least, greatest = WhereWelded::greatest, mean = WhereWelded::mean;
    switch (map) {
        case Map::mass:
            return {"Map::mass", values, 0.01f, 100, 1, mean};
        case Map::pin:
            return {"Map::pin", values, 0, 1, 0, greatest};
        case Map::leash:
            return {"Map::leash", values, 0, unlimited, unlimited, least};
        case Map::backstop:
            return {"Map::backstop", values, -10, unlimited, unlimited, least};
        case Map::backstop_radius:
            return {"Map::backstop_radius", values, 1e-3f, unlimited, unlimited, greatest};
        case Map::friction:
            return {"Map::friction", values, 0, 1000, 1, mean};
        case Map::thickness:
            return {"Map::thickness", values, 0, 1, 1, greatest};
        case Map::stiffness:
            return {"Map::stiffness", values, 1e-3f, 1e3f, 1, mean};
        case Map::collider_mask:
            return {"Map::collider_mask", values, 0, most_collider_mask, 0, WhereWelded::any_bit};
    }
    return {};
}

/// Error: a backstop begins farther in front of the skin than the leash is long.
Result<void> validate_limits(const Cloth& cloth, std::span<const float> leash,
                             std::span<const float> backstop) {
    if (leash.empty() || backstop.empty()) return {};
    const std::span<const std::uint32_t> particles = cloth.model.vertex_to_particle;
    for (std::size_t v = 0; v < particles.size(); ++v) {
        const float least = -leash[particles[v]], offset = backstop[particles[v]];
        if (!(offset >= least))
            return out_of_range("the backstop of vertex " + std::to_string(v), static_cast<double>(offset),
                                "no less than minus its leash, " + number_text(static_cast<double>(least)));
    }
    return {};
}

Result<void> set_pins(Cloth& cloth, std::span<const float> values) {
    std::vector<std::uint32_t> pinned;
    for (std::uint32_t i = 0; i < values.size(); ++i)
        if (values[i] >= 0.5f) pinned.push_back(i);
    cloth.pin_only(pinned);
    return {};
}

/// Checks a step's skin, vertex by vertex.
Result<void> validate_skin(const Cloth& cloth, std::span<const Vec3> places, std::span<const Vec3> normals) {
    const std::size_t vertices = cloth.model.vertex_to_particle.size();
    const bool has_backstop = cloth.worn.backstop.size() > 0;
    if (!cloth.worn.has_limits())
        return Error{ErrorCode::invalid_argument,
                     "the cloth has no leashes and no backstops; set Map::leash or Map::backstop first"};
    if (places.size() != vertices || (normals.size() != vertices && (has_backstop || !normals.empty())))
        return Error{ErrorCode::invalid_argument,
                     std::to_string(places.size()) + " places and " + std::to_string(normals.size()) +
                         " normals; the mesh has " + std::to_string(vertices) + " vertices: give as many"};
    for (std::size_t v = 0; v < vertices; ++v) {
        if (!is_within_reach(places[v]))
            return validate_point(("the place of vertex " + std::to_string(v)).c_str(), places[v]);
        if (normals.empty()) continue;
        const float squared = to_vector(normals[v]).squaredNorm();
        if (!(squared > 1e-24f && squared < 1e24f))
            return out_of_range("the normal of vertex " + std::to_string(v), normals[v],
                                "of a length from 1e-12 to 1e12");
    }
    return {};
}

/// Checks a pose to be reset to, vertex by vertex.
Result<void> validate_pose(const Cloth& cloth, std::span<const Vec3> values, const char* all = "positions",
                           const char* one = "position") {
    const std::size_t vertices = cloth.model.vertex_to_particle.size();
    if (values.size() != vertices)
        return Error{ErrorCode::invalid_argument, std::to_string(values.size()) + " " + all +
                                                      "; the mesh has " + std::to_string(vertices) +
                                                      " vertices: give as many"};
    for (std::size_t v = 0; v < vertices; ++v)
        if (!is_within_reach(values[v]))
            return validate_point((std::string("the ") + one + " of vertex " + std::to_string(v)).c_str(),
                                  values[v]);
    return {};
}

void take_skin(SkinState& skin, std::span<const std::uint32_t> particles, std::span<const Vec3> places,
               std::span<const Vec3> normals) noexcept {
    const bool has_normals = skin.target_normals.size() > 0;
    for (std::size_t v = 0; v < particles.size(); ++v) {
        skin.target_places[particles[v]] = to_vec4(to_vector(places[v]), 0);
        if (has_normals) skin.target_normals[particles[v]] = to_vec4(to_vector(normals[v]).normalized(), 0);
    }
    if (std::exchange(skin.known, 1u) == 0) skin.stand_still();
}

/// Sets the first skin of a cloth that is stepped, and teleports the cloth to where it is worn.
Result<void> take_first_skin(Simulation& simulation, Cloth& cloth, std::span<const Vec3> places,
                             std::span<const Vec3> normals) {
    SkinState skin = cloth.state.skin;
    take_skin(skin, cloth.model.vertex_to_particle, places, normals);
    const auto motion = simulation.motion_to_holds(cloth, skin, StillPins::go_along);
    if (!motion) return motion.error();
    take_skin(cloth.state.skin, cloth.model.vertex_to_particle, places, normals);
    cloth.wake();  // its leashes and backstops hold from here on
    if (!*motion) return {};
    simulation.wake_near(cloth);
    simulation.parallel.lend([&] { simulation.go_to_holds(cloth, **motion, StillPins::go_along); });
    return {};
}

}  // namespace

Result<void> World::move_cloth(ClothId id, const Transform& by) {
    return impl_->change(Call::move_cloth, id, by)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (auto valid = validate_transform("by", by); !valid) return valid;
            const RigidMotion motion = rigid_motion(by);
            if (auto valid = validate_move(cloth, motion); !valid) return valid;
            impl_->simulation.wake_near(cloth);
            impl_->simulation.parallel.lend([&] { impl_->simulation.move(cloth, motion); });
            cloth.wake();
            cloth.land();
            return {};
        });
    });
}

Result<void> World::reset_cloth(ClothId id, std::span<const Vec3> positions) {
    return impl_->change(Call::reset_cloth, id, positions)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (auto valid = validate_pose(cloth, positions); !valid) return valid;
            impl_->simulation.wake_near(cloth);
            impl_->simulation.parallel.lend([&] { impl_->simulation.reset(cloth, positions); });
            return {};
        });
    });
}

Result<void> World::resume_cloth(ClothId id, std::span<const Vec3> positions,
                                 std::span<const Vec3> previous_positions, std::span<const Vec3> velocities) {
    return impl_->change(Call::resume_cloth, id, positions, previous_positions, velocities)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (auto valid = validate_pose(cloth, positions); !valid) return valid;
            if (auto valid =
                    validate_pose(cloth, previous_positions, "previous positions", "previous position");
                !valid)
                return valid;
            if (auto valid = validate_pose(cloth, velocities, "velocities", "velocity"); !valid) return valid;
            impl_->simulation.wake_near(cloth);
            impl_->simulation.parallel.lend(
                [&] { impl_->simulation.resume(cloth, positions, previous_positions, velocities); });
            return {};
        });
    });
}

Result<void> World::set_frame(ClothId id, const Transform& pose) {
    return impl_->change(Call::set_frame, id, pose)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (auto valid = validate_transform("pose", pose); !valid) return valid;
            if (auto valid = validate_point("pose.translation", pose.translation); !valid) return valid;
            impl_->simulation.set_frame(cloth, {pose.translation, normalized(pose.rotation)});
            return {};
        });
    });
}

Result<void> World::leave_frame(ClothId id) {
    return impl_->change(Call::leave_frame, id)([&] {
        return with_cloth(impl_->simulation, id, [](Cloth& cloth) -> Result<void> {
            cloth.state.frame.reset();
            return {};
        });
    });
}

Result<void> World::set_map(ClothId id, Map map, std::span<const float> values) {
    return impl_->change(Call::set_map, id, map, values)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            const VertexMap described = description_of(map, values);
            if (described.name[0] == 0)
                return out_of_range("map", static_cast<double>(map), "one of Map's values");
            if ((map == Map::mass || map == Map::stiffness) && !values.empty())
                if (auto valid = validate_for_maps(cloth.settings); !valid) return valid;
            AlignedBuffer<float> of_particles;
            if (!values.empty()) {
                auto remapped =
                    remap_to_particles(described, cloth.model.vertex_to_particle, cloth.model.particle_count);
                if (!remapped) return remapped.error();
                of_particles = std::move(remapped).value();
            }
            if (map == Map::pin) return set_pins(cloth, of_particles.span());
            const WornLimits& worn = cloth.worn;
            auto valid = validate_limits(
                cloth, map == Map::leash ? std::as_const(of_particles).span() : worn.leash.span(),
                map == Map::backstop ? std::as_const(of_particles).span() : worn.backstop.span());
            if (!valid) return valid;
            impl_->simulation.set_map(cloth, map, std::move(of_particles));
            cloth.wake();
            return {};
        });
    });
}

Result<void> World::set_skin(ClothId id, std::span<const Vec3> places, std::span<const Vec3> normals) {
    return impl_->change(Call::set_skin, id, places, normals)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (auto valid = validate_skin(cloth, places, normals); !valid) return valid;
            if (cloth.state.skin.known == 0 && cloth.settings.enabled)
                return take_first_skin(impl_->simulation, cloth, places, normals);
            take_skin(cloth.state.skin, cloth.model.vertex_to_particle, places, normals);
            return {};
        });
    });
}

Result<void> World::shift_origin(const Vec3& to) {
    return impl_->change(Call::shift_origin, to)([&]() -> Result<void> {
        Simulation& simulation = impl_->simulation;
        if (!is_finite(to)) return out_of_range("to", to, "finite");
        const RigidMotion motion{.shift = -to_vector(to).cast<double>()};
        Result<void> valid;
        simulation.cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) {
            if (valid) valid = validate_move(*cloth, motion);
        });
        simulation.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
            if (valid) valid = weft::validate(moved(slot.current, motion));
            if (valid) valid = weft::validate(moved(slot.target, motion));
        });
        simulation.state.bodies.for_each([&](BodyId, const BodySlot& slot) {
            const Vector3 there = to_vector(slot.state.position) - to_vector(to);
            if (valid) valid = validate_point("BodyState::position", to_vec3(there));
        });
        for (const AirSource& source : simulation.settings.wind.sources) {
            const Vector3 there = to_vector(source.position) - to_vector(to);
            if (valid && source.kind != AirSourceKind::none)
                valid = validate_point("AirSource::position", to_vec3(there));
        }
        for (const AirShelter& shelter : simulation.settings.wind.shelters) {
            const Vector3 there = to_vector(shelter.position) - to_vector(to);
            if (valid && shelter.kind != AirShelterKind::none)
                valid = validate_point("AirShelter::position", to_vec3(there));
        }
        if (!valid) return valid;
        simulation.parallel.lend([&] { simulation.shift_origin(to); });
        return {};
    });
}

}  // namespace weft
