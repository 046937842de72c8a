#pragma once
// Detection of pairs of features, of bodies of triangles, that are near or that a motion brings together.

#include <cstdint>
#include <ranges>
#include <span>

#include "collision/contact/mesh/contact_mesh.h"
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
    float reach;               ///< search radius [m]; a pair of two bodies has the mean of theirs
    std::uint32_t layer = 1;   ///< bits: the layers that it is in
    std::uint32_t mask = ~0u;  ///< bits: the layers that it meets; two bodies meet if both masks allow it
    bool meets_itself = true;
};

/// The fractions of their motions that particles may move; searches skip neighbours in a chart by them.
enum class Parts : std::uint8_t {
    any,    ///< each particle a fraction of its own
    alike,  ///< all particles the same fraction; find_opened() adds other pairs that may come within reach
};

class PairFinder {
  public:
    /// Reserves memory to search bodies of these meshes, or some of them, at any reach and positions, with
    /// lists of so many pairs.
    template <std::ranges::range Bodies>
    void lay_out(Scratch& scratch, const Bodies& bodies, std::size_t pairs) {
        lay_out_boxes(scratch, bodies);
        lay_out_pool(scratch, pairs);
    }
    /// lay_out() in two parts: what later searches need of earlier ones, and memory for during a search only.
    template <std::ranges::range Bodies>
    void lay_out_boxes(Scratch& scratch, const Bodies& bodies) {
        Room room;
        for (const auto& body : bodies) room.add(*body.mesh);
        lay_out_boxes(scratch, room);
    }
    void lay_out_pool(Scratch& scratch, std::size_t pairs) {
        pool_.lay_out(scratch, pairs, 2 * blocks_.size());
    }

    /// Lists every pair of features that share no vertex, of bodies that may meet, with
    ///     min over A of min(n . x, n . (x + m)) - max over B of max(n . x, n . (x + m)) < reach,
    /// where n is the normal of the pair's closest points at x. These pairs can come nearer than reach if
    /// each particle moves any fraction of its own motion m. For pairs whose closest points are at a border
    /// (PairShape::is_at_border) the reach is multiplied by `of_borders`. positions[i].w is ignored. Both
    /// spans are of all bodies' particles. Pairs whose boxes over the motion are farther apart than reach are
    /// left out. Features with a coordinate that is not finite, at x or at x + m, are in no pair. With
    /// Parts::alike, the list lacks pairs of patches that stay apart by the law of FlatRest.
    ///
    /// If there are more pairs than room, the list holds what `full` says, and the search counts at most as
    /// many of each kind as there is room for.
    ///
    /// Precondition: lay_out() has reserved memory for these bodies.
    void find(Parallel& parallel, std::span<const ContactBody> bodies, std::span<const Vec4> positions,
              std::span<const Vec4> motions, PairList& found, float of_borders = 1,
              FullList full = FullList::has_the_first, Parts parts = Parts::any);

    /// Marks of a particle, as bits: the list may lack pairs of this particle; the last search skipped
    /// neighbours for another motion of it.
    static constexpr std::uint8_t is_unlisted = 1, has_strayed = 2;

    /// Adds pairs to the list, as find() with Parts::alike lists them, of two groups of pairs of patches:
    /// those with a particle that is_unlisted in one of both, and those with a particle that has_strayed, if
    /// the last search skipped them and this one does not. Pairs that are in the list already are then in it
    /// twice. A list that would overflow is empty.
    ///
    /// Precondition: neighbours that the last search skipped stay apart if no particle of theirs has_strayed.
    /// With reach R, motions m and the same positions, that search found their features R apart all the way.
    /// A particle may thus end (R - reach) / 2 from m: no point departs farther from its way.
    void find_more(Parallel& parallel, std::span<const ContactBody> bodies, std::span<const Vec4> positions,
                   std::span<const Vec4> motions, std::span<const std::uint8_t> marks, PairList& list);

    /// Adds the pairs that the last search for pairs skipped, but that may come within reach if each particle
    /// moves a fraction of its own. Positions and motions are those of that search, `cut` has the shortened
    /// motions. Only neighbours of which a particle is cut are tested: the features of others still move as
    /// in that search, whatever the triangles between them do. The pairs of patches that may not stay apart
    /// are listed as by find(). Returns whether there are such patches.
    bool find_opened(Parallel& parallel, std::span<const ContactBody> bodies, std::span<const Vec4> positions,
                     std::span<const Vec4> motions, std::span<const Vec4> cut, PairList& list);

    /// Whether there are meshes with charts, so that searches can skip neighbours.
    [[nodiscard]] bool has_charts() const noexcept { return boxes_.neighbours.size() > 0; }

    /// Lists every edge and triangle that share no vertex, of bodies that may meet, and that cross: the
    /// edge's ends are strictly on different sides of the triangle's plane, and the line through them meets
    /// the triangle. Exact: no rounding adds or hides a crossing. An edge that ends on the triangle or lies
    /// in its plane touches it and crosses nothing. All else is as in find().
    void find_crossings(Parallel& parallel, std::span<const ContactBody> bodies,
                        std::span<const Vec4> positions, CrossingList& found);

    /// Number of pairs that the last search for pairs counted, listed or not: a measure of its work. If the
    /// list was full, it depends on threads.
    [[nodiscard]] std::uint64_t counted() const noexcept { return fill_.found(); }

  private:
    /// A block's pairs of one kind: their number, their first chunk, and their first place in the list.
    struct BlockPairs {
        std::uint32_t count, chunk, first = 0;
    };
    /// A block's pairs of vertex and triangle, and of edges.
    struct PairsOfBothKinds {
        BlockPairs vertex_triangle, edge_edge;
    };

    /// Sizes of arrays for some bodies: groups of sixteen slots of each kind, and of triangles in charts,
    /// neighbours of patches, blocks.
    struct Room {
        std::size_t bodies = 0, vertices = 0, triangles = 0, edges = 0, gradients = 0, neighbours = 0,
                    blocks = 0;
        void add(const ContactMesh& mesh);
    };
    void lay_out_boxes(Scratch& scratch, const Room& room);
    void choose(std::span<const ContactBody> bodies);
    /// Input of a search of the chosen bodies.
    [[nodiscard]] PairSearch search_of(std::span<const Vec4> positions, const Vec4* motions,
                                       float of_borders) const;
    void search(Parallel& parallel, const PairSearch& search, PairList& found, FullList full);
    /// Input of a search with marks_of(i) as marks of particles i, and one fraction of these motions for all.
    [[nodiscard]] PairSearch search_of_marked(Parallel& parallel, std::span<const Vec4> positions,
                                              const Vec4* motions, const auto& marks_of);
    /// Fills the boxes of patches, blocks and groups.
    void place(Parallel& parallel, const PairSearch& search);
    /// Tests which neighbours are calm, for those that the search tests.
    void ask_neighbours(Parallel& parallel, const PairSearch& search);
    /// Finds the patches whose features are searched, and fills the boxes of these.
    void want(Parallel& parallel, const PairSearch& search);
    /// Lists the pairs of a search. Preconditions: place() and ask_neighbours() for the same search.
    void list_pairs(Parallel& parallel, const PairSearch& search, PairList& found, FullList full);
    void find_block(const PairSearch& search, std::uint32_t block, FoundPairs& pairs) const;
    void count_pairs(Parallel& parallel, const PairSearch& search, std::uint32_t capacity, FullList full);
    void number(PairList& found);
    /// Adds a block's pairs to the list. A block that found no room in the pool is searched again: its list
    /// is full.
    void write(const PairSearch& search, std::uint32_t block, PairList& found);

    std::size_t body_count_ = 0;                           // chosen bodies
    std::uint32_t block_count_ = 0, neighbour_count_ = 0;  // of the chosen bodies
    ScratchArray<SearchedBody> bodies_;
    ScratchArray<PatchBlock> blocks_;
    ScratchArray<std::uint8_t> is_calm_;  // by block: 1 if none of its pairs of patches is searched
    FeatureBoxes boxes_;
    ScratchArray<Neighbours> of_crossings_;  // neighbours in searches for crossings
    PairPool pool_;
    ScratchArray<PairsOfBothKinds> block_pairs_;
    ListFill fill_;
    ScratchArray<Crossing> crossing_room_;
    ScratchArray<std::uint32_t> block_crossings_;

    ScratchArray<std::uint16_t> only_, strayed_;  // by block: see PairSearch::only
};

}  // namespace weft
