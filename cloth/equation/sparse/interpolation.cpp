#include "cloth/equation/sparse/interpolation.h"

#include "cloth/equation/sparse/stencil.h"

namespace weft {

Interpolation::Interpolation(std::uint32_t fine_count, std::uint32_t coarse_count)
    : fine(fine_count),
      coarse(coarse_count),
      nodes(std::size_t{width} * Stencil::whole_groups(fine_count)),
      weights(nodes.size()) {}

std::size_t Interpolation::bytes() const noexcept {
    return nodes.bytes() + weights.bytes() + kept.size() * sizeof(std::uint32_t) + offsets.bytes() +
           entries.bytes();
}

}  // namespace weft
