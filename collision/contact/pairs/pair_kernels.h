#pragma once
// Kernels for boxes of features and for pairs of near ones, many at a time; compiled once for each kind of
// machine. See pair_finder.h.

#include <cstdint>
#include <span>

#include "collision/contact/mesh/contact_mesh.h"
#include "collision/contact/pairs/crossings.h"
#include "collision/contact/pairs/list_fill.h"
#include "collision/contact/pairs/pair_pool.h"
#include "collision/contact/pairs/pairs.h"
#include "collision/search/patch_kernels.h"
#include "weft/types.h"

namespace weft {

/// Whether two bodies meet: each one's mask has a bit of the other's layers.
constexpr bool masks_allow(std::uint32_t layers_a, std::uint32_t mask_a, std::uint32_t layers_b,
                           std::uint32_t mask_b) {
    return (mask_a & layers_b) != 0 && (mask_b & layers_a) != 0;
}

/// A body's data in a search; the offsets are into arrays of all bodies.
struct SearchedBody {
    const ContactMesh* mesh;
    std::uint32_t first;  ///< its first particle among all bodies'
    float reach;          ///< search radius [m]
    std::uint32_t layer, mask;
    bool meets_itself;
    /// First groups of boxes of its vertices, triangles and edges.
    std::uint32_t first_vertex_group, first_triangle_group, first_edge_group;
    std::uint32_t first_block;
    std::uint32_t first_gradients;   ///< first group of its triangles' gradients, if it has charts
    std::uint32_t first_neighbours;  ///< first of its FlatRest's pairs
};
/// Margin by which the boxes of a body's features are grown [m].
constexpr float half_reach_of(const SearchedBody& body) {
    return 0.5f * body.reach * (1 + 1e-6f);
}

/// Up to sixteen patches of a body: the unit of work of a thread.
struct PatchBlock {
    static constexpr std::uint32_t most = 16;

    std::uint32_t body, first_patch, patch_count;
};

/// Gradients of sixteen slots of triangles, x, y and z along each axis of the chart, at the start and at the
/// end of the motion. Gradients so large that rounding matters are not a number.
struct TriangleGradients {
    alignas(64) float start[6][16], end[6][16];
};

/// Result of a search for two patches that are neighbours.
enum class Neighbours : std::uint8_t {
    looked_at,  ///< their features are searched
    calm,       ///< no features of theirs come within reach: their features are skipped
    opened,     ///< their features are searched, and the search before skipped them
};

/// Boxes over the motion, grown by half the reach: those of features within the mean reach of both overlap.
struct FeatureBoxes {
    ScratchArray<Boxes> vertices, triangles, edges;  ///< by slot of the meshes
    /// Boxes of patches, sixteen to each block, of blocks, and of groups of sixteen blocks.
    ScratchArray<Boxes> patches, blocks, groups;
    ScratchArray<PatchStrain> strains;  ///< by patch, sixteen to each block
    ScratchArray<TriangleGradients> gradients;
    /// By group of triangles: 1 where a search with marks needs the gradients.
    ScratchArray<std::uint8_t> wanted_gradients;
    ScratchArray<Neighbours> neighbours;  ///< by pair of neighbours
    /// By patch: 1 where the boxes of its features are filled, because another patch is near.
    ScratchArray<std::uint8_t> wanted;
};

/// Input of a search. `motions` is null if nothing moves.
struct PairSearch {
    std::span<const SearchedBody> bodies;
    std::span<const PatchBlock> blocks;
    const FeatureBoxes* boxes;
    const Vec4* positions;
    const Vec4* motions;
    float of_borders = 1;  ///< fraction of the reach for pairs nearest at a border
    /// Neighbours are calm if they stay apart while all particles move the same fraction of their motions.
    bool together = false;
    /// By block, a bit for each patch. If both are null, the search tests all neighbours, and covers all
    /// pairs of patches that are not calm. If not, it tests calm neighbours again where one has its bit in
    /// `strayed`. It covers those that it opens, and other pairs of which one has its bit in `only`.
    const std::uint16_t *only = nullptr, *strayed = nullptr;
};

/// The pairs of a block. `fill`, unless null, receives their number during the search.
struct FoundPairs {
    PairsOfBlock vertex_triangle, edge_edge;
    ListFill* fill = nullptr;
    std::uint32_t block = 0;

    void update_fill() {
        if (fill != nullptr) fill->update(block, *this);
    }
};

/// Fills the boxes of a block's patches and the bounds of their motions, and returns the block's box.
/// Features that are not finite, now or after their motion, are in no box.
Bounds place_patches(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Marks the gradients round the neighbours that a search with marks tests.
void want_gradients(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Fills the gradients of a block's patches, and their sums; in a search with marks, only those marked.
void place_gradients(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Tests which neighbours are calm, of a block's patches and those after them, as the search requires.
void find_neighbours(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Marks the patches whose features are searched, of the block and of those after it. Returns false if there
/// are none.
bool want_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Fills the boxes of the features of a block's marked patches.
void place_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// The crossings of a block: those that there is room for, and the number of all.
struct FoundCrossings {
    std::span<Crossing> room;
    std::uint32_t count = 0;

    void add(const Crossing& crossing) {
        if (count < room.size()) room[count] = crossing;
        ++count;
    }
};

/// Finds the pairs of a block with itself and with the blocks after it.
void find_pairs(const PairSearch& search, std::uint32_t block, FoundPairs& found);

/// Finds the edges and triangles that cross, of a block with itself and with the blocks after it.
void find_crossings(const PairSearch& search, std::uint32_t block, FoundCrossings& found);

/// Computes the shapes of pairs of one kind; `vertex_triangle`: the kind.
void shape_pairs(const Vec4* positions, bool vertex_triangle, std::span<const FeaturePair> pairs,
                 PairShape* shapes);

/// Turns the normals of pairs that are nearest at a border: along these, a feature that slides over a surface
/// would run into each border ahead. The new normal has the largest least gap over both ends of the motion,
/// if that is positive. It is the pair's own, that of the end with the weights of the end, or the one half
/// way between, for features that pass over a border. `shapes` holds the shapes at the start.
void shape_moving_pairs(const Vec4* positions, const Vec4* motions, bool vertex_triangle,
                        std::span<const FeaturePair> pairs, PairShape* shapes);

/// Input of narrow_pairs(): see PairNarrowing::narrow.
struct PairNarrow {
    const Vec4* positions;
    const Vec4* motions;
    float reach, longest;
};
/// Moves the pairs that remain, and their shapes, to the front, and returns their number.
std::uint32_t narrow_pairs(const PairNarrow& narrow, bool vertex_triangle, std::span<FeaturePair> pairs,
                           PairShape* shapes);

}  // namespace weft
