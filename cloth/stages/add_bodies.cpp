// What a World makes and frees for bodies.

#include <algorithm>
#include <utility>

#include "cloth/simulation/simulation.h"
#include "engine/memory/without_exceptions.h"

namespace weft {

void Cloth::attach(BodyId body, const BodyPose& pose, std::span<const std::uint32_t> particles) {
    const BodyPose to_own = pose.inverse();
    std::vector<Attachment> changed = attached;
    changed.reserve(changed.size() + particles.size());
    for (const std::uint32_t i : particles) changed.push_back({i, 0, to_own * xyz(state.positions[i]), body});
    // The last that was said of a particle holds.
    std::ranges::reverse(changed);
    std::ranges::stable_sort(changed, {}, &Attachment::particle);
    const auto again = std::ranges::unique(changed, {}, &Attachment::particle);
    changed.erase(again.begin(), again.end());
    attached = std::move(changed);
}

void Cloth::detach(std::span<const std::uint32_t> particles) {
    std::vector<std::uint32_t> ascending(particles.begin(), particles.end());
    std::ranges::sort(ascending);
    std::erase_if(attached, [&](const Attachment& attachment) {
        return std::ranges::binary_search(ascending, attachment.particle);
    });
}

std::size_t Simulation::number_of(BodyId id) const {
    std::size_t number = 0;
    state.bodies.for_each([&](BodyId other, const BodySlot&) { number += other.index < id.index ? 1 : 0; });
    return number;
}

BodyId Simulation::add_body(const BodySlot& slot) {
    const BodyId id = state.bodies.insert(slot);
    struct Made {
        std::vector<BodyShare> shares;
        std::vector<CollectedShare> collected;
        BodyBuffers buffers;
    };
    std::vector<std::pair<Cloth*, Made>> of_cloths;
    std::unique_ptr<BodyStage> stage;
    Room room;
    const std::size_t count = state.bodies.size(), number = number_of(id);
    or_undo(
        [&] {
            stage = std::make_unique<BodyStage>(count, cloths.size(), state.colliders.size());
            of_cloths.reserve(cloths.size());
            cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
                Made made{cloth->state.shares, std::vector<CollectedShare>(count), {}};
                made.shares.insert(made.shares.begin() + static_cast<std::ptrdiff_t>(number), BodyShare{});
                if (count == 1) made.buffers = BodyBuffers(cloth->state.size());
                of_cloths.emplace_back(cloth.get(), std::move(made));
            });
            room = make_room({}, parallel.width());
            expect_colliders(state.colliders.size());
        },
        [&] { state.bodies.erase(id); });
    take(std::move(room));
    for (auto& [cloth, made] : of_cloths) {
        cloth->state.shares = std::move(made.shares);
        cloth->collected = std::move(made.collected);
        if (count == 1) cloth->body_buffers = std::move(made.buffers);
    }
    body_stage = std::move(stage);
    clear_body_impulses();
    return id;
}

void Simulation::remove_body(BodyId id) {
    const auto number = static_cast<std::ptrdiff_t>(number_of(id));
    state.bodies.erase(id);
    state.colliders.for_each([&](ColliderId, ColliderSlot& slot) {
        if (slot.body == id) slot.body = {};
    });
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        std::erase_if(cloth->attached, [&](const Attachment& attached) { return attached.id == id; });
        cloth->state.shares.erase(cloth->state.shares.begin() + number);
        cloth->collected.pop_back();
    });
    body_stage->remove_last();
    clear_body_impulses();
    if (state.bodies.size() > 0) return;
    body_stage.reset();
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        cloth->state.shares = {};
        cloth->collected = {};
        cloth->body_buffers = {};
        cloth->meets_bodies = false;
    });
    if (state.colliders.size() == 0) expect_colliders(0);
}

void Simulation::prepare_for_bodies(Cloth& cloth) const {
    const std::size_t count = state.bodies.size();
    if (count == 0) return;
    cloth.state.shares.assign(count, BodyShare{});
    cloth.collected.assign(count, CollectedShare{});
    cloth.body_buffers = BodyBuffers(cloth.state.size());
}

void Simulation::place_carried_colliders() noexcept {
    state.colliders.for_each([&](ColliderId, ColliderSlot& slot) {
        const BodySlot* const body = state.bodies.find(slot.body);
        if (body == nullptr) return;
        slot.current = slot.target = carried(slot.own, pose_of(body->state));
    });
}

void Simulation::clear_body_impulses() noexcept {
    if (!body_stage) return;
    std::size_t number = 0;
    state.bodies.for_each([&](BodyId id, const BodySlot&) { body_stage->impulses[number++] = {.body = id}; });
}

}  // namespace weft
