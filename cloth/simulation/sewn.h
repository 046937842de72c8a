#pragma once
// The levels that cloths have in common because seams join them.

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "cloth/simulation/simulation.h"

namespace weft {

/// A change that sew() is to look ahead to.
struct SewnChange {
    std::span<const SeamId> removed{};                      ///< seams that will be gone
    std::span<const std::pair<SeamId, SeamState>> moved{};  ///< seams that will be these
    std::pair<ClothId, const Cloth*> cut{};                 ///< a cloth that will be this one, or null
    std::pair<const Cloth*, const ClothSettings*> other{};  ///< a cloth that will have these settings
};

/// Cloths that seams join, directly or by way of others, and the levels that they will have in common; a
/// cloth without seams has none. The levels follow from meshes, settings and seams alone, not from how these
/// came about.
struct Sewn {
    std::vector<ClothId> cloths;  ///< ascending
    std::shared_ptr<Multigrid> levels;
    std::size_t bytes = 0;

    [[nodiscard]] bool has(ClothId id) const;
    void give_to(Simulation& world) const noexcept;
};
[[nodiscard]] Sewn sew(Simulation& world, ClothId cloth, const SewnChange& change = {});
/// sew() for a cloth that has levels in common, and whose settings or model change.
[[nodiscard]] Sewn sew_again(Simulation& world, const Cloth& cloth, const SewnChange& change = {});
/// sew() for all cloths that these seams join. Each cloth is in one of the results.
[[nodiscard]] std::vector<Sewn> sew_after(Simulation& world, const SewnChange& change);

}  // namespace weft
