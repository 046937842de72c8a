#pragma once
// A part of a step, and what a thread has to itself while it works on it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/contact/contact_log.h"
#include "collision/colliders/collider_contacts.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// One of the equal parts that a step is cut into.
struct Substep {
    int index, count;  ///< of how many in the step
    float h;           ///< [s]

    /// One of `parts` of this one.
    [[nodiscard]] Substep part(int k, int parts, float step) const {
        const int of_all = count * parts;
        return {index * parts + k, of_all, step / static_cast<float>(of_all)};
    }
    /// So many times as long.
    [[nodiscard]] Substep times(float longer) const { return {index, count, longer * h}; }
    [[nodiscard]] bool is_first() const { return index == 0; }
    [[nodiscard]] bool is_last() const { return index + 1 == count; }
    /// Where it begins and ends, as parts of the step.
    [[nodiscard]] float begin() const { return static_cast<float>(index) / static_cast<float>(count); }
    [[nodiscard]] float end() const { return static_cast<float>(index + 1) / static_cast<float>(count); }
    bool operator==(const Substep&) const = default;
};

/// A worker is a thread with what it has to itself while it works on one group of cloths after the other.
struct Worker {
    Parallel& parallel;                    ///< of all threads, or of this one alone
    std::vector<ColliderMotion>& motions;  ///< one per collider, over the present substep
    ContactLog& contacts;                  ///< to be reported
    std::byte* scratch = nullptr;          ///< for the group that it works on
    /// The motions are of colliders that have one of these layers and that no body carries, over this
    /// substep; of a substep of no length while they are of anything else.
    std::uint32_t seen_layers = 0;
    Substep seen_over{0, 0, 0};
};

}  // namespace weft
