#pragma once
// Pairs of near features as forces in the implicit step: of one cloth with itself, and of cloths with one
// another.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "cloth/equation/pairs/pair_row_kernels.h"
#include "cloth/equation/pairs/untangling_rows.h"
#include "collision/contact/pairs/incidence.h"
#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/simd/symmetric3.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

/// A pair's features push each other apart along the normal that detection gave them, by a stiff spring that
/// ends at the radius (contact potentials after Terzopoulos, Platt, Barr, Fleischer 1987). Across the normal
/// a damper holds them up to Coulomb's limit, as far as that is known. A second, far stiffer spring begins
/// half way in, for squeezed cloth. Springs stiffen from 0 over their first depth: otherwise resting features
/// would touch and part by turns. Corner i of pair k gets the impulse
///     b_i (c_k - K_k sum_j b_j v_j),   K_k = spring n n^T + damper (I - n n^T) [kg]
/// so the corners' impulses add up to 0. Corners, and all spans, are numbered through all bodies.
class PairRows {
  public:
    /// Room for lists of so many pairs, for rows of so many of these, and for so many particles, of all
    /// bodies together; not for untangling().
    struct Room {
        std::size_t particles, pairs, rows;
    };
    void lay_out(Scratch& scratch, const Room& room) {
        lay_out_rows(scratch, room);
        lay_out_solve(scratch, room);
    }
    /// lay_out() in two parts: the rows, and the arrays that are unused after the solve.
    void lay_out_rows(Scratch& scratch, const Room& room);
    void lay_out_solve(Scratch& scratch, const Room& room);

    /// Begins a substep whose equation has these bases and this gamma. The arguments must outlive it. Pairs
    /// without a radius, and those after the last for which there is room, get no row and cost nothing
    /// afterwards.
    void begin(Parallel& parallel, const PairList& list, std::span<const PairLaw> laws,
               std::span<const Vec4> base_positions, float gamma);
    [[nodiscard]] bool empty() const noexcept { return size_ == 0 && untangling_.empty(); }
    /// Rows of crossing features. All operations below include them.
    [[nodiscard]] UntanglingRows& untangling() noexcept { return untangling_; }

    /// Copies a body's part of a vector, for particles in pairs. The body's first particle is `first`.
    void take(Parallel& parallel, std::uint32_t first, std::span<const Vec4> vector);
    /// Linearises the pairs at the velocities that were taken: which of them push, and how.
    void linearise(Parallel& parallel);
    /// Contact's effect on one particle, as last linearised.
    struct AtParticle {
        std::uint32_t particle;
        Symmetric3 diagonal;  ///< contact's part of a relaxation's diagonal block [kg]
        Vector3 impulse;      ///< at the velocities taken [kg m/s]
    };
    /// visit(AtParticle) for free particles in [begin, end) that pairs push, ascending; then for those in
    /// rows of crossing features.
    template <class Visit>
    void for_each_particle(std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
        for (std::uint32_t r = first_row(begin); r < incidence_.rows(); ++r) {
            const std::uint32_t i = incidence_.particle(r);
            if (i >= end) break;
            if (counts_[r] == 0) continue;
            const auto& [d, o, impulse] = particles_[r];
            visit(AtParticle{i, {d.x, d.y, d.z, o.x, o.y, o.z}, xyz(impulse)});
        }
        untangling_.for_each_particle(begin, end, [&](std::uint32_t i, const UntanglingRows::Sum& sum) {
            visit(AtParticle{i, sum.diagonal, sum.impulse});
        });
    }

    /// Returns x . C x, with x as taken and C the pairs' matrix.
    double multiply(Parallel& parallel);
    /// product += C x of a body's particles, after multiply().
    void add_products(Parallel& parallel, std::uint32_t first, std::span<Vec4> product) const;

    /// A pair that pushes, as last linearised.
    struct ActivePair {
        const FeaturePair& pair;
        const PairShape& shape;
        float spring, damper;  ///< [kg]

        /// The pair's matrix K.
        [[nodiscard]] Symmetric3 stiffness() const {
            const Vector3 n = xyz(shape.normal), across = (spring - damper) * n;
            return {damper + across.x() * n.x(), damper + across.y() * n.y(), damper + across.z() * n.z(),
                    across.x() * n.y(),          across.x() * n.z(),          across.y() * n.z()};
        }
    };
    [[nodiscard]] ActivePair active_pair(std::uint32_t row) const {
        const PairGroup& group = groups_[row / PairGroup::lanes];
        const std::uint32_t lane = row % PairGroup::lanes, number = numbers_[row];
        return {list_->pairs[number], list_->shapes[number], group.spring[lane], group.damper[lane]};
    }
    /// visit(ActivePair) for all pairs that push, in list order.
    template <class Visit>
    void for_each_active(const Visit& visit) const {
        for_each_active_row([&](std::uint32_t row) { visit(active_pair(row)); });
    }
    /// visit(row) for the rows of all pairs that push, ascending.
    template <class Visit>
    void for_each_active_row(const Visit& visit) const {
        for (std::uint32_t k = 0; k < size_; ++k)
            if (pushes(k)) visit(k);
    }
    /// visit(row) for the rows of the pairs that push a free particle in [first, first + count), ascending.
    template <class Visit>
    void for_each_active_row_of(std::uint32_t first, std::size_t count, const Visit& visit) {
        constexpr std::uint32_t bits = 64;
        const RowRange rows = rows_of(first, count);
        if (rows.end - rows.begin == incidence_.rows()) return for_each_active_row(visit);
        const std::span<std::uint64_t> marks = marks_.span().first((size_ + bits - 1) / bits);
        std::ranges::fill(marks, std::uint64_t{0});
        for (std::uint32_t r = rows.begin; r < rows.end; ++r)
            for (std::uint32_t c = 0; c < counts_[r]; ++c) {
                const std::uint32_t k = pushed_[incidence_.start(r) + c].pair;
                marks[k / bits] |= std::uint64_t{1} << k % bits;
            }
        for (std::uint32_t word = 0; word < marks.size(); ++word)
            for (std::uint64_t left = marks[word]; left != 0; left &= left - 1)
                visit(word * bits + static_cast<std::uint32_t>(std::countr_zero(left)));
    }
    /// Splits the impulses that particles are known to have got among the pairs that pushed when last
    /// linearised, by sweeps of projected Gauss-Seidel: for reports after the solve. The list may have
    /// changed. The rows' own law does not serve: with its stiff springs, few iterations leave it several
    /// times off. missing(particle) is the impulse that no pair has been credited with yet [kg m/s]; that of
    /// pinned particles stays.
    void begin_sweeps();
    template <class Missing>
    void sweep(const Missing& missing) {
        for (std::uint32_t k = 0; k < size_; ++k)
            if (pushes(k)) share_out(k, missing);
    }
    /// A pair as it was when the substep began: the weights of its corners, and its normal.
    struct Row {
        std::array<std::uint32_t, 4> corners;
        std::array<float, 4> weights;
        Vector3 normal;
    };
    /// A pair's impulse: the normal part from the sweeps, friction at the velocities that were taken.
    struct Push {
        Row pair;
        std::uint32_t corners_of_a;
        Vector3 point;    ///< half way between the features, at the end of the step [m]
        Vector3 impulse;  ///< on side A; B gets the opposite [kg m/s]
    };
    /// visit(Push) for all pairs with an impulse, in list order.
    template <class Visit>
    void for_each_push(const Visit& visit) const {
        for (std::uint32_t k = 0; k < size_; ++k)
            if (pushes(k) && products_[k].x > 0) visit(push_of(k));
    }

  private:
    [[nodiscard]] bool pushes(std::uint32_t k) const {
        return groups_[k / PairGroup::lanes].spring[k % PairGroup::lanes] > 0;
    }
    /// The pair's impulse along the normal is in products_[k].x.
    template <class Missing>
    void share_out(std::uint32_t k, const Missing& missing) {
        const Row pair = row(k);
        const Vector3& n = pair.normal;
        float along = 0, squares = 0;
        for (std::uint32_t c = 0; c < 4; ++c) {
            if (!(base_positions_[pair.corners[c]].w > 0)) continue;
            const float b = pair.weights[c];
            along += b * n.dot(xyz(missing(pair.corners[c])));
            squares += b * b;
        }
        if (!(squares > 0)) return;
        const float more = std::max(along / squares, -products_[k].x);
        products_[k].x += more;
        for (std::uint32_t c = 0; c < 4; ++c) {
            if (!(base_positions_[pair.corners[c]].w > 0)) continue;
            Vec4& left = missing(pair.corners[c]);
            set_xyz(left, xyz(left) - pair.weights[c] * more * n);
        }
    }
    [[nodiscard]] Row row(std::uint32_t k) const;
    [[nodiscard]] Push push_of(std::uint32_t k) const;
    void choose(Parallel& parallel, std::span<const PairLaw> laws);
    /// The first row of the incidence whose particle is not below this one.
    [[nodiscard]] std::uint32_t first_row(std::uint32_t particle) const;
    /// Rows of the particles [first, first + count).
    struct RowRange {
        std::uint32_t begin, end;
    };
    [[nodiscard]] RowRange rows_of(std::uint32_t first, std::size_t count) const;

    const PairList* list_ = nullptr;
    std::span<const Vec4> base_positions_;
    float gamma_ = 0;
    std::uint32_t size_ = 0;               // pairs that have a row
    std::uint32_t vertex_triangles_ = 0;   // of size_; they come first
    ScratchArray<std::uint32_t> numbers_;  // by row: the pair's number in the list, ascending
    ScratchArray<FeaturePair> pairs_;
    ScratchArray<PairGroup> groups_;
    ScratchArray<PairShare> shares_;
    ScratchArray<Vec4> products_;  // by pair: K u, or in sweeps the impulse along the normal
    ScratchArray<Vec4> taken_;     // by particle
    // incidence_: the pairs of each particle, by row. Each row has, as last linearised, the sum of its
    // shares, the number of its corners that are pushed, and these corners from the row's first place on.
    PairIncidence incidence_;
    ScratchArray<PushedParticle> particles_;
    ScratchArray<std::uint32_t> counts_;
    ScratchArray<PushedCorner> pushed_;
    ScratchArray<std::uint32_t> block_counts_;
    ScratchArray<std::uint64_t> marks_;  // one bit a pair
    ScratchArray<double> partials_;
    UntanglingRows untangling_;
};

}  // namespace weft
