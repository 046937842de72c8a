#pragma once
// The particles that are near one another along the cloth at rest, and so are meant to be close.

#include <cstdint>
#include <span>

#include "collision/search/rest_filter.h"
#include "engine/memory/list_checks.h"
#include "engine/memory/shared_buffer.h"
#include "weft/error.h"

namespace weft {

/// Joins of particles, and their lengths at rest. Particle i has `neighbours[offsets[i] .. offsets[i + 1])`,
/// ascending, at `lengths` [m] of the same places. Each join is listed at both its ends.
struct RestGraph {
    std::span<const std::uint32_t> offsets, neighbours;
    std::span<const float> lengths;
};

/// For each particle, the particles joined to it, and those whose shortest path along joins is less than
/// `detour` times the distance. The cloth's start position has no effect: layers that start close still meet.
class RestNeighbours {
  public:
    /// A path along edges is longer than the straight one: by up to 8 % in a grid with diagonals, more in
    /// meshes whose triangles are irregular.
    static constexpr double detour = 1.25;
    /// Limit of the mean number over all particles: memory then grows with the number of particles only.
    static constexpr std::size_t most_per_particle = 256;

    /// Finds the neighbours by a bounded search from each particle (Dijkstra 1959). Error: the distance is so
    /// large that lists would be longer than most_per_particle on average.
    [[nodiscard]] static Result<RestNeighbours> find(const RestGraph& graph, float distance);

    /// Calls visit(list) and visit.value(number) for all members.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.distance_);
        visit(self.offsets_);
        visit(self.neighbours_);
    }
    /// Whether all indices in lists that were read are valid, for so many particles.
    [[nodiscard]] bool is_sound(std::uint32_t particles) const {
        return are_offsets(offsets_.span(), particles, neighbours_.size()) &&
               are_below(neighbours_.span(), particles);
    }

    [[nodiscard]] RestFilter filter() const noexcept { return {offsets_.span(), neighbours_.span()}; }
    /// The distance for which these were found [m].
    [[nodiscard]] float distance() const noexcept { return distance_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return offsets_.bytes() + neighbours_.bytes(); }

  private:
    float distance_ = 0;
    SharedBuffer<std::uint32_t> offsets_, neighbours_;
};

}  // namespace weft
