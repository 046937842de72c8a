#include "collision/self_contacts.h"

#include <algorithm>
#include <array>

#include "collision/search_kernels.h"
#include "engine/vector.h"

namespace weft {

namespace {

/// The pairs that a search must tell apart: closer than `distance`, and not meant to be.
class PairTest {
  public:
    PairTest(const HashGrid& grid, const RestFilter& filter, float distance)
        : grid(grid), distance_squared(distance * distance), filter(filter) {}

    [[nodiscard]] bool is_close(std::uint32_t slot, std::uint32_t other) const {
        const float dx = grid.x()[slot] - grid.x()[other], dy = grid.y()[slot] - grid.y()[other],
                    dz = grid.z()[slot] - grid.z()[other];
        return dx * dx + dy * dy + dz * dz < distance_squared;
    }

    /// True if the pair is close in the rest shape, or joined by a spring.
    [[nodiscard]] bool is_left_alone(std::uint32_t i, std::uint32_t j) const {
        if (!filter.rest_positions.empty()) {
            const Vector3 apart = xyz(filter.rest_positions[i]) - xyz(filter.rest_positions[j]);
            if (apart.squaredNorm() < distance_squared) return true;
        }
        if (filter.offsets.empty()) return false;
        const auto springs =
            filter.neighbours.subspan(filter.offsets[i], filter.offsets[i + 1] - filter.offsets[i]);
        return std::find(springs.begin(), springs.end(), j) != springs.end();
    }

    const HashGrid& grid;
    float distance_squared;

  private:
    const RestFilter& filter;
};

/// The contacts of one particle, ascending and without duplicates.
class ContactList {
  public:
    ContactList(std::uint32_t* contacts, std::uint8_t& count) : contacts_(contacts), count_(count) {}

    /// False if there was no room.
    bool add(std::uint32_t contact) {
        if (count_ > SelfContacts::capacity) return false;
        std::uint32_t place = count_;
        while (place > 0 && contacts_[place - 1] > contact) --place;
        if (place > 0 && contacts_[place - 1] == contact) return true;
        if (count_ == SelfContacts::capacity) {
            count_ = SelfContacts::capacity + 1;
            return false;
        }
        for (std::uint32_t k = count_; k > place; --k) contacts_[k] = contacts_[k - 1];
        contacts_[place] = contact;
        ++count_;
        return true;
    }

  private:
    std::uint32_t* contacts_;
    std::uint8_t& count_;
};

/// Shows `visit` the slots of a range, until it says false; returns what it said last. From a slot in the
/// range it goes outward: particles crowded at one point then fill their lists with one another, not all with
/// the same few.
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

/// It ends when the list is full, so that even n particles at one point cost no more than n times its
/// capacity.
void add_contacts(const PairTest& test, std::uint32_t slot, std::span<const SlotRange> ranges,
                  ContactList list) {
    const std::uint32_t particle = test.grid.particles()[slot];
    const auto add_if_close = [&](std::uint32_t other) {
        if (!test.is_close(slot, other)) return true;
        const std::uint32_t contact = test.grid.particles()[other];
        return test.is_left_alone(particle, contact) || list.add(contact);
    };
    for (const SlotRange& range : ranges) {
        if (!visit_from(slot, range, add_if_close)) return;
    }
}

}  // namespace

SelfContacts::SelfContacts(std::uint32_t particle_count)
    : grid_(particle_count),
      contacts_(particle_count * capacity),
      counts_(particle_count),
      displacements_(particle_count),
      velocity_changes_(particle_count),
      block_counts_(block_count(particle_count)) {}

void SelfContacts::find(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds,
                        const RestFilter& filter, float distance, SelfCollisionSearch search) {
    parallel.ranges(static_cast<std::uint32_t>(counts_.size()), [&](const BlockRange& block) {
        std::fill(&counts_[block.begin], &counts_[block.end], std::uint8_t{0});
    });
    if (search == SelfCollisionSearch::exact) {
        grid_.build_rows(parallel, positions, bounds, distance);
        search_grid(parallel, CellShape::row, filter, distance);
        return;
    }
    for (const float shift : {0.0f, 0.5f}) {  // Kang, section IV: each particle against its own bucket
        grid_.build_cubes(parallel, positions, bounds, distance, shift);
        search_grid(parallel, CellShape::cube, filter, distance);
    }
}

void SelfContacts::search_grid(Parallel& parallel, CellShape shape, const RestFilter& filter,
                               float distance) {
    const PairTest test(grid_, filter, distance);
    const auto list_of = [&](std::uint32_t particle) {
        return ContactList(&contacts_[particle * capacity], counts_[particle]);
    };
    parallel.ranges(static_cast<std::uint32_t>(counts_.size()), [&](const BlockRange& block) {
        BlockHits hits;
        find_hits(grid_, shape, test.distance_squared, block, hits);
        drop_rest_pairs(filter, test.distance_squared, hits);
        for (std::uint32_t k = 0; k < hits.count; ++k) list_of(hits.particles[k]).add(hits.others[k]);
        for (const std::uint32_t slot : std::span(hits.left_over).first(hits.left_over_count)) {
            const float x = grid_.x()[slot], y = grid_.y()[slot], z = grid_.z()[slot];
            const HashGrid::Near near =
                shape == CellShape::row ? grid_.near(x, y, z) : grid_.near_in_bucket(x, y, z);
            add_contacts(test, slot, std::span(near.ranges).first(near.count),
                         list_of(grid_.particles()[slot]));
        }
    });
}

std::span<const std::uint32_t> SelfContacts::contacts(std::uint32_t particle) const noexcept {
    return {&contacts_[particle * capacity], std::min<std::uint32_t>(counts_[particle], capacity)};
}

std::size_t SelfContacts::bytes() const noexcept {
    return grid_.bytes() + contacts_.bytes() + counts_.bytes() + displacements_.bytes() +
           velocity_changes_.bytes() + block_counts_.bytes();
}

}  // namespace weft
