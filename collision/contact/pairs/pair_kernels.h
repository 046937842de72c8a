#pragma once
// Boxes of features, and the pairs of near ones, many at a time; compiled once for each kind of machine. See
// pair_finder.h.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/contact_mesh.h"
#include "collision/contact/pairs/crossings.h"
#include "collision/contact/pairs/list_fill.h"
#include "collision/contact/pairs/pairs.h"
#include "collision/search/patch_kernels.h"
#include "weft/types.h"

namespace weft {

/// Whether two bodies meet: each one's mask has a bit of the other's layers.
constexpr bool masks_allow(std::uint32_t layers_a, std::uint32_t mask_a, std::uint32_t layers_b,
                           std::uint32_t mask_b) {
    return (mask_a & layers_b) != 0 && (mask_b & layers_a) != 0;
}

/// A body as searches see it.
struct SearchedBody {
    const ContactMesh* mesh;
    std::uint32_t first;  ///< its first particle
    float reach;          ///< [m]
    std::uint32_t layer, mask;
    bool meets_itself;
    /// Where the boxes of its vertices, triangles and edges begin.
    std::uint32_t first_vertex_group, first_triangle_group, first_edge_group;
    std::uint32_t first_block;
    std::uint32_t first_gradients;   ///< groups of triangles, if it has charts
    std::uint32_t first_neighbours;  ///< of its FlatRest's pairs
};
/// By which boxes of its features are grown [m].
constexpr float half_reach_of(const SearchedBody& body) {
    return 0.5f * body.reach * (1 + 1e-6f);
}

/// Up to sixteen patches of a body: what a thread searches at a time.
struct PatchBlock {
    static constexpr std::uint32_t most = 16;

    std::uint32_t body, first_patch, patch_count;
};

/// The gradients of sixteen slots of triangles, x, y and z along each axis of the chart, at the start and at
/// the end of the motion. What is stretched so far that rounding matters is not a number.
struct TriangleGradients {
    alignas(64) float start[6][16], end[6][16];
};

/// What a search knows of two patches that are neighbours.
enum class Neighbours : std::uint8_t {
    looked_at,  ///< their features are
    calm,       ///< no features of theirs come within reach: they are passed over
    opened,     ///< their features are, and the search before passed them over
};

/// Boxes over the motion, grown by half the body's reach: two that overlap are within the mean of both.
struct FeatureBoxes {
    ScratchArray<Boxes> vertices, triangles, edges;  ///< as the meshes' slots
    /// Of patches, sixteen to each block, of blocks, and of groups of sixteen blocks.
    ScratchArray<Boxes> patches, blocks, groups;
    ScratchArray<PatchStrain> strains;  ///< of patches, sixteen to each block
    ScratchArray<TriangleGradients> gradients;
    /// By group of triangles: 1 where a search round marks asks for their gradients.
    ScratchArray<std::uint8_t> wanted_gradients;
    ScratchArray<Neighbours> neighbours;  ///< by pair
    /// Of patches: 1 where the boxes of the features are filled, as others come near them.
    ScratchArray<std::uint8_t> wanted;
};

/// What a search reads. `motions` is null where nothing moves.
struct PairSearch {
    std::span<const SearchedBody> bodies;
    std::span<const PatchBlock> blocks;
    const FeatureBoxes* boxes;
    const Vec4* positions;
    const Vec4* motions;
    float of_borders = 1;  ///< share of the reach that pairs nearest at a border have
    /// Neighbours count as calm if they stay apart while all particles go the same part of their motions.
    bool together = false;
    /// By block, a bit for each patch. Where these are null the search asks for all neighbours, and looks at
    /// all pairs of patches that are not calm. Else it asks for calm neighbours again if one has its bit in
    /// `strayed`, and looks at those that it opens and at other pairs of which one has its bit in `only`.
    const std::uint16_t *only = nullptr, *strayed = nullptr;
};

/// Items found, as far as there is room. `count` goes on, until there are `enough` and the search ends.
template <class Item>
struct Found {
    std::span<Item> room;
    std::uint32_t enough = ~0u;
    std::uint32_t count = 0;

    [[nodiscard]] bool has_enough() const { return count >= enough; }

    void add(const Item& item) {
        if (count < room.size()) room[count] = item;
        ++count;
    }
};

/// The pairs of a block. `fill`, unless null, is told how many they are while they are searched.
struct FoundPairs {
    Found<FeaturePair> vertex_triangle, edge_edge;
    ListFill* fill = nullptr;
    std::uint32_t block = 0;

    void update_fill() {
        if (fill != nullptr) fill->update(block, *this);
    }
};

/// Fills the boxes of a block's patches and the bounds of their motions, and returns its own box. Features
/// that are not finite, now or after their motion, are in no box.
Bounds place_patches(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Wants the gradients around the neighbours that a search round marks asks for.
void want_gradients(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Fills the gradients of a block's patches, and their sums: all, or those that a search round marks wants.
void place_gradients(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Finds which neighbours are calm, of those that are asked for, of a block's patches and those after them.
void find_neighbours(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Wants the features of the patches that are to be looked at, of the block and of those after it; false if
/// there are none.
bool want_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// Fills the boxes of a block's wanted features.
void place_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes);

/// The pairs of a block with itself and with the blocks after it.
void find_pairs(const PairSearch& search, std::uint32_t block, FoundPairs& found);

/// The edges and triangles that cross, of a block with itself and with the blocks after it.
void find_crossings(const PairSearch& search, std::uint32_t block, Found<Crossing>& found);

/// Shapes of pairs of one kind; `vertex_triangle`: of which.
void shape_pairs(const Vec4* positions, bool vertex_triangle, std::span<const FeaturePair> pairs,
                 PairShape* shapes);

/// Turns the normals of pairs that are nearest at a border, since a feature that slides over a surface would
/// run into each border ahead of it. Such a pair gets the normal that keeps it farther apart at both ends of
/// the motion, if both gaps are positive along it: its own, that of the end with the weights of the end, or
/// the one half way between, for what passes over a border. `shapes` has the pairs' shapes at the start.
void shape_moving_pairs(const Vec4* positions, const Vec4* motions, bool vertex_triangle,
                        std::span<const FeaturePair> pairs, PairShape* shapes);

/// What is left of a list: see PairNarrowing::narrow.
struct PairNarrow {
    const Vec4* positions;
    const Vec4* motions;
    float reach, longest;
};
/// Moves the pairs that are left, and their shapes, to the front; returns how many.
std::uint32_t narrow_pairs(const PairNarrow& narrow, bool vertex_triangle, std::span<FeaturePair> pairs,
                           PairShape* shapes);

}  // namespace weft
