#pragma once
// Detection: which features of bodies of triangles are near, or are brought together by a motion.

#include <cstdint>
#include <ranges>
#include <span>

#include "collision/contact/pairs/contact_mesh.h"
#include "collision/contact/pairs/crossings.h"
#include "collision/contact/pairs/pair_kernels.h"
#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"

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

/// The parts of their motions that particles may go, by which searches pass over neighbours in a chart.
enum class Parts : std::uint8_t {
    any,    ///< each particle its own part
    alike,  ///< all particles the same part; find_opened() adds what else may come within reach
};

class PairFinder {
  public:
    /// For searches of bodies of these meshes, or of a part of them, whatever their reach and positions.
    template <std::ranges::range Bodies>
    void lay_out(Scratch& scratch, const Bodies& bodies) {
        Room room;
        for (const auto& body : bodies) room.add(*body.mesh);
        lay_out(scratch, room);
    }

    /// Lists every pair of features that share no vertex, of bodies that may meet, with
    ///     min over A of min(n . x, n . (x + m)) - max over B of max(n . x, n . (x + m)) < reach,
    /// n being the normal of the pair's closest points at x: those that can come nearer than reach, if each
    /// particle goes any part of its own motion m. Of pairs whose closest points are at a border
    /// (PairShape::is_at_border) the reach is the part `of_borders`. positions[i].w is ignored. Both spans
    /// are of all bodies' particles. Pairs whose boxes over the motion are farther apart than reach are not
    /// looked at. Features with a coordinate that is not finite, at x or at x + m, are in no pair. Where
    /// `parts` are alike, the list lacks pairs of patches that stay apart by the law of FlatRest.
    ///
    /// Where there are more pairs than room, the list holds what `full` says, and the search counts at most
    /// as many of each kind as there is room for.
    ///
    /// Precondition: laid out for these bodies.
    void find(Parallel& parallel, std::span<const ContactBody> bodies, std::span<const Vec4> positions,
              std::span<const Vec4> motions, PairList& found, float of_borders = 1,
              FullList full = FullList::has_the_first, Parts parts = Parts::any);

    /// Marks of particles, bits: the list may lack pairs of it; the last search passed over neighbours for
    /// another motion of it.
    static constexpr std::uint8_t is_unlisted = 1, has_strayed = 2;

    /// Adds to the list what find() with Parts::alike would list of pairs of patches of which at least one
    /// has a particle that is_unlisted, and of those that the last search passed over and this one does not,
    /// of which at least one has a particle that has_strayed. Some of these may be in the list already, and
    /// then are so twice. A list that would overflow is empty.
    ///
    /// Precondition: neighbours that the last search passed over still stay apart if no particle of theirs
    /// has_strayed. With the reach R, motions m and the same positions that search found their features R
    /// apart all the way. So a particle may end (R - reach) / 2 from m: no point goes farther from its way.
    void find_more(Parallel& parallel, std::span<const ContactBody> bodies, std::span<const Vec4> positions,
                   std::span<const Vec4> motions, std::span<const std::uint8_t> marks, PairList& list);

    /// Looks again at what the last search for pairs passed over, with the same positions and motions, once
    /// each particle goes a part of its own: `cut` has what is left of the motions. Only neighbours of which
    /// a particle is cut are asked for: features of others still go the way that keeps them apart, whatever
    /// the triangles between them do. Adds the pairs of patches that may not stay apart then, as find() lists
    /// them. Returns whether there are such patches.
    bool find_opened(Parallel& parallel, std::span<const ContactBody> bodies, std::span<const Vec4> positions,
                     std::span<const Vec4> motions, std::span<const Vec4> cut, PairList& list);

    /// Whether searches can pass over neighbours in a chart.
    [[nodiscard]] bool has_charts() const noexcept { return boxes_.neighbours.size() > 0; }

    /// Lists every edge and triangle that share no vertex, of bodies that may meet, and that cross: the
    /// edge's ends are strictly on different sides of the triangle's plane, and the line through them meets
    /// the triangle. Exact: no rounding adds or hides a crossing. An edge that ends on the triangle or lies
    /// in its plane touches it and crosses nothing. Otherwise as find().
    void find_crossings(Parallel& parallel, std::span<const ContactBody> bodies,
                        std::span<const Vec4> positions, CrossingList& found);

    /// Pairs that the last search for pairs counted, listed or not: its work. Where the list was full this
    /// depends on threads.
    [[nodiscard]] std::uint64_t counted() const noexcept { return fill_.found(); }

  private:
    /// How many pairs a block has, and where its first ones go in the list.
    struct BlockPairs {
        std::uint32_t vertex_triangle, edge_edge;
        std::uint32_t first_vertex_triangle, first_edge_edge;
    };

    /// How much of each array bodies take: groups of sixteen slots of each kind, and of triangles in charts,
    /// neighbours of patches, blocks.
    struct Room {
        std::size_t bodies = 0, vertices = 0, triangles = 0, edges = 0, gradients = 0, neighbours = 0,
                    blocks = 0;
        void add(const ContactMesh& mesh);
    };
    void lay_out(Scratch& scratch, const Room& room);
    void choose(std::span<const ContactBody> bodies);
    /// A search of the bodies that were chosen.
    [[nodiscard]] PairSearch search_of(std::span<const Vec4> positions, const Vec4* motions,
                                       float of_borders) const;
    void search(Parallel& parallel, const PairSearch& search, PairList& found, FullList full);
    /// A search round particles i with marks_of(i), for all the same part of these motions.
    [[nodiscard]] PairSearch search_of_marked(Parallel& parallel, std::span<const Vec4> positions,
                                              const Vec4* motions, const auto& marks_of);
    /// Places the boxes of patches.
    void place(Parallel& parallel, const PairSearch& search);
    /// Finds which neighbours are calm, of those that the search asks for.
    void ask_neighbours(Parallel& parallel, const PairSearch& search);
    /// Finds which patches the search looks at, and places the boxes of their features.
    void want(Parallel& parallel, const PairSearch& search);
    /// Lists the pairs of a search, once patches are placed and neighbours asked for.
    void list_pairs(Parallel& parallel, const PairSearch& search, PairList& found, FullList full);
    [[nodiscard]] FoundPairs room_of(std::uint32_t block);
    void find_block(const PairSearch& search, std::uint32_t block, FoundPairs& pairs) const;
    void count_pairs(Parallel& parallel, const PairSearch& search, std::uint32_t capacity, FullList full);
    void number(PairList& found);
    /// Adds a block's pairs to the list; they are searched once more where they are many.
    void write(const PairSearch& search, std::uint32_t block, PairList& found);

    std::size_t body_count_ = 0;                           // that were chosen
    std::uint32_t block_count_ = 0, neighbour_count_ = 0;  // theirs
    ScratchArray<SearchedBody> bodies_;
    ScratchArray<PatchBlock> blocks_;
    ScratchArray<std::uint8_t> is_calm_;  // by block: nothing to look at
    FeatureBoxes boxes_;
    ScratchArray<Neighbours> of_crossings_;  // what a search for crossings knows of neighbours
    ScratchArray<FeaturePair> room_;         // for the pairs of each block, until all are counted
    ScratchArray<BlockPairs> block_pairs_;
    ListFill fill_;
    ScratchArray<Crossing> crossing_room_;
    ScratchArray<std::uint32_t> block_crossings_;

    ScratchArray<std::uint16_t> only_, strayed_;  // by block: see PairSearch::only
};

}  // namespace weft
