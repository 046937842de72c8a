#pragma once
// Small components of a coarse level, each solved by a dense factorisation of its own: work and memory are
// linear in the number of components.

#include <cstdint>
#include <span>

#include "cloth/solvers/multigrid/coarse_matrix.h"
#include "cloth/solvers/multigrid/coarse_pairs.h"
#include "cloth/solvers/multigrid/coarsening.h"
#include "cloth/solvers/multigrid/galerkin.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/memory/hooked_vector.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

class ComponentSolver {
  public:
    /// Larger components have a coarser level instead.
    static constexpr std::uint32_t most_nodes = 16;

    /// Takes all memory that it needs. `lists` name the level's links.
    ComponentSolver(const Components& components, const GalerkinLists& lists);

    /// Cholesky factors of the matrix's blocks, in double precision. Rows of pairs within a component take
    /// the place of their bound, which the matrix has.
    void factorise(Parallel& parallel, const CoarseMatrix& matrix, const CoarsePairs& pairs);
    /// Sets x to the solution at the small components' nodes, and leaves the others alone.
    void solve(Parallel& parallel, std::span<const Vec4> b, std::span<Vec4> x) const;

    [[nodiscard]] std::size_t nodes() const noexcept { return nodes_.size(); }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    static constexpr std::uint32_t none = ~0u;
    /// Its nodes, links and factor begin here, and end where those of the next one begin.
    struct Component {
        std::uint32_t node, link;
        std::size_t factor;
    };
    /// A link by its place in the lists, its ends counted from the component's first node.
    struct LocalLink {
        std::uint32_t place, first, second;
    };
    [[nodiscard]] std::uint32_t count() const noexcept {
        return static_cast<std::uint32_t>(components_.size()) - 1;
    }
    void factorise(std::uint32_t component, const CoarseMatrix& matrix, const CoarsePairs& pairs);
    void solve(std::uint32_t component, std::span<const Vec4> b, std::span<Vec4> x) const;

    HookedVector<Component> components_;  // and behind the last of them their ends
    HookedVector<std::uint32_t> nodes_;
    HookedVector<std::uint32_t> number_;  // of each of the level's nodes: its place in nodes_, or none
    HookedVector<LocalLink> links_;
    AlignedBuffer<double> factors_;  // by columns
};

}  // namespace weft
