#include "cloth/implicit/implicit_system.h"

#include <numeric>
#include <vector>

namespace weft {

AlignedBuffer<Vec4> ImplicitSystem::all_spring_blocks(Parallel& parallel) {
    std::vector<std::uint32_t> slots(stencil().slots());
    std::iota(slots.begin(), slots.end(), 0u);
    AlignedBuffer<Vec4> blocks(stencil().neighbours.size());
    spring_blocks(parallel, slots, blocks.span());
    return blocks;
}

}  // namespace weft
