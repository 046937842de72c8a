#include "cloth/history.h"

namespace weft {

// Curtiss and Hirschfelder 1952: x_base = (4 x_n - x_n-1) / 3 = x_n + (x_n - x_n-1) / 3, and v likewise. A
// pinned particle's bases are such that x_base + gamma v is x_n + h v.
void History::begin(Parallel& parallel, const ClothState& state) {
    constexpr float third = 1.0f / 3.0f;
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vector3 x = xyz(state.positions[i]), v = xyz(state.velocities[i]);
            const bool pinned = state.positions[i].w == 0;
            const bool came_straight = pinned || x != xyz(arrivals_[i]);
            const Vector3 displacement = came_straight ? Vector3(h_ * v) : xyz(displacements_[i]);
            const Vector3 change = pinned ? Vector3(Vector3::Zero()) : xyz(velocity_changes_[i]);
            base_positions_[i] = to_vec4(x + third * displacement, state.positions[i].w);
            base_velocities_[i] = to_vec4(v + third * change, 0);
        }
    });
}

std::size_t History::bytes() const noexcept {
    return displacements_.bytes() + velocity_changes_.bytes() + arrivals_.bytes() + base_positions_.bytes() +
           base_velocities_.bytes();
}

}  // namespace weft
