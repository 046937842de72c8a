#pragma once
// Contact of a cloth with itself, or of cloths that share their levels, on the coarse levels of a multigrid
// cycle. Without contact the levels would push layers through each other. With contact as a ground that holds
// each side, they would keep layers that touch from moving together.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "cloth/equation/pairs/pair_rows.h"
#include "cloth/equation/sparse/interpolation.h"
#include "engine/memory/scratch.h"
#include "engine/simd/symmetric3.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// How levels number the particles of an equation: one cloth after the other.
class Numbering {
  public:
    static constexpr std::uint32_t none = ~0u;
    /// A cloth's particles in the equation and in the levels.
    struct Range {
        std::uint32_t in_equation, first, count;
    };
    explicit Numbering(std::span<const Range> ranges) : ranges_(ranges) {}

    /// The number in the levels of a particle of the equation; none, if its cloth is not one of them.
    [[nodiscard]] std::uint32_t operator()(std::uint32_t particle) const noexcept {
        for (const Range& range : ranges_)
            if (const std::uint32_t i = particle - range.in_equation; i < range.count) return range.first + i;
        return none;
    }
    [[nodiscard]] bool has_all_corners(const FeaturePair& pair) const noexcept {
        return std::ranges::all_of(pair.corners, [&](std::uint32_t i) { return (*this)(i) != none; });
    }
    [[nodiscard]] bool has_any_corner(const FeaturePair& pair) const noexcept {
        return std::ranges::any_of(pair.corners, [&](std::uint32_t i) { return (*this)(i) != none; });
    }
    [[nodiscard]] std::span<const Range> ranges() const noexcept { return ranges_; }

  private:
    std::span<const Range> ranges_;
};

/// The rows of P, without weights where they are of pinned nodes.
struct FreeRows {
    const Interpolation& p;
    const std::uint8_t* pinned = nullptr;  ///< by row: not 0 where pinned; null: none is

    struct Row {
        const std::uint32_t* nodes;
        std::array<float, Interpolation::width> weights;
    };
    [[nodiscard]] Row operator[](std::uint32_t i) const {
        Row row{&p.nodes[Interpolation::width * i], {}};
        if (pinned == nullptr || pinned[i] == 0)
            std::copy_n(&p.weights[Interpolation::width * i], Interpolation::width, row.weights.begin());
        return row;
    }
};

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

    /// Lists the pairs that push any particle of the levels' cloths, until the next layout. Only one thread
    /// at a time may call this for the same pairs, which mark what they list.
    void list(PairRows& pairs, const Numbering& number);
    /// Makes rows of the listed pairs whose corners are all the levels'. P leads from the first coarse level
    /// to the particles.
    void gather(Parallel& parallel, const Numbering& number, const FreeRows& p);
    [[nodiscard]] bool has_listed() const noexcept { return listed_ > 0; }
    /// visit(PairRows::ActivePair) for the listed pairs.
    template <class Visit>
    void for_each_listed(const Visit& visit) const {
        for (const std::uint32_t row : active_.span().first(listed_)) visit(pairs_->active_pair(row));
    }
    /// Makes rows of a finer coarse level's rows.
    void gather(Parallel& parallel, const CoarsePairs& finer, const Interpolation& p);

    /// Whether gather() met listed pairs with corners outside the levels.
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
    /// A row being gathered.
    class Sum;

    [[nodiscard]] static Key key_between(const FreeRows& p, std::uint32_t most, std::uint32_t least);
    [[nodiscard]] static Key key_of(const PairRows::ActivePair& active, const Numbering& number,
                                    const FreeRows& p);
    void sort_by_nodes(Parallel& parallel, std::uint32_t fine_rows);
    template <class AddRow>
    void merge(Parallel& parallel, std::uint32_t fine_rows, const AddRow& add_row);

    ScratchArray<Key> keys_;                       // of the finer level's rows
    ScratchArray<std::uint32_t> by_high_, order_;  // fine rows, by high node; by key
    ScratchArray<std::uint32_t> starts_;           // by low node: its first place in order_
    ScratchArray<std::uint32_t> merged_;           // by low node: its first coarse row
    const PairRows* pairs_ = nullptr;
    ScratchArray<std::uint32_t> active_;  // the listed pairs' rows
    ScratchArray<Row> rows_;
    std::uint32_t listed_ = 0, size_ = 0;  // active pairs, coarse rows
    bool has_outer_ = false;
};

}  // namespace weft
