// The public World: bodies.

#include "cloth/record/world_calls.h"
#include "cloth/settings/validate.h"
#include "engine/memory/without_exceptions.h"

namespace weft {

BodyPose pose_of(const BodyState& state) {
    const Rotation& r = state.rotation;
    return {to_vector(state.position), Eigen::Quaternionf(r.w, r.x, r.y, r.z).normalized()};
}

namespace {

BodyState normalized(BodyState state) {
    state.rotation = normalized(state.rotation);
    return state;
}

/// Calls `use` with the slot of a body.
template <class Simulation, class Use>
auto with_body(Simulation& simulation, BodyId id, const Use& use)
    -> decltype(use(*simulation.state.bodies.find(id))) {
    return without_exceptions([&]() -> decltype(use(*simulation.state.bodies.find(id))) {
        auto* const slot = simulation.state.bodies.find(id);
        if (slot == nullptr) return stale_id("BodyId", id);
        return use(*slot);
    });
}

}  // namespace

Result<BodyId> World::add_body(const BodySettings& settings, const BodyState& state) {
    return impl_->change(Call::add_body, settings, state)([&]() -> Result<BodyId> {
        if (const auto valid = validate(settings); !valid) return valid.error();
        if (const auto valid = validate(state); !valid) return valid.error();
        return impl_->simulation.add_body({settings, normalized(state)});
    });
}

Result<void> World::remove_body(BodyId id) {
    return impl_->change(Call::remove_body, id)([&] {
        return with_body(impl_->simulation, id, [&](BodySlot&) -> Result<void> {
            impl_->simulation.remove_body(id);
            return {};
        });
    });
}

Result<BodySettings> World::body_settings(BodyId id) const {
    return with_body(impl_->simulation, id,
                     [](const BodySlot& slot) { return Result<BodySettings>(slot.settings); });
}

Result<void> World::set_body_settings(BodyId id, const BodySettings& settings) {
    return impl_->change(Call::set_body_settings, id, settings)([&] {
        return with_body(impl_->simulation, id, [&](BodySlot& slot) -> Result<void> {
            if (auto valid = validate(settings); !valid) return valid;
            slot.settings = settings;
            return {};
        });
    });
}

Result<BodyState> World::body_state(BodyId id) const {
    return impl_->read("body_state", [&] {
        return with_body(impl_->simulation, id,
                         [](const BodySlot& slot) { return Result<BodyState>(slot.state); });
    });
}

Result<void> World::set_body_state(BodyId id, const BodyState& state) {
    return impl_->change(Call::set_body_state, id, state)([&] {
        return with_body(impl_->simulation, id, [&](BodySlot& slot) -> Result<void> {
            if (auto valid = validate(state); !valid) return valid;
            slot.state = normalized(state);
            impl_->simulation.place_carried_colliders();
            return {};
        });
    });
}

Result<void> World::attach_collider(BodyId id, ColliderId collider) {
    return impl_->change(Call::attach_collider, id, collider)([&] {
        Simulation& simulation = impl_->simulation;
        return with_body(simulation, id, [&](BodySlot& slot) -> Result<void> {
            ColliderSlot* const carried_one = simulation.state.colliders.find(collider);
            if (carried_one == nullptr) return stale_id("ColliderId", collider);
            if (std::holds_alternative<Plane>(carried_one->current.shape))
                return Error{ErrorCode::invalid_argument,
                             "the collider is a Plane, which has no end; attach a Box"};
            carried_one->body = id;
            carried_one->own = carried(carried_one->current, pose_of(slot.state).inverse());
            carried_one->target = carried_one->current;
            return {};
        });
    });
}

Result<void> World::detach_collider(ColliderId collider) {
    return impl_->change(Call::detach_collider, collider)([&]() -> Result<void> {
        ColliderSlot* const slot = impl_->simulation.state.colliders.find(collider);
        if (slot == nullptr) return stale_id("ColliderId", collider);
        slot->body = {};
        return {};
    });
}

Result<void> World::attach(BodyId id, ClothId cloth, std::span<const std::uint32_t> vertices) {
    return impl_->change(Call::attach, id, cloth, vertices)([&] {
        Simulation& simulation = impl_->simulation;
        return with_body(simulation, id, [&](BodySlot& slot) -> Result<void> {
            const std::unique_ptr<Cloth>* const found = simulation.cloths.find(cloth);
            if (found == nullptr) return stale_id("ClothId", cloth);
            const auto particles = particles_of(**found, vertices);
            if (!particles) return particles.error();
            (*found)->attach(id, pose_of(slot.state), *particles);
            return {};
        });
    });
}

Result<void> World::detach(ClothId cloth, std::span<const std::uint32_t> vertices) {
    return impl_->change(Call::detach, cloth, vertices)([&]() -> Result<void> {
        const std::unique_ptr<Cloth>* const found = impl_->simulation.cloths.find(cloth);
        if (found == nullptr) return stale_id("ClothId", cloth);
        const auto particles = particles_of(**found, vertices);
        if (!particles) return particles.error();
        (*found)->detach(*particles);
        return {};
    });
}

std::span<const BodyImpulse> World::body_impulses() const noexcept {
    if (impl_->is_in_step()) return {};
    return impl_->simulation.body_impulses();
}

}  // namespace weft
