#pragma once
// The motion of a whole component, solved exactly.

#include <cstdint>
#include <span>

#include "cloth/mesh/cook.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

/// Springs do not feel a translation, so along it the system is a division: for a component without pins the
/// sum of all rows is (sum r_i) u = sum b_i. Few Jacobi iterations leave this, the slowest mode, almost
/// unsolved, and stiff cloth hovers. Taking u out before the iteration and putting it back after changes
/// nothing in the converged solution; at any number of iterations it makes free fall exact and keeps linear
/// momentum.
class MeanMotion {
  public:
    MeanMotion() = default;
    explicit MeanMotion(const CookedCloth& model);

    /// Before the iteration: computes u of every component in which no particle is pinned, and subtracts r_i
    /// u from b_i. Components with a pin are left as they are.
    void take_out(Parallel& parallel, const CookedCloth& model, std::span<Vec4> right_side);
    /// After the iteration: adds u to dv, less the iteration's own mean, which the exact solution does not
    /// have.
    void put_back(Parallel& parallel, const CookedCloth& model, std::span<const Vec4> right_side,
                  std::span<Vec4> velocity_change);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Sum {
        double x = 0, y = 0, z = 0, row_sum = 0;
        bool pinned = false;

        [[nodiscard]] Vector3 mean() const {
            return {static_cast<float>(x / row_sum), static_cast<float>(y / row_sum),
                    static_cast<float>(z / row_sum)};
        }
    };
    /// Sums term(i), a Vector3, and the row sums over some particles.
    template <class Term>
    [[nodiscard]] Sum sum_over(Parallel& parallel, std::span<const std::uint32_t> particles,
                               std::span<const Vec4> right_side, const Term& term);

    AlignedBuffer<Vec4> component_change_;  // w: 1 if the component is free, else 0
    AlignedBuffer<Sum> partials_;
};

}  // namespace weft
