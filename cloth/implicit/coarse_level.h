#pragma once
// One coarse level: its operator, summed anew from the finer level's, and the vectors of a cycle.

#include <span>

#include "cloth/implicit/coarse_matrix.h"
#include "cloth/implicit/coarsening.h"
#include "cloth/implicit/galerkin.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// body(BlockRange) for blocks of 64 coarse nodes: they are few, and have many neighbours.
template <class Body>
void coarse_ranges(Parallel& parallel, std::uint32_t nodes, const Body& body) {
    constexpr std::uint32_t size = 64;
    static_assert(size % Stencil::lanes == 0, "a block is whole groups");
    parallel.ranges(nodes, body, size);
}

class CoarseLevel {
  public:
    /// Lists of the springs between this level's nodes; P leads from here to the finer level.
    CoarseLevel(GalerkinLists lists, Interpolation interpolation, const SpringGraph& graph);

    /// Links from the finest level's springs d d^T + a I, given as (d, a); the lists name them by their
    /// place.
    void sum_links(Parallel& parallel, std::span<const Vec4> springs);
    /// Links and ground from another coarse level's. The finest level's ground is the caller's to sum.
    void sum(Parallel& parallel, const CoarseLevel& finer);
    /// After links and ground: the matrix.
    void finish(Parallel& parallel);

    /// residual = b - W x.
    void residual(Parallel& parallel, std::span<Vec4> residual) const;
    /// x = step D^-1 b.
    void relax_from_zero(Parallel& parallel, float step);
    /// As ImplicitSystem::relax, on x; the iterate before it is where residual() may be put.
    void relax(Parallel& parallel, Relaxation relaxation);

    [[nodiscard]] std::uint32_t nodes() const noexcept { return matrix_.stencil.nodes; }
    [[nodiscard]] const Interpolation& interpolation() const noexcept { return interpolation_; }
    [[nodiscard]] const GalerkinLists& lists() const noexcept { return lists_; }
    [[nodiscard]] const CoarseMatrix& matrix() const noexcept { return matrix_; }
    [[nodiscard]] CoarseMatrix& matrix() noexcept { return matrix_; }
    [[nodiscard]] std::span<Vec4> b() noexcept { return b_.span(); }
    [[nodiscard]] std::span<Vec4> x() noexcept { return x_.span(); }
    [[nodiscard]] std::span<Vec4> before() noexcept { return before_.span(); }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    GalerkinLists lists_;
    Interpolation interpolation_;
    CoarseMatrix matrix_;
    AlignedBuffer<Vec4> b_, x_, before_;
};

/// coarse = P^T fine.
void restrict_to(Parallel& parallel, const Interpolation& p, std::span<const Vec4> fine,
                 std::span<Vec4> coarse);
/// coarse = P^T (a - b).
void restrict_difference(Parallel& parallel, const Interpolation& p, std::span<const Vec4> a,
                         std::span<const Vec4> b, std::span<Vec4> coarse);
/// fine += P coarse, with these weights in place of P's own.
void prolong_from(Parallel& parallel, const Interpolation& p, std::span<const float> weights,
                  std::span<const Vec4> coarse, std::span<Vec4> fine);

}  // namespace weft
