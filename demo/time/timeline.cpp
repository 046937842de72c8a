#include "demo/time/timeline.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace weft::demo {

bool Timeline::make_room(std::size_t size, Moment& moment) {
    if (size > room_) return false;
    while (bytes_ + size > room_) {
        bytes_ -= moments_.front().save.size();
        moment = std::move(moments_.front());
        moments_.pop_front();
    }
    moment.save.resize(size);
    return true;
}

Result<void> Timeline::keep(const Simulation& simulation, const HandMark& mark) {
    while (moments_.size() > here_ + 1) {
        bytes_ -= moments_.back().save.size();
        moments_.pop_back();
    }
    if (std::exchange(cuts_, simulation.cuts()) != simulation.cuts()) clear();
    Moment moment;
    if (!make_room(simulation.world().save_size(), moment)) {
        clear();
        return {};
    }
    if (auto saved = simulation.world().save(moment.save); !saved) {
        clear();
        return saved;
    }
    moment.time = simulation.time();
    moment.mark = mark;
    bytes_ += moment.save.size();
    moments_.push_back(std::move(moment));
    here_ = moments_.size() - 1;
    return {};
}

Result<void> Timeline::go_to(std::size_t which, Simulation& simulation) {
    const Moment& moment = moments_[which];
    if (auto restored = simulation.world().restore(moment.save); !restored) return restored;
    simulation.set_time(moment.time);
    here_ = which;
    return {};
}

void Timeline::clear() {
    moments_.clear();
    bytes_ = here_ = 0;
}

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
