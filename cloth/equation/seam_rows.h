#pragma once
// The stitches of a seam as springs in the implicit step.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/equation/pairs/pair_rows.h"
#include "cloth/state/seam_state.h"
#include "engine/simd/symmetric3.h"
#include "engine/vector.h"

namespace weft {

/// A stitch is a spring between two particles. Unlike a pair of PairRows it pulls as well as it pushes. Its
/// impulses on the two are opposite, so they add up to 0. A seam has few stitches, so one thread does them
/// all. Particles are numbered as in StepEquation::first. A seam belongs to the equation of one group.
class SeamRows {
  public:
    SeamRows(SeamId id, std::size_t stitches);
    [[nodiscard]] SeamId id() const noexcept { return id_; }
    [[nodiscard]] std::size_t capacity() const noexcept { return rows_.capacity(); }

    /// A cloth that the seam joins. One that is not in the equation is fixed where it is.
    struct Side {
        static constexpr std::uint32_t fixed = ~0u;
        std::uint32_t first = fixed;
        std::span<const Vec4> base_positions;
    };
    struct Law {
        float stiffness, rest_length, break_force;  ///< [N/m], [m], [N]
        float gamma;                                ///< [s]
    };
    /// Begins a solve, with the stitches that hold. No stitch pulls before linearise().
    void begin(const SeamState& seam, const Law& law, const std::array<Side, 2>& sides);
    /// Whether the cloth whose particles begin at `first` is the one, of the two, by which the equation goes
    /// through seams: each is done once.
    [[nodiscard]] bool is_led_by(std::uint32_t first) const noexcept { return leader_ == first; }

    /// Copies a cloth's part of a vector. Fixed particles have 0.
    void take(std::uint32_t first, std::span<const Vec4> vector);
    /// Finds the springs' forces and stiffness at the velocities that were taken.
    void linearise();
    /// visit(PairRows::AtParticle) for each stitch's free particle in [begin, end), ascending. A particle
    /// with several stitches is visited several times.
    template <class Visit>
    void for_each_particle(std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
        for (std::size_t e = first_end(begin); e < ends_.size() && ends_[e].particle < end; ++e) {
            if (!ends_[e].is_free) continue;
            const Row& row = rows_[ends_[e].row];
            visit(PairRows::AtParticle{ends_[e].particle, row.stiffness(), ends_[e].sign() * row.impulse});
        }
    }
    /// Returns x . C x, with x as taken and C the stitches' matrix.
    double multiply();
    /// product += C x of a cloth's particles, after multiply().
    void add_products(std::uint32_t first, std::span<Vec4> product) const;
    /// visit(PairRows::ActivePair) for the stitches with a particle in [first, first + count), in order.
    template <class Visit>
    void for_each_active_of(std::uint32_t first, std::size_t count, const Visit& visit) const {
        for (const Row& row : rows_) {
            const auto is_one = [&](std::uint32_t i) { return i - first < count; };
            if (is_one(row.pair.corners[0]) || is_one(row.pair.corners[2]))
                visit(PairRows::ActivePair{row.pair, row.shape, row.along, row.across});
        }
    }
    /// Whether a stitch ends at a particle that is not free: pinned, or fixed.
    [[nodiscard]] bool joins_what_is_held() const noexcept;

    /// Ends the solve: linearises at the velocities that were taken, and breaks stitches that bear more than
    /// they can.
    void finish(SeamState& seam);
    /// Begins a step: nothing has broken in it.
    void begin_step() noexcept { broken_ = 0; }
    [[nodiscard]] std::uint32_t broken() const noexcept { return broken_; }  ///< in this step
    [[nodiscard]] const Vector3& force() const noexcept { return force_; }   ///< on the first cloth [N]
    [[nodiscard]] float tightest() const noexcept { return tightest_; }      ///< greatest tension [N]
    void forget_forces() noexcept {
        force_ = Vector3::Zero();
        tightest_ = 0;
    }

  private:
    struct Row {
        FeaturePair pair;  // corners a, a, b, b
        PairShape shape;   // weights 1, 0, -1, 0; the spring's direction, from b to a
        std::uint32_t stitch;
        Vector3 apart;        // from b to a, at the bases [m]
        float along, across;  // stiffness, times gamma^2 [kg]
        Vector3 impulse;      // on a [kg m/s]
        std::array<Vector3, 2> taken;
        Vector3 product;  // on a [kg m/s]

        [[nodiscard]] Symmetric3 stiffness() const {
            return PairRows::ActivePair{pair, shape, along, across}.stiffness();
        }
    };
    /// An end of a row at a particle of the equation.
    struct End {
        std::uint32_t particle, row, side;
        bool is_free;

        [[nodiscard]] float sign() const noexcept { return side == 0 ? 1.0f : -1.0f; }
    };
    struct Pull {
        float tension;     // [N]
        float per_length;  // tension over length [N/m]
        Vector3 direction;
        Vector3 force;  // on a [N]
    };
    [[nodiscard]] std::size_t first_end(std::uint32_t particle) const noexcept;
    [[nodiscard]] Pull pull_of(const Row& row) const;

    SeamId id_;
    Law law_{};
    std::uint32_t leader_ = Side::fixed;
    std::vector<Row> rows_;
    std::vector<End> ends_;  // by particle
    Vector3 force_ = Vector3::Zero();
    float tightest_ = 0;
    std::uint32_t broken_ = 0;
};

}  // namespace weft
