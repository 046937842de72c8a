#include "collision/particles/self_contacts.h"

#include <algorithm>
#include <array>
#include <bit>

#include "collision/search/search_kernels.h"

namespace weft {

namespace {

/// The test of a pair: closer than `distance`, and not close at rest.
struct PairTest {
    PairTest(const SortedParticles& sorted_particles, const RestFilter& rest_filter, float distance)
        : sorted(sorted_particles), filter(rest_filter), distance_squared(distance * distance) {}

    [[nodiscard]] bool is_close(std::uint32_t slot, std::uint32_t other) const {
        const float dx = sorted.x[slot] - sorted.x[other], dy = sorted.y[slot] - sorted.y[other],
                    dz = sorted.z[slot] - sorted.z[other];
        return dx * dx + dy * dy + dz * dz < distance_squared;
    }

    SortedParticles sorted;
    const RestFilter& filter;
    float distance_squared;
};

/// Calls visit(slot) for the slots of a range, until it returns false; returns its last result. From a slot
/// in the range the order is outward: particles crowded at one point then fill their lists with different
/// particles, not all with the same few.
template <class Visit>
bool visit_from(std::uint32_t slot, SlotRange range, const Visit& visit) {
    if (slot < range.begin || slot >= range.end) {
        for (std::uint32_t other = range.begin; other < range.end; ++other) {
            if (!visit(other)) return false;
        }
        return true;
    }
    const std::uint32_t below = slot - range.begin, above = range.end - 1 - slot;
    for (std::uint32_t away = 1; away <= std::max(below, above); ++away) {
        if (away <= below && !visit(slot - away)) return false;
        if (away <= above && !visit(slot + away)) return false;
    }
    return true;
}

/// Calls add(contact) for the contacts of a slot's particle, until it returns false because the list is full:
/// even n particles at one point cost at most n times the list's capacity.
template <class Add>
void add_contacts(const PairTest& test, std::uint32_t slot, std::span<const SlotRange> ranges,
                  const Add& add) {
    const std::uint32_t particle = test.sorted.particles[slot];
    const auto add_if_close = [&](std::uint32_t other) {
        if (!test.is_close(slot, other)) return true;
        const std::uint32_t contact = test.sorted.particles[other];
        return test.filter.leaves_alone(particle, contact) || add(contact);
    };
    for (const SlotRange& range : ranges) {
        if (!visit_from(slot, range, add_if_close)) return;
    }
}

}  // namespace

SelfContacts::SelfContacts(std::span<const Vec4> rest_positions, SelfCollisionSearch search)
    : patches_(rest_positions),
      grid_(static_cast<std::uint32_t>(rest_positions.size())),
      contacts_(rest_positions.size() * capacity),
      counts_(rest_positions.size()),
      displacements_(rest_positions.size()),
      velocity_changes_(rest_positions.size()),
      block_counts_(block_count(static_cast<std::uint32_t>(rest_positions.size()))),
      left_out_(block_counts_.size()) {
    if (search == SelfCollisionSearch::sorted_sweep)
        sweep_.emplace(static_cast<std::uint32_t>(rest_positions.size()));
}

void SelfContacts::find(Parallel& parallel, std::span<const Vec4> positions, const RestFilter& filter,
                        float distance, SelfCollisionSearch search) {
    std::ranges::fill(counts_.span(), std::uint8_t{0});
    patches_.place(parallel, positions);
    if (search == SelfCollisionSearch::exact) {
        if (search_patches(parallel, filter, distance)) return;
        grid_.build_rows(parallel, positions, patches_.bounds(), distance);
        search_grid(parallel, CellShape::row, filter, distance);
        return;
    }
    if (search == SelfCollisionSearch::sorted_sweep) {
        sweep_->build(parallel, positions, patches_.bounds(), distance);
        search_sweep(parallel, filter, distance);
        return;
    }
    for (const float shift : {0.0f, 0.5f}) {  // Kang, section IV: each particle against its own bucket
        grid_.build_cubes(parallel, positions, patches_.bounds(), distance, shift);
        search_grid(parallel, CellShape::cube, filter, distance);
    }
}

/// Returns false if particles are left unsearched: those of patches that are too crowded.
bool SelfContacts::search_patches(Parallel& parallel, const RestFilter& filter, float distance) {
    const PatchesView patches = patches_.view();
    parallel.ranges(static_cast<std::uint32_t>(counts_.size()), [&](const BlockRange& block) {
        BlockHits hits;
        const std::uint32_t left_out = find_hits_in_patches(patches, distance, block.block, hits);
        for (std::uint32_t bits = left_out; bits != 0; bits &= bits - 1) {
            const std::uint32_t first =
                block.begin + patch_size * static_cast<std::uint32_t>(std::countr_zero(bits));
            for (std::uint32_t slot = first; slot < std::min(first + patch_size, block.end); ++slot)
                counts_[patches.particles[slot]] = unsearched;
        }
        left_out_[block.block] = left_out;
        drop_rest_pairs(filter, hits);
        add(hits);
    });
    return std::ranges::all_of(left_out_.span(), [](std::uint32_t left_out) { return left_out == 0; });
}

/// Searches a grid of rows for the particles left unsearched, or a grid of cubes for all.
void SelfContacts::search_grid(Parallel& parallel, CellShape shape, const RestFilter& filter,
                               float distance) {
    const PairTest test(grid_.sorted(), filter, distance);
    parallel.ranges(static_cast<std::uint32_t>(counts_.size()), [&](const BlockRange& block) {
        SlotFlags wanted;
        for (std::uint32_t slot = block.begin; slot < block.end; ++slot) {
            std::uint8_t& count = counts_[grid_.particles()[slot]];
            wanted[slot - block.begin] = shape == CellShape::cube || count == unsearched;
            if (count == unsearched) count = 0;
        }
        BlockHits hits;
        find_hits(grid_, shape, test.distance_squared, block, wanted, hits);
        drop_rest_pairs(filter, hits);
        add(hits);
        for (const std::uint32_t slot : std::span(hits.left_over).first(hits.left_over_count)) {
            const float x = grid_.x()[slot], y = grid_.y()[slot], z = grid_.z()[slot];
            const HashGrid::Near near =
                shape == CellShape::row ? grid_.near(x, y, z) : grid_.near_in_bucket(x, y, z);
            const std::uint32_t particle = grid_.particles()[slot];
            add_contacts(test, slot, std::span(near.ranges).first(near.count),
                         [&](std::uint32_t contact) { return add(particle, contact); });
        }
    });
}

void SelfContacts::search_sweep(Parallel& parallel, const RestFilter& filter, float distance) {
    const PairTest test(sweep_->sorted(), filter, distance);
    parallel.ranges(sweep_->size(), [&](const BlockRange& block) {
        SlotRanges ranges;
        sweep_->find_ranges(block, ranges);
        BlockHits hits;
        find_hits_in_ranges(test.sorted, test.distance_squared, block, ranges, hits);
        drop_rest_pairs(filter, hits);
        add(hits);
        for (const std::uint32_t slot : std::span(hits.left_over).first(hits.left_over_count)) {
            const std::uint32_t particle = test.sorted.particles[slot];
            add_contacts(test, slot, ranges.of[slot - block.begin],
                         [&](std::uint32_t contact) { return add(particle, contact); });
        }
    });
}

/// Adds to the particle's list, which ascends and has no duplicates. Returns false if it had no room.
bool SelfContacts::add(std::uint32_t particle, std::uint32_t contact) {
    std::uint8_t& count = counts_[particle];
    if (count == overflowed) return false;
    std::uint32_t* const list = &contacts_[particle * capacity];
    std::uint32_t place = count;
    while (place > 0 && list[place - 1] > contact) --place;
    if (place > 0 && list[place - 1] == contact) return true;
    if (count == capacity) {
        count = overflowed;
        return false;
    }
    for (std::uint32_t k = count; k > place; --k) list[k] = list[k - 1];
    list[place] = contact;
    ++count;
    return true;
}

void SelfContacts::add(const BlockHits& hits) {
    for (std::uint32_t k = 0; k < hits.count; ++k) add(hits.particles[k], hits.others[k]);
}

std::span<const std::uint32_t> SelfContacts::contacts(std::uint32_t particle) const noexcept {
    return {&contacts_[particle * capacity], std::min<std::uint32_t>(counts_[particle], capacity)};
}

std::size_t SelfContacts::bytes() const noexcept {
    return patches_.bytes() + grid_.bytes() + contacts_.bytes() + counts_.bytes() + displacements_.bytes() +
           velocity_changes_.bytes() + block_counts_.bytes() + left_out_.bytes() +
           (sweep_ ? sweep_->bytes() : 0);
}

}  // namespace weft
