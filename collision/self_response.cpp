#include <algorithm>

#include "collision/coulomb.h"
#include "collision/self_contacts.h"
#include "engine/separating_direction.h"
#include "engine/vector.h"

namespace weft {

namespace {

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
        const Vector3 stopped = stopped_by_friction(sliding, settings.friction * approach);
        response.kick = (approach * normal - stopped) / mobility;
        response.push = stopped * (-settings.h / mobility);
    }
    response.push += normal * (std::max(0.0f, settings.distance - length) / mobility);
    return response;
}

}  // namespace

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

}  // namespace weft
