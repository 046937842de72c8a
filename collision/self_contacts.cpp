#include "collision/self_contacts.h"

#include <algorithm>
#include <array>

#include "engine/separating_direction.h"
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

/// False if the range surely holds no contact of the particle of `slot`: so it is for most ranges, and here
/// they are told from the others. Whole groups of slots are tested, so that the compiler makes SIMD
/// instructions of the loop, and no remainder; what lies past the range's end is at worst a false alarm.
bool may_hold_contacts(const PairTest& test, std::uint32_t slot, SlotRange range) {
    constexpr std::uint32_t lanes = HashGrid::padding, crowd = 16 * lanes;
    const std::uint32_t size = range.end - range.begin;
    if (size > crowd) return true;

    const float x = test.x[slot], y = test.y[slot], z = test.z[slot],
                distance_squared = test.distance_squared;
    const float *const xs = test.x + range.begin, *const ys = test.y + range.begin,
                       *const zs = test.z + range.begin;
    const std::uint32_t tested = (std::max(size, 1u) + lanes - 1) / lanes * lanes;
    std::uint32_t close = 0;
    for (std::uint32_t k = 0; k < tested; ++k) {
        const float dx = xs[k] - x, dy = ys[k] - y, dz = zs[k] - z;
        close += dx * dx + dy * dy + dz * dz < distance_squared ? 1 : 0;
    }
    const bool with_itself = slot - range.begin < tested;
    return close > (with_itself ? 1u : 0u);
}

/// Adds the contacts of the particle of `slot` that lie in the range; false when the list is full. Where the
/// particle itself lies in the range, it looks outward from itself: particles crowded at one point then fill
/// their lists with one another, not all with the same few, and stop after O(capacity) tests.
bool add_contacts(const PairTest& test, std::uint32_t slot, SlotRange range, ContactList& list) {
    const std::uint32_t particle = test.particles[slot];
    const auto visit = [&](std::uint32_t other) {
        if (!test.is_close(slot, other)) return true;
        const std::uint32_t contact = test.particles[other];
        return test.is_left_alone(particle, contact) || list.add(contact);
    };
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

/// The opposite changes that a pair asks for, as i feels them. Times inverse mass they are a displacement and
/// a change of velocity.
struct PairResponse {
    Vector3 push = Vector3::Zero();
    Vector3 kick = Vector3::Zero();
};

struct ResponseSettings {
    float distance, friction, h;
};

/// Kang, section IV, equations 8 to 10, about the pair's centre of mass and to the stated distance (equation
/// 8 read literally doubles it). Coulomb friction is limited by the normal impulse of equation 10 alone: if
/// it counted the push as an impulse too, layers that stay overlapped would stick together, and the more so
/// the shorter the step. What friction changes in the velocity it changes in the step's motion too, so that
/// layers at rest do not creep.
///
/// Exchanging the particles exchanges signs and nothing else, to the last bit.
PairResponse pair_response(std::uint32_t i, std::uint32_t j, const ResponseSettings& settings,
                           const Vec4& position_i, const Vec4& position_j, const Vec4& velocity_i,
                           const Vec4& velocity_j) {
    const Vector3 apart = xyz(position_i) - xyz(position_j);
    const float length = apart.norm();
    const bool coincident = length <= 1e-6f * settings.distance;
    const Vector3 normal = coincident ? separating_direction(i, j) : Vector3(apart / length);
    const float mobility = position_i.w + position_j.w;

    const Vector3 relative = xyz(velocity_i) - xyz(velocity_j);
    const float approach = -relative.dot(normal);
    PairResponse response;
    if (approach > 0) {
        const Vector3 sliding = relative + approach * normal;
        const float speed = sliding.norm(), limit = settings.friction * approach;
        const Vector3 stopped = speed > limit ? Vector3(sliding * (limit / speed)) : sliding;
        response.kick = (approach * normal - stopped) / mobility;
        response.push = stopped * (-settings.h / mobility);
    }
    response.push += normal * (std::max(0.0f, settings.distance - length) / mobility);
    return response;
}

}  // namespace

SelfContacts::SelfContacts(std::uint32_t particle_count, int /*width*/)
    : grid_(particle_count),
      contacts_(particle_count * capacity),
      counts_(particle_count),
      displacements_(particle_count),
      velocity_changes_(particle_count),
      block_counts_(block_count(particle_count)) {}

void SelfContacts::find(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds,
                        const RestFilter& filter, float distance, SelfCollisionSearch search) {
    if (search == SelfCollisionSearch::exact) {
        grid_.build_rows(parallel, positions, bounds, distance);
        search_rows(parallel, filter, distance);
        return;
    }
    std::fill_n(counts_.data(), counts_.size(), std::uint8_t{0});
    for (const float shift : {0.0f, 0.5f}) {
        grid_.build_cubes(parallel, positions, bounds, distance, shift);
        search_buckets(parallel, filter, distance);
    }
}

void SelfContacts::search_rows(Parallel& parallel, const RestFilter& filter, float distance) {
    const PairTest test(grid_, filter, distance);
    parallel.ranges(static_cast<std::uint32_t>(counts_.size()), [&](const BlockRange& block) {
        for (std::uint32_t slot = block.begin; slot < block.end; ++slot) {
            const std::uint32_t particle = test.particles[slot];
            counts_[particle] = 0;
            ContactList list(&contacts_[particle * capacity], counts_[particle]);
            const HashGrid::Near near = grid_.near(test.x[slot], test.y[slot], test.z[slot]);
            for (const SlotRange& range : std::span(near.ranges.data(), near.count)) {
                if (may_hold_contacts(test, slot, range) && !add_contacts(test, slot, range, list)) break;
            }
        }
    });
}

/// Kang, section IV: each particle against its own bucket.
void SelfContacts::search_buckets(Parallel& parallel, const RestFilter& filter, float distance) {
    const PairTest test(grid_, filter, distance);
    parallel.ranges(static_cast<std::uint32_t>(counts_.size()), [&](const BlockRange& block) {
        for (std::uint32_t slot = block.begin; slot < block.end; ++slot) {
            const std::uint32_t particle = test.particles[slot];
            if (counts_[particle] == overflowed) continue;
            const SlotRange bucket = grid_.own_bucket(test.x[slot], test.y[slot], test.z[slot]);
            if (!may_hold_contacts(test, slot, bucket)) continue;
            ContactList list(&contacts_[particle * capacity], counts_[particle]);
            add_contacts(test, slot, bucket, list);
        }
    });
}

std::span<const std::uint32_t> SelfContacts::contacts(std::uint32_t particle) const noexcept {
    return {&contacts_[particle * capacity], std::min<std::uint32_t>(counts_[particle], capacity)};
}

/// A pair is resolved if each is in the other's list, so that what one gains the other loses. Only a list
/// that had no room for all can lack a contact.
bool SelfContacts::is_mutual(std::uint32_t particle, std::uint32_t contact) const noexcept {
    if (counts_[contact] != overflowed) return true;
    const auto list = contacts(contact);
    return std::binary_search(list.begin(), list.end(), particle);
}

// Every pair's response is scaled by 1 / (contacts of the one of its particles that has more): a particle
// takes no more than the mean of what its contacts ask for, and both particles of a pair take the same share.
SelfContactCounts SelfContacts::respond(Parallel& parallel, float distance, float friction, float h,
                                        std::span<Vec4> positions, std::span<Vec4> velocities) {
    const ResponseSettings settings{distance, friction, h};

    const auto gather = [&](std::uint32_t i, SelfContactCounts& counts) {
        Vector3 displacement = Vector3::Zero(), velocity_change = Vector3::Zero();
        const auto list = contacts(i);
        for (const std::uint32_t j : list) {
            if (positions[i].w + positions[j].w <= 0 || !is_mutual(i, j)) continue;
            const PairResponse response =
                pair_response(i, j, settings, positions[i], positions[j], velocities[i], velocities[j]);
            const float share =
                positions[i].w / static_cast<float>(std::max(list.size(), contacts(j).size()));
            displacement += response.push * share;
            velocity_change += response.kick * share;
            counts.pairs += i < j ? 1 : 0;
        }
        displacements_[i] = to_vec4(displacement, 0);
        velocity_changes_[i] = to_vec4(velocity_change, 0);
        counts.dropped += counts_[i] == overflowed ? 1 : 0;
        counts.peak = std::max(counts.peak, static_cast<std::uint32_t>(list.size()));
    };
    const auto gather_block = [&](const BlockRange& block) {
        SelfContactCounts counts;
        for (std::uint32_t i = block.begin; i < block.end; ++i) {
            if (counts_[i] > 0) gather(i, counts);
        }
        return counts;
    };
    const auto add = [](const SelfContactCounts& a, const SelfContactCounts& b) {
        return SelfContactCounts{a.pairs + b.pairs, a.dropped + b.dropped, std::max(a.peak, b.peak)};
    };

    const auto n = static_cast<std::uint32_t>(positions.size());
    const SelfContactCounts counts =
        parallel.reduce(n, block_counts_.span(), SelfContactCounts{}, gather_block, add);
    if (counts.pairs == 0) return counts;
    parallel.ranges(n, [&](const BlockRange& block) {
        for (std::uint32_t i = block.begin; i < block.end; ++i) {
            if (counts_[i] == 0) continue;
            set_xyz(positions[i], xyz(positions[i]) + xyz(displacements_[i]));
            set_xyz(velocities[i], xyz(velocities[i]) + xyz(velocity_changes_[i]));
        }
    });
    return counts;
}

std::size_t SelfContacts::bytes() const noexcept {
    return grid_.bytes() + contacts_.bytes() + counts_.bytes() + displacements_.bytes() +
           velocity_changes_.bytes() + block_counts_.bytes();
}

}  // namespace weft
