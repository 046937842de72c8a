#include "cloth/simulation/schedule.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "engine/threads/parallel_blocks.h"

namespace weft {

namespace {

// Loops over so few blocks cost as much on many threads as on one: handing blocks out takes as long.
constexpr std::uint32_t too_few_blocks = 4;

// One thread's share of the step is total / threads. A group well below it suits one thread: the others have
// work until it is done, or nearly. A group up to it does, if its loops have too few blocks to keep all
// threads busy. The other threads would wait for a larger group.
bool suits_one_thread(const Schedule::Group& group, std::uint64_t total, std::uint64_t threads) {
    if (threads == 1 || group.blocks <= too_few_blocks) return true;
    return 4 * group.work * threads <= total || (group.work * threads <= total && group.blocks < 4 * threads);
}

std::uint64_t work_of(const Cloth& cloth) {
    const std::uint64_t particles = cloth.model.particle_count;
    if (cloth.is_gliding()) return particles / 8;
    return particles * static_cast<std::uint64_t>(cloth.settings.substeps);
}

}  // namespace

void Schedule::reserve(std::size_t cloths) {
    members_.reserve(cloths);
    own_places_.reserve(cloths);
    next_.reserve(cloths);
    groups_.reserve(cloths);
}

void Schedule::plan(std::span<Cloth* const> cloths, int threads) {
    own_places_.resize(cloths.size());
    std::iota(own_places_.begin(), own_places_.end(), 0u);
    plan(cloths, own_places_, threads);
}

// A counting sort: a group's cloths become consecutive, in their order.
void Schedule::plan(std::span<Cloth* const> cloths, std::span<const std::uint32_t> first_of, int threads) {
    next_.assign(cloths.size(), 0);
    for (const std::uint32_t first : first_of) ++next_[first];
    std::uint32_t begin = 0;
    for (std::uint32_t& count : next_) begin += std::exchange(count, begin);
    members_.assign(cloths.begin(), cloths.end());
    for (std::size_t i = 0; i < cloths.size(); ++i) members_[next_[first_of[i]]++] = cloths[i];

    groups_.clear();
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < cloths.size(); ++i) {
        if (first_of[i] != i) continue;
        Group group{.cloths = std::span(members_).subspan(end, next_[i] - end),
                    .work = 0,
                    .blocks = 0,
                    .scratch_bytes = 0,
                    .scratch = 0,
                    .is_whole = false};
        end = next_[i];
        for (const Cloth* cloth : group.cloths) {
            group.work += work_of(*cloth);
            group.scratch_bytes += cloth->scratch_bytes;
            group.blocks += block_count(cloth->model.particle_count);
        }
        groups_.push_back(group);
    }
    share_out(threads);
}

void Schedule::share_out(int threads) {
    std::uint64_t total = 0;
    for (const Group& group : groups_) total += group.work;
    // The World has one memory for its bodies' motion and one for impact zones: their users run one at a
    // time.
    const auto needs_what_there_is_once = [](const Cloth* cloth) {
        return cloth->meets_bodies || has_zones(cloth->settings.self_collision);
    };
    for (Group& group : groups_)
        group.is_whole = std::ranges::none_of(group.cloths, needs_what_there_is_once) &&
                         suits_one_thread(group, total, static_cast<std::uint64_t>(threads));
    // Ties keep the order of cloths, so that those that meet a body have a fixed order.
    std::ranges::sort(groups_, std::ranges::greater(), [this](const Group& group) {
        return std::tuple(group.is_whole, group.is_whole ? group.scratch_bytes : group.work,
                          members_.data() - group.cloths.data());
    });
    whole_ = static_cast<std::size_t>(std::ranges::count(groups_, true, &Group::is_whole));
    std::size_t scratch = 0;
    for (Group& group : std::span(groups_).first(whole_)) {
        group.scratch = scratch;
        scratch += group.scratch_bytes;
    }
}

}  // namespace weft
