#pragma once
// The particles that are near one another along the cloth at rest, and so are meant to be close.

#include <cstdint>
#include <span>

#include "collision/search/rest_filter.h"
#include "engine/memory/list_checks.h"
#include "engine/memory/shared_buffer.h"
#include "weft/error.h"

namespace weft {

/// Which particles are joined, and how far apart they are at rest. Per particle i: `neighbours[offsets[i] ..
/// offsets[i + 1])`, ascending, at `lengths` [m] of the same places. Each join is listed at both its ends.
struct RestGraph {
    std::span<const std::uint32_t> offsets, neighbours;
    std::span<const float> lengths;
};

/// For each particle those that are joined to it, and those whose shortest way along joins is less than
/// `detour` times the distance. Where the cloth starts has no part in it: layers that start close still meet.
class RestNeighbours {
  public:
    /// A way along edges is longer than the straight one: by up to 8 % in a grid with diagonals, more in
    /// meshes whose triangles are irregular.
    static constexpr double detour = 1.25;
    /// So that memory grows with the number of particles only: on average over all of them.
    static constexpr std::size_t most_per_particle = 256;

    /// By a bounded search from each particle (Dijkstra 1959). Error: the distance is so large that lists
    /// would be longer than most_per_particle on average.
    [[nodiscard]] static Result<RestNeighbours> find(const RestGraph& graph, float distance);

    /// visit(list) and visit.value(number) for all of it.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.distance_);
        visit(self.offsets_);
        visit(self.neighbours_);
    }
    /// Whether lists that were read name only what there is, for so many particles.
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
