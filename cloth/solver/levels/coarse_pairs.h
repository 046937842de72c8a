#pragma once
// Contact of a cloth with itself on the coarse levels of its multigrid cycle. Without contact the levels
// would push layers through each other. With contact as a ground that holds each side, they would keep layers
// that touch from moving together.

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <span>

#include "cloth/equation/pair_rows.h"
#include "cloth/equation/seam_rows.h"
#include "cloth/equation/sparse/interpolation.h"
#include "engine/memory/scratch.h"
#include "engine/simd/symmetric3.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// Rows K c c^T: K acts on the sum of c x over the nodes that c names; the weights of c add up to 0. A coarse
/// row merges all fine rows between the same two nodes: it has the sum of their K and, of the first few, the
/// mean of P^T c (Galerkin's product, but for the merging).
class CoarsePairs {
  public:
    static constexpr std::uint32_t most_nodes = 12;  ///< of a row

    struct Row {
        std::uint32_t count = 0;  ///< of its nodes
        std::uint32_t nodes[most_nodes];
        float weights[most_nodes];
        float reach;  ///< sum of |weights|
        Symmetric3 stiffness;
    };

    /// Capacity: so many rows for each node, and least_rows more. Further rows are left out.
    static constexpr std::size_t rows_per_node = 24, least_rows = 64;

    /// Room for `fine_rows` rows of a finer level, merged into rows of `nodes` coarse nodes. Makes no rows.
    void lay_out(Scratch& scratch, std::size_t fine_rows, std::uint32_t nodes);
    [[nodiscard]] std::size_t room() const noexcept { return rows_.size(); }

    /// Adds the pairs that push any of a cloth's `particles`, numbered from `first` on, to those listed. Only
    /// one cloth at a time may call this: the pairs mark what they list.
    void list(PairRows& pairs, std::uint32_t first, std::uint32_t particles);
    /// Likewise the stitches of a seam.
    void list(const SeamRows& seam, std::uint32_t first, std::uint32_t particles);
    /// Makes rows of the listed pairs whose corners are all the cloth's. P leads from the first coarse level
    /// to the particles; `weights` are P's, 0 where pinned.
    void gather(Parallel& parallel, std::uint32_t first, const Interpolation& p,
                std::span<const float> weights);
    [[nodiscard]] std::span<const PairRows::ActivePair> listed() const noexcept {
        return active_.span().first(listed_);
    }
    /// Makes rows of a finer coarse level's rows.
    void gather(Parallel& parallel, const CoarsePairs& finer, const Interpolation& p);

    /// Whether all corners of a pair are particles of the cloth, which has so many from `first` on.
    [[nodiscard]] static bool is_inner(const PairRows::ActivePair& active, std::uint32_t first,
                                       std::size_t particles) {
        return std::ranges::all_of(active.pair.corners,
                                   [&](std::uint32_t i) { return i - first < particles; });
    }
    /// Whether gather() met listed pairs that are not of this cloth alone.
    [[nodiscard]] bool has_outer() const noexcept { return has_outer_; }

    void clear() noexcept {
        listed_ = size_ = 0;
        has_outer_ = false;
    }

    [[nodiscard]] std::span<const Row> rows() const noexcept { return rows_.span().first(size_); }
    /// add(node, factor, K) for D, the rows' upper bound on the diagonal: node k of a row has reach |c_k| K.
    template <class Add>
    void for_each_bound(const Add& add) const {
        for (const Row& row : rows())
            for (std::uint32_t k = 0; k < row.count; ++k)
                add(row.nodes[k], row.reach * std::abs(row.weights[k]), row.stiffness);
    }
    /// corrected = b - (C - D) x, where C is the rows' matrix and D their bound.
    void correct(std::span<const Vec4> b, std::span<const Vec4> x, std::span<Vec4> corrected) const;

  private:
    /// A fine row's place in the order: the two coarse nodes of its largest weights.
    struct Key {
        std::uint32_t low, high;
        float sign;  ///< 1: c is positive at the lower one, else -1
    };
    /// A fine row's place among those with the same low node.
    struct Placed {
        std::uint32_t high, row;
        auto operator<=>(const Placed&) const = default;
    };
    /// A row being gathered.
    class Sum;

    [[nodiscard]] static Key key_between(const Interpolation& p, std::span<const float> of_p,
                                         std::uint32_t most, std::uint32_t least);
    [[nodiscard]] static Key key_of(const PairRows::ActivePair& active, std::uint32_t first,
                                    const Interpolation& p, std::span<const float> weights);
    void sort_by_nodes(Parallel& parallel, std::uint32_t fine_rows);
    void add_to_list(const PairRows::ActivePair& active);
    template <class AddRow>
    void merge(Parallel& parallel, std::uint32_t fine_rows, const AddRow& add_row);

    ScratchArray<Key> keys_;              // of the finer level's rows
    ScratchArray<Placed> order_;          // fine rows, by key
    ScratchArray<std::uint32_t> starts_;  // by low node: its first place in order_
    ScratchArray<std::uint32_t> merged_;  // by low node: its first coarse row
    ScratchArray<PairRows::ActivePair> active_;
    ScratchArray<Row> rows_;
    std::uint32_t listed_ = 0, size_ = 0;  // active pairs, coarse rows
    bool has_outer_ = false;
};

}  // namespace weft
