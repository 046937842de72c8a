#include "cloth/frame/schedule.h"

#include <algorithm>
#include <tuple>

#include "engine/parallel_blocks.h"

namespace weft {

namespace {

// Loops over so few blocks cost as much on many threads as on one: handing blocks out takes as long.
constexpr std::uint32_t too_few_blocks = 4;

// One thread's share of the step is total / threads. A cloth well below it may be one thread's: the others
// have work until it is done, or nearly. One up to it may, where its loops have too few blocks to keep all
// threads busy. A larger one would be waited for.
bool suits_one_thread(const Cloth& cloth, std::uint64_t work, std::uint64_t total, std::uint64_t threads) {
    const std::uint32_t blocks = block_count(cloth.model.particle_count);
    if (threads == 1 || blocks <= too_few_blocks) return true;
    return 4 * work * threads <= total || (work * threads <= total && blocks < 4 * threads);
}

}  // namespace

void Schedule::plan(SlotMap<ClothId, std::unique_ptr<Cloth>>& cloths, int threads) {
    entries_.clear();
    std::uint64_t total = 0;
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        const std::uint64_t work =
            std::uint64_t{cloth->model.particle_count} * static_cast<std::uint64_t>(cloth->settings.substeps);
        entries_.push_back({cloth.get(), work, false});
        total += work;
    });
    for (Entry& entry : entries_) {
        entry.is_whole =
            suits_one_thread(*entry.cloth, entry.work, total, static_cast<std::uint64_t>(threads));
    }
    std::ranges::sort(entries_, std::ranges::greater(),
                      [](const Entry& entry) { return std::tuple(entry.is_whole, entry.work); });
    whole_ = static_cast<std::size_t>(std::ranges::count(entries_, true, &Entry::is_whole));
}

}  // namespace weft
