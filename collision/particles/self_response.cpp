#include <algorithm>
#include <cstring>

#include "collision/particles/pair_response.h"
#include "collision/particles/self_contacts.h"
#include "engine/vector.h"

namespace weft {

/// A pair is resolved if each is in the other's list, so that one gains what the other loses. Only a list
/// that had no room for all can lack a contact.
bool SelfContacts::is_mutual(std::uint32_t particle, std::uint32_t contact) const noexcept {
    if (counts_[contact] != overflowed) return true;
    const auto list = contacts(contact);
    return std::binary_search(list.begin(), list.end(), particle);
}

/// Adds a pair that is to be resolved, with a free particle first. Returns whether it was added.
bool SelfContacts::add_pair(std::uint32_t i, std::uint32_t j, std::span<const Vec4> positions,
                            PairBatch& batch) const {
    if (positions[i].w + positions[j].w <= 0 || !is_mutual(i, j)) return false;
    const bool swapped = !(positions[i].w > 0);
    batch.i[batch.count] = swapped ? j : i;
    batch.j[batch.count] = swapped ? i : j;
    batch.sharers[batch.count++] = static_cast<float>(std::max(contacts(i).size(), contacts(j).size()));
    return true;
}

/// Calls visit(i) for the particles of a block that have contacts, in ascending order. Most have none, and
/// are skipped eight at a time.
template <class Visit>
void SelfContacts::for_each_touching(const BlockRange& block, const Visit& visit) const {
    constexpr std::uint32_t step = sizeof(std::uint64_t);
    static_assert(AlignedBuffer<std::uint8_t>::group % step == 0, "behind the last particle are zeros");
    for (std::uint32_t i = block.begin; i < block.end; i += step) {
        std::uint64_t counts;
        std::memcpy(&counts, &counts_[i], sizeof counts);
        if (counts == 0) continue;
        for (std::uint32_t k = i; k < i + step; ++k) {
            if (counts_[k] > 0) visit(k);
        }
    }
}

// Every pair's response is scaled by 1 / (contacts of the one of its particles that has more): a particle
// takes no more than the mean of what its contacts ask for, and both particles of a pair take the same share.
SelfContactCounts SelfContacts::respond(Parallel& parallel, float distance, float friction, float h,
                                        std::span<Vec4> positions, std::span<Vec4> velocities) {
    const ResponseSettings settings{distance, friction, h};

    // A particle's pairs follow one another, in the order of its list, and are all in one batch.
    const auto resolve = [&](PairBatch& batch) {
        respond_to_pairs(settings, positions.data(), velocities.data(), batch);
        for (std::uint32_t k = 0; k < batch.count;) {
            const std::uint32_t i = batch.i[k];
            Vector4 displacement = Vector4::Zero(), velocity_change = Vector4::Zero();
            for (; k < batch.count && batch.i[k] == i; ++k) {
                displacement += load(batch.displacement[k]);
                velocity_change += load(batch.velocity_change[k]);
            }
            store(displacements_[i], displacement);
            store(velocity_changes_[i], velocity_change);
        }
        batch.count = 0;
    };
    const auto gather_block = [&](const BlockRange& block) {
        SelfContactCounts counts;
        PairBatch batch;
        for_each_touching(block, [&](std::uint32_t i) {
            displacements_[i] = velocity_changes_[i] = {};
            const auto list = contacts(i);
            for (const std::uint32_t j : list) {
                if (positions[i].w + positions[j].w <= 0 || !is_mutual(i, j)) continue;
                batch.i[batch.count] = i;
                batch.j[batch.count] = j;
                batch.sharers[batch.count++] = static_cast<float>(std::max(list.size(), contacts(j).size()));
                counts.pairs += i < j ? 1 : 0;
            }
            counts.dropped += counts_[i] == overflowed ? 1 : 0;
            counts.peak = std::max(counts.peak, static_cast<std::uint32_t>(list.size()));
            if (batch.count > PairBatch::capacity - capacity) resolve(batch);
        });
        resolve(batch);
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
        for_each_touching(block, [&](std::uint32_t i) {
            store(positions[i], load(positions[i]) + load(displacements_[i]));
            store(velocities[i], load(velocities[i]) + load(velocity_changes_[i]));
        });
    });
    return counts;
}

}  // namespace weft
