#pragma once
// The places at which each particle occurs in a list of particles.

#include <cstdint>
#include <numeric>
#include <span>

#include "engine/memory/hooked_vector.h"

namespace weft {

class Occurrences {
  public:
    /// Particles of the list from `particles` on are stand-ins, and are left out.
    Occurrences(std::span<const std::uint32_t> list, std::uint32_t particles) : offsets_(particles + 1) {
        for (const std::uint32_t i : list)
            if (i < particles) ++offsets_[i + 1];
        std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
        places_.resize(offsets_.back());
        HookedVector<std::uint32_t> next = offsets_;
        for (std::uint32_t at = 0; at < list.size(); ++at)
            if (list[at] < particles) places_[next[list[at]]++] = at;
    }

    /// The particle's places in the list, ascending.
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t particle) const noexcept {
        return std::span(places_).subspan(offsets_[particle], offsets_[particle + 1] - offsets_[particle]);
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return (offsets_.size() + places_.size()) * sizeof(std::uint32_t);
    }

  private:
    HookedVector<std::uint32_t> offsets_, places_;
};

}  // namespace weft
