#pragma once
// Multigrid on any mesh (Brandt 1977; Galerkin operators on aggregated nodes after Vanek, Mandel, Brezina
// 1996): one symmetric V-cycle as a preconditioner for an implicit system. Levels are made once; their
// operators at each build().

#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "cloth/solvers/multigrid/coarse_level.h"
#include "cloth/system/implicit_system.h"

namespace weft {

class Multigrid {
  public:
    /// Makes the levels from the system's springs as they are linearised now; `positions` give their lengths.
    Multigrid(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> positions);

    /// Pinned particles (inverse mass 0) have no part in coarse motions, and springs to them hold the coarse
    /// nodes.
    void set_pins(std::span<const Vec4> positions);
    /// Sums the coarse operators of the system's present W.
    void build(Parallel& parallel, ImplicitSystem& system);
    /// z = an approximation of W^-1 r, linear, symmetric and positive definite in r.
    void cycle(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> r, std::span<Vec4> z);

    [[nodiscard]] std::size_t levels() const noexcept { return coarse_.size(); }
    [[nodiscard]] const CoarseLevel& level(std::size_t k) const { return coarse_[k]; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// A spring from a free particle to a pinned one, and how much of it a node of the first coarse level
    /// feels.
    struct Tie {
        std::uint32_t coarse, spring;
        float weight;
    };
    /// That of the link's first end.
    [[nodiscard]] std::uint32_t entry_of(const Link& link) const;
    /// The place of a link of the finest level in springs_.
    [[nodiscard]] std::uint32_t spring_of(const Link& link) const;
    void tie_to(std::span<const Vec4> positions);
    void sum_first_ground(Parallel& parallel, const ImplicitSystem& system);
    void factorise_coarsest();
    void solve_level(Parallel& parallel, std::size_t level);
    void solve_coarsest();

    const ImplicitSystem* system_;
    std::vector<Link> links_;  // of the finest level
    // Slots of the system that hold the links from their first end, and slots of free particles with springs
    // to pins.
    std::vector<std::uint32_t> slots_;
    std::size_t slots_of_links_ = 0;
    AlignedBuffer<Vec4> springs_;      // of these slots: see ImplicitSystem::spring_blocks
    std::vector<std::uint32_t> held_;  // springs with a pinned end, which are not summed
    AlignedBuffer<float> weights_;     // of the first level's P, rows of pinned particles 0
    std::vector<Tie> ties_;            // ascending by coarse node
    std::vector<CoarseLevel> coarse_;
    AlignedBuffer<Vec4> smooth_, remainder_;
    Eigen::MatrixXd coarsest_;
    Eigen::LLT<Eigen::MatrixXd> factor_;
    Eigen::VectorXd coarsest_x_;
};

}  // namespace weft
