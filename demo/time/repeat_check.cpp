#include "demo/time/repeat_check.h"

#include <algorithm>
#include <cstring>

namespace weft::demo {

const StepReport& RepeatCheck::step(World& world, std::span<const ClothId> cloths, float dt) {
    if (!enabled) return world.step(dt);
    save_.resize(world.save_size());
    if (!world.save(save_)) return world.step(dt);
    world.step(dt);
    const std::uint64_t first = world.state_hash();
    first_.clear();
    for (const ClothId id : cloths) {
        const auto view = world.cloth(id);
        first_.emplace_back(view ? std::vector<Vec4>(view->positions.begin(), view->positions.end())
                                 : std::vector<Vec4>());
    }
    if (!world.restore(save_)) return world.report();
    if (between) between(world);
    world.step(dt);
    ++checked_;
    const std::uint64_t second = world.state_hash();
    if (second != first && !difference_) note(world, cloths, first, second);
    return world.report();
}

void RepeatCheck::note(const World& world, std::span<const ClothId> cloths, std::uint64_t first,
                       std::uint64_t second) {
    Difference found{.step = world.report().step, .first = first, .second = second};
    for (std::size_t c = 0; c < cloths.size() && !found.cloth; ++c) {
        const auto view = world.cloth(cloths[c]);
        if (!view) continue;
        const auto other = std::ranges::mismatch(
            first_[c], view->positions,
            [](const Vec4& a, const Vec4& b) { return std::memcmp(&a, &b, sizeof a) == 0; });
        if (other.in1 == first_[c].end()) continue;
        found.cloth = c;
        found.particle = static_cast<std::uint32_t>(other.in1 - first_[c].begin());
    }
    difference_ = found;
}

void RepeatCheck::forget() {
    checked_ = 0;
    difference_.reset();
}

}  // namespace weft::demo
