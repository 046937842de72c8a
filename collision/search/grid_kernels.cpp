#include "collision/search/grid_kernels.h"

#include <algorithm>
#include <numeric>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/search/grid_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/search/compress-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

HWY_INLINE Indices bucket_of(const Cells& cells, CellShape shape, const Lanes3& p, std::uint32_t particle) {
    const Indices bucket = shape == CellShape::row ? row_bucket(cells, p) : cube_bucket(cells, p);
    const Indices spread = hn::And(indices_from(particle), set_index(cells.mask));
    return hn::IfThenElse(hn::RebindMask(IndexTag(), is_finite(p)), bucket, spread);
}

void buckets(const Cells& cells, CellShape shape, std::span<const Vec4> block, std::uint32_t first,
             BlockOfIndices& buckets) {
    const auto size = static_cast<std::uint32_t>(block.size());
    for (std::uint32_t k = 0; k < size; k += part_lanes) {
        Vec4 last[part_lanes] = {};  // padding: a host's array may end within a group
        const Vec4* rows = &block[k];
        if (HWY_UNLIKELY(size - k < part_lanes)) {
            std::copy(block.begin() + k, block.end(), last);
            rows = last;
        }
        const Indices bucket = bucket_of(cells, shape, xyz(load_rows(rows)), first + k);
        hn::StoreU(bucket, IndexTag(), &buckets[k]);
    }
}

void partition(const BlockOfIndices& buckets, const BlockRange& range, std::uint32_t shift,
               std::uint32_t parts, const GridEntries& entries, std::uint16_t* part_starts) {
    const IndexTag d;
    const std::uint32_t size = range.end - range.begin;
    if (parts == 1) {
        std::copy_n(buckets.begin(), size, entries.buckets + range.begin);
        std::iota(entries.particles + range.begin, entries.particles + range.end, range.begin);
        part_starts[0] = 0;
        part_starts[1] = static_cast<std::uint16_t>(size);
        return;
    }
    alignas(64) std::uint32_t sorted_buckets[block_size + part_lanes], particles[block_size + part_lanes];
    std::uint32_t count = 0;
    for (std::uint32_t part = 0; part < parts; ++part) {
        part_starts[part] = static_cast<std::uint16_t>(count);
        for (std::uint32_t k = 0; k < size; k += part_lanes) {
            const Indices bucket = hn::LoadU(d, &buckets[k]);
            const auto is_here = hn::Eq(hn::ShiftRightSame(bucket, static_cast<int>(shift)), set_index(part));
            const Kept here(hn::And(is_here, hn::FirstN(d, size - k)));
            hn::StoreU(here.of(bucket), d, sorted_buckets + count);
            hn::StoreU(here.of_numbers_from(range.begin + k), d, particles + count);
            count += here.count();
        }
    }
    part_starts[parts] = static_cast<std::uint16_t>(count);
    std::copy_n(sorted_buckets, size, entries.buckets + range.begin);
    std::copy_n(particles, size, entries.particles + range.begin);
}

/// Copies lane k to all lanes.
HWY_INLINE Indices broadcast(Indices v, std::uint32_t k) {
    return hn::TableLookupLanes(v, hn::IndicesFromVec(IndexTag(), set_index(k)));
}

/// Prefix sums: lane k has the sum of lanes 0 to k.
HWY_INLINE Indices sums_up_to(Indices v) {
    const IndexTag d;
    v = hn::Add(v, hn::ShiftLeftLanes<1>(d, v));  // these two steps within every four lanes
    v = hn::Add(v, hn::ShiftLeftLanes<2>(d, v));
    for (std::uint32_t step = 4; step < part_lanes; step *= 2) {
        // In each 2 * step lanes, the upper half lacks the lower half's sum.
        const Indices lane = indices_from(0);
        const Indices end_of_lower = hn::Sub(hn::And(lane, set_index(~(2 * step - 1))), set_index(1u - step));
        const Indices lower = hn::TableLookupLanes(v, hn::IndicesFromVec(d, end_of_lower));
        const auto is_upper = hn::Ne(hn::And(lane, set_index(step)), set_index(0));
        v = hn::Add(v, hn::IfThenElseZero(is_upper, lower));
    }
    return v;
}

void sums(std::span<std::uint32_t> values, std::uint32_t first) {
    const IndexTag d;
    std::size_t k = 0;
    Indices before = set_index(first);
    for (; k + part_lanes <= values.size(); k += part_lanes) {
        const Indices count = hn::LoadU(d, &values[k]), up_to = sums_up_to(count);
        hn::StoreU(hn::Add(before, hn::Sub(up_to, count)), d, &values[k]);
        before = hn::Add(before, broadcast(up_to, part_lanes - 1));
    }
    std::uint32_t sum = hn::GetLane(before);
    for (; k < values.size(); ++k) {
        const std::uint32_t count = values[k];
        values[k] = sum;
        sum += count;
    }
}

void copy(std::span<const Vec4> positions, const std::uint32_t* particles, std::uint32_t begin,
          std::uint32_t end, float* x, float* y, float* z) {
    const Tag d;
    std::uint32_t s = begin;
    for (; s + part_lanes <= end; s += part_lanes) {
        const Lanes3 p = gather_rows(positions.data(), particles + s);
        hn::StoreU(p.x, d, x + s);
        hn::StoreU(p.y, d, y + s);
        hn::StoreU(p.z, d, z + s);
    }
    for (; s < end; ++s) {
        const Vec4& p = positions[particles[s]];
        x[s] = p.x;
        y[s] = p.y;
        z[s] = p.z;
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(buckets);
HWY_EXPORT(partition);
HWY_EXPORT(sums);
HWY_EXPORT(copy);

void find_buckets(const Cells& cells, CellShape shape, std::span<const Vec4> block, std::uint32_t first,
                  BlockOfIndices& buckets_of_block) {
    HWY_DYNAMIC_DISPATCH(buckets)(cells, shape, block, first, buckets_of_block);
}

void partition_block(const BlockOfIndices& buckets_of_block, const BlockRange& range, std::uint32_t shift,
                     std::uint32_t parts, const GridEntries& entries, std::uint16_t* part_starts) {
    HWY_DYNAMIC_DISPATCH(partition)(buckets_of_block, range, shift, parts, entries, part_starts);
}

void running_sum(std::span<std::uint32_t> values, std::uint32_t first) {
    HWY_DYNAMIC_DISPATCH(sums)(values, first);
}

void copy_sorted(std::span<const Vec4> positions, const std::uint32_t* particles, std::uint32_t begin,
                 std::uint32_t end, float* x, float* y, float* z) {
    HWY_DYNAMIC_DISPATCH(copy)(positions, particles, begin, end, x, y, z);
}

}  // namespace weft
#endif
