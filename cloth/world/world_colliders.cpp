// The World's calls for colliders, and for the shapes that they are instances of.

#include <string>
#include <utility>

#include "cloth/record/world_calls.h"
#include "cloth/settings/validate.h"

namespace weft {

namespace {

/// Error: the collider is an instance of a shape that does not exist.
Result<void> validate_instance(const Simulation& simulation, const Collider& collider) {
    const auto* const placed = std::get_if<PlacedShape>(&collider.shape);
    if (placed != nullptr && simulation.held_by(collider) == nullptr)
        return stale_id("ShapeId", placed->shape);
    return {};
}

bool are_of_one_kind(const Collider& a, const Collider& b) {
    const auto* const of_a = std::get_if<PlacedShape>(&a.shape);
    const auto* const of_b = std::get_if<PlacedShape>(&b.shape);
    if (of_a != nullptr && of_b != nullptr) return of_a->shape == of_b->shape;
    return a.shape.index() == b.shape.index();
}

/// Calls `use` with the slot of a collider that may become `target`.
template <class Use>
Result<void> with_collider(Simulation& simulation, ColliderId id, const Collider& target, const Use& use) {
    return without_exceptions([&]() -> Result<void> {
        if (auto valid = validate(target); !valid) return valid.error();
        ColliderSlot* const slot = simulation.state.colliders.find(id);
        if (slot == nullptr) return stale_id("ColliderId", id);
        if (!are_of_one_kind(slot->current, target))
            return Error{ErrorCode::invalid_argument,
                         "the collider is of another kind of shape; remove it and add the new one"};
        if (slot->body != BodyId{})
            return Error{ErrorCode::invalid_argument,
                         "a body carries the collider; set_body_state moves it, or detach_collider first"};
        use(*slot);
        return {};
    });
}

}  // namespace

Result<ShapeId> World::add_shape(const Shape& shape) {
    return impl_->change(Call::add_shape, shape)([&]() -> Result<ShapeId> {
        auto held = HeldShape::make(shape);
        if (!held) return held.error();
        return impl_->simulation.shapes.insert(std::make_unique<HeldShape>(std::move(held).value()));
    });
}

Result<void> World::deform_shape(ShapeId id, std::span<const Vec3> vertices) {
    return impl_->change(Call::deform_shape, id, vertices)([&]() -> Result<void> {
        auto* const held = impl_->simulation.shapes.find(id);
        if (held == nullptr) return stale_id("ShapeId", id);
        return (*held)->deform(vertices, impl_->simulation.state.steps + 1);
    });
}

Result<void> World::remove_shape(ShapeId id) {
    return impl_->change(Call::remove_shape, id)([&]() -> Result<void> {
        Simulation& simulation = impl_->simulation;
        const auto* const held = simulation.shapes.find(id);
        if (held == nullptr) return stale_id("ShapeId", id);
        std::size_t instances = 0;
        simulation.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
            instances += simulation.held_by(slot.target) == held->get() ? 1 : 0;
        });
        if (instances > 0)
            return Error{ErrorCode::invalid_argument, std::to_string(instances) +
                                                          " colliders are instances of the shape; remove "
                                                          "them first"};
        simulation.shapes.erase(id);
        return {};
    });
}

Result<ShapeInfo> World::shape_info(ShapeId id) const {
    return without_exceptions([&]() -> Result<ShapeInfo> {
        const auto* const held = impl_->simulation.shapes.find(id);
        if (held == nullptr) return stale_id("ShapeId", id);
        return (*held)->info();
    });
}

Result<ColliderId> World::add_collider(const Collider& collider) {
    return impl_->change(Call::add_collider, collider)([&]() -> Result<ColliderId> {
        Simulation& simulation = impl_->simulation;
        if (const auto valid = validate(collider); !valid) return valid.error();
        if (const auto there = validate_instance(simulation, collider); !there) return there.error();
        const ColliderId id = simulation.state.colliders.insert({normalized(collider), normalized(collider)});
        or_undo([&] { simulation.expect_colliders(simulation.state.colliders.size()); },
                [&] { simulation.state.colliders.erase(id); });
        simulation.wake_near(collider);
        return id;
    });
}

Result<void> World::move_collider(ColliderId id, const Collider& target) {
    return impl_->change(Call::move_collider, id, target)([&] {
        return with_collider(impl_->simulation, id, target,
                             [&](ColliderSlot& slot) { slot.target = normalized(target); });
    });
}

Result<void> World::place_collider(ColliderId id, const Collider& place) {
    return impl_->change(Call::place_collider, id, place)([&] {
        return with_collider(impl_->simulation, id, place, [&](ColliderSlot& slot) {
            impl_->simulation.wake_near(slot.current);
            slot.current = slot.target = normalized(place);
            impl_->simulation.wake_near(place);
        });
    });
}

Result<void> World::remove_collider(ColliderId id) {
    return impl_->change(Call::remove_collider, id)([&]() -> Result<void> {
        Simulation& simulation = impl_->simulation;
        const ColliderSlot* const slot = simulation.state.colliders.find(id);
        if (slot == nullptr) return stale_id("ColliderId", id);
        simulation.wake_near(slot->current);
        simulation.state.colliders.erase(id);
        if (simulation.state.colliders.size() == 0 && simulation.state.bodies.size() == 0)
            simulation.expect_colliders(0);
        return {};
    });
}

Result<Collider> World::collider(ColliderId id) const {
    return impl_->read("collider", [&]() -> Result<Collider> {
        const ColliderSlot* slot = impl_->simulation.state.colliders.find(id);
        if (slot == nullptr) return stale_id("ColliderId", id);
        return slot->current;
    });
}

}  // namespace weft
