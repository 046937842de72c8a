#include "collision/self_contacts.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/vector.h"

namespace weft {

namespace {

/// The pairs that a search must tell apart: closer than `distance`, and not meant to be.
class PairTest {
  public:
    PairTest(const HashGrid& grid, const RestFilter& filter, float distance)
        : particles(grid.particles()),
          x(grid.x()),
          y(grid.y()),
          z(grid.z()),
          distance_squared(distance * distance),
          filter(filter) {}

    [[nodiscard]] bool is_close(std::uint32_t slot, std::uint32_t other) const {
        const float dx = x[slot] - x[other], dy = y[slot] - y[other], dz = z[slot] - z[other];
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

    const std::uint32_t* particles;
    const float *x, *y, *z;
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
        std::uint32_t* const end = contacts_ + count_;
        std::uint32_t* const place = std::lower_bound(contacts_, end, contact);
        if (place != end && *place == contact) return true;
        if (count_ == SelfContacts::capacity) {
            count_ = SelfContacts::capacity + 1;
            return false;
        }
        std::copy_backward(place, end, end + 1);
        *place = contact;
        ++count_;
        return true;
    }

  private:
    std::uint32_t* contacts_;
    std::uint8_t& count_;
};

/// Four floats in one register, and what a comparison makes of them: -1 where it holds. This is an extension
/// of g++ and clang.
using Lanes = float __attribute__((vector_size(16)));
using Marks = std::int32_t __attribute__((vector_size(16)));
constexpr std::uint32_t lane_count = 4;
static_assert(lane_count <= HashGrid::padding);

Lanes load(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

/// False if the ranges, among which that of the particle itself, surely hold no contact of it. So it is for
/// most particles, and here they are told from the others, without a branch that depends on the outcome. What
/// a last group of lanes covers past a range's end is at worst a false alarm, as is a crowded range.
template <std::size_t N>
bool may_have_contacts(const PairTest& test, std::uint32_t slot, const std::array<SlotRange, N>& ranges) {
    constexpr std::uint32_t crowd = 16 * lane_count;
    const float x = test.x[slot], y = test.y[slot], z = test.z[slot],
                distance_squared = test.distance_squared;
    Marks close{};
    bool crowded = false;
    for (const SlotRange& range : ranges) {
        const std::uint32_t end = std::min(range.end, range.begin + crowd);
        crowded |= range.end > end;
        std::uint32_t s = range.begin;
        do {
            const Lanes dx = load(test.x + s) - x, dy = load(test.y + s) - y, dz = load(test.z + s) - z;
            close += dx * dx + dy * dy + dz * dz < distance_squared;
            s += lane_count;
        } while (s < end);
    }
    const std::int32_t count = -(close[0] + close[1] + close[2] + close[3]);
    return crowded || count > 1;  // the particle itself is one
}

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

/// So many candidates at most are gathered without a branch that depends on the outcome.
constexpr std::uint32_t few = 32;

std::uint32_t candidates(std::span<const SlotRange> ranges) {
    std::uint32_t sum = 0;
    for (const SlotRange& range : ranges) sum += range.end - range.begin;
    return sum;
}

void add_from_few(const PairTest& test, std::uint32_t slot, std::span<const SlotRange> ranges,
                  ContactList list) {
    std::array<std::uint32_t, few + 1> close;
    std::uint32_t count = 0;
    for (const SlotRange& range : ranges) {
        for (std::uint32_t other = range.begin; other < range.end; ++other) {
            close[count] = test.particles[other];
            count += (test.is_close(slot, other) ? 1u : 0u) & (other != slot ? 1u : 0u);
        }
    }
    const std::uint32_t particle = test.particles[slot];
    for (const std::uint32_t contact : std::span(close).first(count)) {
        if (!test.is_left_alone(particle, contact) && !list.add(contact)) return;
    }
}

/// It ends when the list is full, so that even n particles at one point cost no more than n times its
/// capacity.
void add_from_crowd(const PairTest& test, std::uint32_t slot, std::span<const SlotRange> ranges,
                    ContactList list) {
    const std::uint32_t particle = test.particles[slot];
    const auto add_if_close = [&](std::uint32_t other) {
        if (!test.is_close(slot, other)) return true;
        const std::uint32_t contact = test.particles[other];
        return test.is_left_alone(particle, contact) || list.add(contact);
    };
    for (const SlotRange& range : ranges) {
        if (!visit_from(slot, range, add_if_close)) return;
    }
}

/// Adds to the list what is in contact with the particle of `slot`.
void add_contacts(const PairTest& test, std::uint32_t slot, std::span<const SlotRange> ranges,
                  ContactList list) {
    const auto add = candidates(ranges) <= few ? add_from_few : add_from_crowd;
    add(test, slot, ranges, list);
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
    std::fill_n(counts_.data(), counts_.size(), std::uint8_t{0});
    if (search == SelfCollisionSearch::exact) {
        grid_.build_rows(parallel, positions, bounds, distance);
        search_rows(parallel, filter, distance);
        return;
    }
    for (const float shift : {0.0f, 0.5f}) {
        grid_.build_cubes(parallel, positions, bounds, distance, shift);
        search_buckets(parallel, filter, distance);
    }
}

void SelfContacts::search_rows(Parallel& parallel, const RestFilter& filter, float distance) {
    const PairTest test(grid_, filter, distance);
    const auto list_of = [&](std::uint32_t particle) {
        return ContactList(&contacts_[particle * capacity], counts_[particle]);
    };
    parallel.ranges(static_cast<std::uint32_t>(counts_.size()), [&](const BlockRange& block) {
        HashGrid::Runs runs;
        grid_.runs_of(block, runs);

        std::array<std::uint32_t, block_size> suspects;
        std::uint32_t suspect_count = 0;
        for (std::uint32_t slot = block.begin; slot < block.end; ++slot) {
            const std::uint32_t k = slot - block.begin;
            const std::array<SlotRange, 4> ranges{grid_.run(runs[0][k]), grid_.run(runs[1][k]),
                                                  grid_.run(runs[2][k]), grid_.run(runs[3][k])};
            const std::uint32_t last = std::max({runs[0][k], runs[1][k], runs[2][k], runs[3][k]});
            suspects[suspect_count] = slot;
            suspect_count += grid_.wraps(last) || may_have_contacts(test, slot, ranges) ? 1 : 0;
        }
        for (const std::uint32_t slot : std::span(suspects).first(suspect_count)) {
            const HashGrid::Near near = grid_.near(test.x[slot], test.y[slot], test.z[slot]);
            add_contacts(test, slot, std::span(near.ranges).first(near.count), list_of(test.particles[slot]));
        }
    });
}

/// Kang, section IV: each particle against its own bucket.
void SelfContacts::search_buckets(Parallel& parallel, const RestFilter& filter, float distance) {
    const PairTest test(grid_, filter, distance);
    const auto list_of = [&](std::uint32_t particle) {
        return ContactList(&contacts_[particle * capacity], counts_[particle]);
    };
    parallel.ranges(static_cast<std::uint32_t>(counts_.size()), [&](const BlockRange& block) {
        for (std::uint32_t slot = block.begin; slot < block.end; ++slot) {
            const std::array bucket{grid_.own_bucket(test.x[slot], test.y[slot], test.z[slot])};
            if (!may_have_contacts(test, slot, bucket) || counts_[test.particles[slot]] == overflowed)
                continue;
            add_contacts(test, slot, bucket, list_of(test.particles[slot]));
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
