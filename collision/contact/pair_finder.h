#pragma once
// Detection: which features of bodies of triangles are near, or are brought together by a motion.

#include <cstdint>
#include <span>
#include <vector>

#include "collision/contact/contact_mesh.h"
#include "collision/contact/crossings.h"
#include "collision/contact/pair_kernels.h"
#include "collision/contact/pairs.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// A body in a search: a mesh, and where its particles are among all bodies'.
struct ContactBody {
    const ContactMesh* mesh;
    std::uint32_t first;       ///< its first particle among all bodies'
    float reach;               ///< [m]; a pair of two bodies has the mean of theirs
    std::uint32_t layer = 1;   ///< bits: which layers it is in
    std::uint32_t mask = ~0u;  ///< bits: which layers it meets; two bodies meet if both masks allow it
    bool meets_itself = true;
};

class PairFinder {
  public:
    /// Takes the memory that searches of these bodies need, or of a part of them, whatever their reach and
    /// positions.
    void reserve(std::span<const ContactBody> bodies);
    /// Whether what is reserved does for these, too. May throw.
    [[nodiscard]] bool has_room_for(std::span<const ContactBody> bodies);

    /// Lists every pair of features that share no vertex, of bodies that may meet, with
    ///     min over A of min(n . x, n . (x + m)) - max over B of max(n . x, n . (x + m)) < reach,
    /// n being the normal of the pair's closest points at x: those that can come nearer than reach, if each
    /// particle goes any part of its own motion m. Of pairs whose closest points are at a border
    /// (PairShape::is_at_border) the reach is the part `of_borders`. positions[i].w is ignored. Both spans
    /// are of all bodies' particles. Pairs whose boxes over the motion are farther apart than reach are not
    /// looked at. Features with a coordinate that is not finite, at x or at x + m, are in no pair.
    ///
    /// Precondition: the bodies' meshes are among those of the last reserve(), or of has_room_for() since.
    void find(Parallel& parallel, std::span<const ContactBody> bodies, std::span<const Vec4> positions,
              std::span<const Vec4> motions, PairList& found, float of_borders = 1);

    /// Lists every edge and triangle that share no vertex, of bodies that may meet, and that cross: the
    /// edge's ends are on different sides of the triangle's plane, and the line through them meets the
    /// triangle. An edge in the plane crosses nothing. Otherwise as find().
    void find_crossings(Parallel& parallel, std::span<const ContactBody> bodies,
                        std::span<const Vec4> positions, CrossingList& found);

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// How many pairs a block has, and where its first ones go in the list.
    struct BlockPairs {
        std::uint32_t vertex_triangle, edge_edge;
        std::uint32_t first_vertex_triangle, first_edge_edge;
    };

    /// How many groups of sixteen the slots of each kind take, and how many neighbours patches have.
    struct Groups {
        std::uint32_t vertices = 0, triangles = 0, edges = 0, neighbours = 0;
    };
    Groups choose(std::span<const ContactBody> bodies);
    Groups reserved_;
    std::size_t reserved_blocks_ = 0;
    void place(Parallel& parallel, const PairSearch& search);
    [[nodiscard]] FoundPairs room_of(std::uint32_t block);
    void count_pairs(Parallel& parallel, const PairSearch& search, std::uint32_t capacity);
    void number(PairList& found);
    void write(const PairSearch& search, std::uint32_t block, PairList& found);

    std::vector<SearchedBody> bodies_;
    std::vector<PatchBlock> blocks_;
    std::vector<std::uint8_t> is_calm_;  // by block: nothing to look at
    FeatureBoxes boxes_;
    AlignedBuffer<FeaturePair> room_;  // for the pairs of each block, until all are counted
    std::vector<BlockPairs> block_pairs_;
    AlignedBuffer<Crossing> crossing_room_;
    std::vector<std::uint32_t> block_crossings_;
};

}  // namespace weft
