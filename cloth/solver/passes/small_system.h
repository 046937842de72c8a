#pragma once
// The step of least energy over a few directions.

#include <array>
#include <cstddef>

namespace weft {

/// The directions of a cycle. A later direction that the earlier ones nearly span gets coefficient 0.
enum Direction : std::size_t { change, motion, correction, direction_count };
using Coefficients = std::array<double, direction_count>;

/// The linearised step over the space of its directions d: the energy 1/2 c . G c - b . c [J].
struct SmallSystem {
    std::array<Coefficients, direction_count> g{};  ///< d_k . W d_m; the lower triangle is read
    Coefficients b{};                               ///< d_k . b
};

/// The c of the least energy, by L D L^T.
[[nodiscard]] Coefficients least_energy(const SmallSystem& system);

/// The system after the step c, which becomes `change` and is added to `motion`. Their products with W follow
/// from those of the directions that the step was made of. What is left of b is orthogonal to both; there is
/// no correction yet.
[[nodiscard]] SmallSystem after_step(const SmallSystem& system, const Coefficients& c);

}  // namespace weft
