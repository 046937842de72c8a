#pragma once
// Springs that push crossing cloth apart in the implicit step, along the directions in which it comes free.

#include <cstdint>
#include <span>

#include "collision/contact/crossings/untangling.h"
#include "engine/memory/scratch.h"
#include "engine/simd/symmetric3.h"
#include "engine/vector.h"

namespace weft {

/// A row pulls its corners by a soft spring towards the wanted depth along its direction, without friction.
/// The impulses b_i (c_k - s_k n n^T sum_j b_j v_j) add up to 0, as in PairRows. Rows are few, so one thread
/// does them all. Corners, and all spans, are numbered through all bodies.
class UntanglingRows {
  public:
    void lay_out(Scratch& scratch, std::size_t rows);

    /// Begins a substep with these rows, bases and gamma. The arguments must outlive it.
    void begin(std::span<const UntanglingRow> rows, std::span<const Vec4> base_positions, float gamma);
    [[nodiscard]] bool empty() const noexcept { return rows_.empty(); }

    /// Copies a body's part of a vector; the body's first particle is `first`. Corners of which nothing is
    /// taken have velocity 0.
    void take(std::uint32_t first, std::span<const Vec4> vector);
    /// Finds the rows that push, and their impulses, at the velocities that were taken.
    void linearise();
    /// Returns x . C x, with x as taken and C the rows' matrix.
    double multiply();
    /// product += C x of a body's particles, after multiply().
    void add_products(std::uint32_t first, std::span<Vec4> product) const;

    /// The rows' effect on one particle.
    struct Sum {
        Symmetric3 diagonal;                ///< the rows' part of a relaxation's diagonal block [kg]
        Vector3 impulse = Vector3::Zero();  ///< at the velocities taken, as last linearised [kg m/s]
        Vector3 product = Vector3::Zero();  ///< C x, as last multiplied
    };
    /// visit(particle, Sum) for free particles in [begin, end) that have rows, ascending.
    template <class Visit>
    void for_each_particle(std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
        for (std::uint32_t e = first_entry(begin); e < entry_count_ && entries_[e].particle < end;) {
            const std::uint32_t particle = entries_[e].particle;
            Sum sum;
            for (; e < entry_count_ && entries_[e].particle == particle; ++e) add(entries_[e], sum);
            visit(particle, sum);
        }
    }

  private:
    struct Spring {
        float mass, gap, spring;
        float impulse, transfer;  // along the row's direction
    };
    struct Entry {
        std::uint32_t particle, place;  // 5 * row + corner
    };
    [[nodiscard]] std::uint32_t first_entry(std::uint32_t particle) const;
    [[nodiscard]] float along(std::uint32_t row) const;
    void add(const Entry& entry, Sum& sum) const;

    std::span<const UntanglingRow> rows_;
    ScratchArray<Spring> springs_;
    ScratchArray<Vec4> taken_;     // by corner
    ScratchArray<Entry> entries_;  // of free particles, by particle
    std::uint32_t entry_count_ = 0;
    float gamma_ = 0;
};

}  // namespace weft
