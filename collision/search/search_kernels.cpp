#include "collision/search/search_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/search/search_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/search/compress-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Data of the loops, kept in registers.
struct Slots {
    const float *x, *y, *z;
    float distance_squared;
};
HWY_INLINE Slots slots_of(const SortedParticles& sorted, float distance_squared) {
    return {sorted.x, sorted.y, sorted.z, distance_squared};
}

/// Lanes per range. Most ranges hold few slots: a register of 16 lanes takes 8 of one and 8 of the next.
constexpr std::uint32_t range_lanes = std::min(part_lanes, 8u);

template <class D>
HWY_INLINE hn::Vec<D> load_of_two(D d, const float* values, std::uint32_t first, std::uint32_t second) {
    if constexpr (hn::MaxLanes(D()) == 16) {
        const hn::Half<D> half;
        return hn::Combine(d, hn::LoadU(half, values + second), hn::LoadU(half, values + first));
    } else {
        return hn::LoadU(d, values + first);
    }
}

/// Number of close slots among range_lanes slots from `first` on and as many from `second` on.
HWY_INLINE std::size_t count_close(const Slots& slots, const Lanes3& p, std::uint32_t first,
                                   std::uint32_t second) {
    const auto close_to = [&](std::uint32_t a, std::uint32_t b) {
        const Tag d;
        const Lanes3 other = {load_of_two(d, slots.x, a, b), load_of_two(d, slots.y, a, b),
                              load_of_two(d, slots.z, a, b)};
        return hn::CountTrue(d, hn::Lt(squared_length(other - p), set(slots.distance_squared)));
    };
    return part_lanes == 16 ? close_to(first, second) : close_to(first, first) + close_to(second, second);
}

/// False if the ranges, of which one holds the particle itself, surely hold no contact of the particle. This
/// is so for most particles; no branch depends on the outcome. Lanes past a range's end cause at worst a
/// false alarm.
template <std::uint32_t runs>
HWY_INLINE bool may_have_company(const Slots& slots, std::uint32_t slot, const std::uint32_t (&begins)[runs],
                                 std::uint32_t longest) {
    const Lanes3 p = {set(slots.x[slot]), set(slots.y[slot]), set(slots.z[slot])};
    std::size_t close = 0;
    std::uint32_t s = 0;
    do {
        if constexpr (runs == 1) {
            close += count_close(slots, p, begins[0] + s, begins[0] + s + range_lanes);
            s += 2 * range_lanes;
        } else {
            for (std::uint32_t r = 0; r < runs; r += 2)
                close += count_close(slots, p, begins[r] + s, begins[r + 1] + s);
            s += range_lanes;
        }
    } while (HWY_UNLIKELY(s < longest));
    return close > 1;  // the particle itself is one
}

HWY_INLINE Lanes3 positions_at(const Slots& slots, std::uint32_t slot) {
    const Tag d;
    return {hn::LoadU(d, slots.x + slot), hn::LoadU(d, slots.y + slot), hn::LoadU(d, slots.z + slot)};
}

/// Stores the particles of a range that are close to `slot`, except its own; returns their number.
HWY_INLINE std::uint32_t close_in_range(const Slots& slots, const std::uint32_t* particles,
                                        std::uint32_t slot, SlotRange range, std::uint32_t* close) {
    const IndexTag d;
    const Lanes3 p = {set(slots.x[slot]), set(slots.y[slot]), set(slots.z[slot])};
    std::uint32_t count = 0;
    std::uint32_t s = range.begin;
    do {  // at least once: a branch on empty ranges could not be predicted
        const auto is_close = hn::Lt(squared_length(positions_at(slots, s) - p), set(slots.distance_squared));
        const auto is_other = hn::Ne(indices_from(s), set_index(slot));
        const Kept kept(
            hn::And(hn::And(hn::RebindMask(d, is_close), is_other), hn::FirstN(d, range.end - s)));
        hn::StoreU(kept.of(hn::LoadU(d, particles + s)), d, close + count);
        count += kept.count();
        s += part_lanes;
    } while (HWY_UNLIKELY(s < range.end));
    return count;
}

/// Keeps the hits of one slot, which end at `end`; leaves over a slot with too many.
HWY_INLINE void keep_hits(const std::uint32_t* particles, std::uint32_t slot, std::uint32_t end,
                          BlockHits& hits) {
    if (HWY_UNLIKELY(end - hits.count > BlockHits::per_slot)) {
        hits.left_over[hits.left_over_count++] = slot;
        return;
    }
    for (std::uint32_t lane = 0; lane < BlockHits::per_slot; lane += part_lanes)
        hn::StoreU(set_index(particles[slot]), IndexTag(), &hits.particles[hits.count + lane]);
    hits.count = end;
}

/// The first buckets of the runs that each particle of a block searches.
template <std::uint32_t runs>
using BlockOfRuns = std::uint32_t[runs][block_size];

HWY_INLINE void store_runs(const Cells& cells, const Lanes3& p, std::uint32_t k, BlockOfRuns<4>& firsts) {
    const RunsLanes near = runs_near(cells, p);
    for (std::uint32_t r = 0; r < 4; ++r) hn::Store(near.run[r], IndexTag(), &firsts[r][k]);
}
HWY_INLINE void store_runs(const Cells& cells, const Lanes3& p, std::uint32_t k, BlockOfRuns<1>& firsts) {
    hn::Store(cube_bucket(cells, p), IndexTag(), &firsts[0][k]);
}

/// Finds hits in `runs` runs of `run_length` buckets each.
template <std::uint32_t runs, std::uint32_t run_length>
HWY_INLINE void hits_in(const HashGrid& grid, float distance_squared, const BlockRange& block,
                        const SlotFlags& wanted, BlockHits& hits) {
    const Slots slots = slots_of(grid.sorted(), distance_squared);
    const std::uint32_t* const starts = grid.starts();
    const Cells cells = grid.cells();
    alignas(64) BlockOfRuns<runs> firsts;
    for (std::uint32_t slot = block.begin; slot < block.end; slot += part_lanes)
        store_runs(cells, positions_at(slots, slot), slot - block.begin, firsts);

    BlockOfIndices suspects;
    std::uint32_t suspect_count = 0;
    hits.count = hits.left_over_count = 0;
    for (std::uint32_t slot = block.begin; slot < block.end; ++slot) {
        if (!wanted[slot - block.begin]) continue;
        std::uint32_t begins[runs], longest = 0, last = 0;
        for (std::uint32_t r = 0; r < runs; ++r) {
            const std::uint32_t first = firsts[r][slot - block.begin];
            begins[r] = starts[first];
            longest = std::max(longest, starts[first + run_length] - begins[r]);
            last = std::max(last, first);
        }
        const bool wraps = last + run_length > cells.mask + 1;
        if (HWY_UNLIKELY(wraps || longest > BlockHits::longest_range)) {
            hits.left_over[hits.left_over_count++] = slot;
            continue;
        }
        suspects[suspect_count] = slot;
        suspect_count += may_have_company<runs>(slots, slot, begins, longest) ? 1 : 0;
    }

    const std::uint32_t* const particles = grid.particles();
    for (std::uint32_t k = 0; k < suspect_count; ++k) {
        const std::uint32_t slot = suspects[k];
        std::uint32_t end = hits.count;
        for (std::uint32_t r = 0; r < runs; ++r) {
            const std::uint32_t first = firsts[r][slot - block.begin];
            const SlotRange range{starts[first], starts[first + run_length]};
            end += close_in_range(slots, particles, slot, range, &hits.others[end]);
        }
        keep_hits(particles, slot, end, hits);
    }
}

/// Long ranges are searched in parts: `hits` has room for one part's hits behind that for all slots.
void hits_in_ranges(const SortedParticles& sorted, float distance_squared, const BlockRange& block,
                    const SlotRanges& ranges, BlockHits& hits) {
    const Slots slots = slots_of(sorted, distance_squared);
    hits.count = hits.left_over_count = 0;
    for (std::uint32_t slot = block.begin; slot < block.end; ++slot) {
        std::uint32_t end = hits.count;
        for (SlotRange range : ranges.of[slot - block.begin]) {
            for (; range.begin < range.end && end - hits.count <= BlockHits::per_slot;
                 range.begin += BlockHits::longest_range) {
                const SlotRange part{range.begin,
                                     std::min(range.end, range.begin + BlockHits::longest_range)};
                end += close_in_range(slots, sorted.particles, slot, part, &hits.others[end]);
            }
        }
        keep_hits(sorted.particles, slot, end, hits);
    }
}

void hits(const HashGrid& grid, CellShape shape, float distance_squared, const BlockRange& block,
          const SlotFlags& wanted, BlockHits& hits) {
    shape == CellShape::row ? hits_in<4, HashGrid::run_length>(grid, distance_squared, block, wanted, hits)
                            : hits_in<1, 1>(grid, distance_squared, block, wanted, hits);
}

void without_rest_pairs(const RestFilter& filter, BlockHits& hits) {
    if (filter.offsets.empty()) return;
    std::uint32_t kept = 0;
    for (std::uint32_t k = 0; k < hits.count; ++k) {
        const std::uint32_t i = hits.particles[k], j = hits.others[k];
        hits.particles[kept] = i;
        hits.others[kept] = j;
        kept += filter.leaves_alone(i, j) ? 0 : 1;
    }
    hits.count = kept;
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(hits);
HWY_EXPORT(hits_in_ranges);
HWY_EXPORT(without_rest_pairs);

void find_hits(const HashGrid& grid, CellShape shape, float distance_squared, const BlockRange& block,
               const SlotFlags& wanted, BlockHits& found) {
    HWY_DYNAMIC_DISPATCH(hits)(grid, shape, distance_squared, block, wanted, found);
}

void find_hits_in_ranges(const SortedParticles& sorted, float distance_squared, const BlockRange& block,
                         const SlotRanges& ranges, BlockHits& found) {
    HWY_DYNAMIC_DISPATCH(hits_in_ranges)(sorted, distance_squared, block, ranges, found);
}

void drop_rest_pairs(const RestFilter& filter, BlockHits& found) {
    HWY_DYNAMIC_DISPATCH(without_rest_pairs)(filter, found);
}

}  // namespace weft
#endif
