#pragma once
// Small components of a coarse level, each solved by a dense factorisation of its own: work and memory are
// linear in the number of components.

#include <cstdint>
#include <span>
#include <utility>

#include "cloth/solver/levels/coarse/coarse_matrix.h"
#include "cloth/solver/levels/coarse/coarse_pairs.h"
#include "cloth/solver/levels/coarse/coarsening.h"
#include "cloth/solver/levels/coarse/galerkin.h"
#include "engine/memory/scratch.h"
#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// The nodes and links of a level's small components.
struct SmallComponents {
    /// Larger components have a coarser level instead.
    static constexpr std::uint32_t most_nodes = 16;
    static constexpr std::uint32_t none = ~0u;
    /// Where a component's nodes, links and factor begin; they end where the next component's begin.
    struct Component {
        std::uint32_t node, link;
        std::uint64_t factor;
    };
    /// A link by its place in the lists, its ends counted from the component's first node.
    struct LocalLink {
        std::uint32_t place, first, second;
    };

    SmallComponents() = default;
    SmallComponents(const Components& of_level, const CoarseLinks& of);

    SharedBuffer<Component> components;  ///< last an entry with their ends
    SharedBuffer<std::uint32_t> nodes;
    SharedBuffer<std::uint32_t> number;  ///< by the level's node: its place in `nodes`, or none
    SharedBuffer<LocalLink> links;

    /// visit(list) for each of its lists.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit(self.components);
        visit(self.nodes);
        visit(self.number);
        visit(self.links);
    }
    /// Whether all indices in lists that were read are in range, on a level of so many nodes and places.
    [[nodiscard]] bool is_sound(std::uint32_t level_nodes, std::size_t places) const;
    [[nodiscard]] std::size_t bytes() const noexcept {
        return components.bytes() + nodes.bytes() + number.bytes() + links.bytes();
    }
};

class ComponentSolver {
  public:
    static constexpr std::uint32_t most_nodes = SmallComponents::most_nodes;

    explicit ComponentSolver(SmallComponents components) : lists_(std::move(components)) {}
    void lay_out(Scratch& scratch) { scratch.take(factors_, lists_.components[count()].factor); }

    /// Makes the Cholesky factors of the matrix's blocks, in double precision. Rows of pairs within a
    /// component replace their bound, which the matrix includes.
    void factorise(Parallel& parallel, const CoarseMatrix& matrix, const CoarsePairs& pairs);
    /// Sets x to the solution at the small components' nodes, and leaves the others alone.
    void solve(Parallel& parallel, std::span<const Vec4> b, std::span<Vec4> x) const;

    [[nodiscard]] std::size_t nodes() const noexcept { return lists_.nodes.size(); }
    [[nodiscard]] const SmallComponents& components() const noexcept { return lists_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return lists_.bytes(); }

  private:
    using Component = SmallComponents::Component;

    [[nodiscard]] std::uint32_t count() const noexcept {
        return static_cast<std::uint32_t>(lists_.components.size()) - 1;
    }
    void factorise(std::uint32_t component, const CoarseMatrix& matrix, const CoarsePairs& pairs);
    void solve(std::uint32_t component, std::span<const Vec4> b, std::span<Vec4> x) const;

    SmallComponents lists_;
    ScratchArray<double> factors_;  // by columns
};

}  // namespace weft
