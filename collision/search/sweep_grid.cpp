#include "collision/search/sweep_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace weft {

namespace {

constexpr std::uint32_t mask = 0xFFFF, columns_shift[2] = {16, 24};
constexpr float most_sweep_cells = 65533, most_columns = 253;
constexpr std::uint32_t padding = HashGrid::padding;
constexpr std::uint32_t not_finite = ~0u;  // no column has such bytes: sorted behind all others

/// Differences of keys to the same sweep cell in the nine columns, the own one first.
constexpr std::array<std::uint32_t, SlotRanges::per_slot> offsets = [] {
    constexpr std::uint32_t a = 1u << columns_shift[0], b = 1u << columns_shift[1];
    return std::array<std::uint32_t, SlotRanges::per_slot>{0,     a,     b,         b + a, b - a,
                                                           0 - a, 0 - b, 0 - b - a, a - b};
}();

/// The first slot from `slot` on whose key is not below `key`: mostly a step or two, as keys ascend.
std::uint32_t advance_to(std::span<const std::uint32_t> keys, std::uint32_t slot, std::uint32_t key) {
    constexpr std::uint32_t steps = 8;
    const auto end = static_cast<std::uint32_t>(keys.size());
    for (std::uint32_t step = 0; step < steps; ++step, ++slot)
        if (slot == end || keys[slot] >= key) return slot;
    return static_cast<std::uint32_t>(std::lower_bound(keys.begin() + slot, keys.end(), key) - keys.begin());
}

}  // namespace

SweepGrid::SweepGrid(std::uint32_t particle_count)
    : entries_(particle_count),
      other_entries_(particle_count),
      counts_((particle_count + sort_block - 1) / sort_block),
      keys_(particle_count),
      particles_(particle_count + padding),
      x_(particle_count + padding),
      y_(particle_count + padding),
      z_(particle_count + padding) {}

std::uint32_t SweepGrid::Axis::at(const Vec4& p) const noexcept {
    const float cell = (p.*coordinate - lower) * per_metre;
    return 1 + static_cast<std::uint32_t>(cell > 0 ? std::min(cell, cells - 1) : 0);
}

std::uint32_t SweepGrid::key_of(const Vec4& p) const noexcept {
    return axes_[0].at(p) | axes_[1].at(p) << columns_shift[0] | axes_[2].at(p) << columns_shift[1];
}

// Columns are wider than the distance by more than the rounding of a coordinate in 253 of them: two particles
// closer than the distance are never two columns apart. Along the sweep, two cells more than the distance
// takes allow for a particle's place in its cell, and for rounding.
void SweepGrid::choose_axes(const Bounds& bounds, float distance) {
    constexpr double margin = 1 + 1.0 / 8192;
    const auto extent_of = [](float lower, float upper) {
        return std::max(static_cast<double>(upper) - static_cast<double>(lower), 0.0);
    };
    std::array<std::pair<double, Axis>, 3> sides{{
        {extent_of(bounds.lower.x, bounds.upper.x), {&Vec4::x, bounds.lower.x, 0, most_columns}},
        {extent_of(bounds.lower.y, bounds.upper.y), {&Vec4::y, bounds.lower.y, 0, most_columns}},
        {extent_of(bounds.lower.z, bounds.upper.z), {&Vec4::z, bounds.lower.z, 0, most_columns}},
    }};
    const auto longest = std::ranges::max_element(sides, {}, [](const auto& side) { return side.first; });
    std::swap(sides[0], *longest);
    for (std::size_t k = 0; k < 3; ++k) {
        const double width = std::max(static_cast<double>(distance) * margin,
                                      sides[k].first / static_cast<double>(most_columns));
        axes_[k] = sides[k].second;
        axes_[k].per_metre = static_cast<float>(1 / width);
    }
    constexpr double shortest = 1e-30;  // extent of a cloth that lies at one point
    axes_[0].per_metre =
        static_cast<float>(static_cast<double>(most_sweep_cells) / std::max(sides[0].first, shortest));
    axes_[0].cells = most_sweep_cells;
    sweep_cells_ = static_cast<std::uint32_t>(std::min(2 + axes_[0].per_metre * distance, most_sweep_cells));
}

/// A stable counting sort by one byte. Returns false, and moves nothing, if all have the same byte.
bool SweepGrid::sort_by(Parallel& parallel, std::uint32_t shift, const Entry* from, Entry* to) {
    const auto n = static_cast<std::uint32_t>(entries_.size());
    parallel.ranges(
        n,
        [&](const BlockRange& range) {
            Counts& counts = counts_[range.block];
            counts.fill(0);
            for (std::uint32_t k = range.begin; k < range.end; ++k)
                ++counts[from[k].key >> shift & (radix - 1)];
        },
        sort_block);
    std::uint32_t sum = 0;
    for (std::uint32_t digit = 0; digit < radix; ++digit) {
        const std::uint32_t before = sum;
        for (Counts& counts : counts_.span()) sum += std::exchange(counts[digit], sum);
        if (sum - before == n) return false;
    }
    parallel.ranges(
        n,
        [&](const BlockRange& range) {
            Counts& places = counts_[range.block];
            for (std::uint32_t k = range.begin; k < range.end; ++k)
                to[places[from[k].key >> shift & (radix - 1)]++] = from[k];
        },
        sort_block);
    return true;
}

void SweepGrid::build(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds,
                      float distance) {
    choose_axes(bounds, distance);
    const auto n = static_cast<std::uint32_t>(positions.size());
    parallel.ranges(n, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vec4& p = positions[i];
            const bool is_finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
            entries_[i] = {is_finite ? key_of(p) : not_finite, i};
        }
    });
    Entry *from = entries_.data(), *to = other_entries_.data();
    for (std::uint32_t digit = 0; digit < digits; ++digit)
        if (sort_by(parallel, 8 * digit, from, to)) std::swap(from, to);
    finite_ = static_cast<std::uint32_t>(
        std::partition_point(from, from + n, [](const Entry& entry) { return entry.key != not_finite; }) -
        from);
    parallel.ranges(n, [&](const BlockRange& range) {
        for (std::uint32_t slot = range.begin; slot < range.end; ++slot) {
            keys_[slot] = from[slot].key;
            particles_[slot] = from[slot].particle;
        }
        copy_sorted(positions, particles_.data(), range.begin, range.end, x_.data(), y_.data(), z_.data());
    });
    constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
    for (std::uint32_t slot = n; slot < n + padding; ++slot) x_[slot] = y_[slot] = z_[slot] = nowhere;
}

// Keys ascend from slot to slot, and so do the ends of the ranges: each search continues from the last.
void SweepGrid::find_ranges(const BlockRange& slots, SlotRanges& ranges) const {
    const std::span<const std::uint32_t> keys = keys_.span().first(finite_);
    const auto first_key = [&](std::uint32_t key) { return key - std::min(sweep_cells_, key & mask); };
    const auto last_key = [&](std::uint32_t key) { return std::min(key + sweep_cells_, key | mask); };
    for (std::uint32_t c = 0; c < SlotRanges::per_slot; ++c) {
        const auto start = std::ranges::lower_bound(keys, first_key(keys[slots.begin]) + offsets[c]);
        SlotRange range;
        range.begin = range.end = static_cast<std::uint32_t>(start - keys.begin());
        for (std::uint32_t slot = slots.begin; slot < slots.end; ++slot) {
            const std::uint32_t key = keys[slot];
            range.begin = advance_to(keys, range.begin, first_key(key) + offsets[c]);
            range.end = advance_to(keys, std::max(range.begin, range.end), last_key(key) + offsets[c] + 1);
            ranges.of[slot - slots.begin][c] = range;
        }
    }
}

std::size_t SweepGrid::bytes() const noexcept {
    return entries_.bytes() + other_entries_.bytes() + counts_.bytes() + keys_.bytes() + particles_.bytes() +
           x_.bytes() + y_.bytes() + z_.bytes();
}

}  // namespace weft
