#include "collision/contact/pairs/narrowing.h"

#include <algorithm>

#include "collision/contact/pairs/pair_kernels.h"

namespace weft {

namespace {

/// A list's range of pairs of one kind.
struct Section {
    std::uint32_t begin, end;

    [[nodiscard]] std::uint32_t blocks() const { return block_count(end - begin); }
    [[nodiscard]] std::uint32_t begin_of(std::uint32_t block) const { return begin + block * block_size; }
};

}  // namespace

void PairNarrowing::lay_out(Scratch& scratch, std::size_t pairs) {
    scratch.take(kept_, block_count(static_cast<std::uint32_t>(pairs)) + 2);
}

void PairNarrowing::narrow(Parallel& parallel, std::span<const Vec4> positions, std::span<const Vec4> motions,
                           float reach, float longest, PairList& list) {
    const Section of_vertices{0, list.vertex_triangle}, of_edges{list.vertex_triangle, list.size};
    std::uint32_t size = 0;
    const auto narrow_section = [&](const Section& section, bool vertex_triangle) {
        parallel.blocks(section.blocks(), [&](std::uint32_t block) {
            const std::uint32_t begin = section.begin_of(block);
            kept_[block] =
                narrow_pairs({positions.data(), motions.data(), reach, longest}, vertex_triangle,
                             list.pairs.span().subspan(begin, std::min(block_size, section.end - begin)),
                             list.shapes.data() + begin);
        });
        for (std::uint32_t block = 0; block < section.blocks(); ++block) {
            const std::uint32_t begin = section.begin_of(block), count = kept_[block];
            std::copy_n(list.pairs.data() + begin, count, list.pairs.data() + size);
            std::copy_n(list.shapes.data() + begin, count, list.shapes.data() + size);
            size += count;
        }
    };
    narrow_section(of_vertices, true);
    list.vertex_triangle = size;
    narrow_section(of_edges, false);
    list.size = size;
}

}  // namespace weft
