#pragma once
// A part of a step, and the data of the thread that works on it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/contact/contact_log.h"
#include "collision/colliders/collider_contacts.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// One of the equal parts that a step is cut into.
struct Substep {
    int index, count;  ///< its number, and how many there are in the step
    float h;           ///< [s]

    /// The k-th of `parts` equal parts of this substep.
    [[nodiscard]] Substep part(int k, int parts, float step) const {
        const int of_all = count * parts;
        return {index * parts + k, of_all, step / static_cast<float>(of_all)};
    }
    /// The same substep of a step that is `longer` times as long.
    [[nodiscard]] Substep times(float longer) const { return {index, count, longer * h}; }
    [[nodiscard]] bool is_first() const { return index == 0; }
    [[nodiscard]] bool is_last() const { return index + 1 == count; }
    /// Its begin and end, as fractions of the step.
    [[nodiscard]] float begin() const { return static_cast<float>(index) / static_cast<float>(count); }
    [[nodiscard]] float end() const { return static_cast<float>(index + 1) / static_cast<float>(count); }
    bool operator==(const Substep&) const = default;
};

/// The data of one thread while it works on one group of cloths after the other.
struct Worker {
    Parallel& parallel;                    ///< of all threads, or of this one alone
    std::vector<ColliderMotion>& motions;  ///< one per collider, over the present substep
    ContactLog& contacts;                  ///< contacts to be reported
    std::byte* scratch = nullptr;          ///< for the group that it works on
    /// `motions` are those of unattached colliders with any of these layers, over this substep. A substep of
    /// length 0: they hold something else.
    std::uint32_t seen_layers = 0;
    Substep seen_over{0, 0, 0};
};

}  // namespace weft
