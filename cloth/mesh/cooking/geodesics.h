#pragma once
// Distances along the cloth.

#include <array>
#include <cstdint>
#include <span>

#include "cloth/mesh/cook.h"
#include "engine/memory/hooked_vector.h"
#include "engine/memory/shared_buffer.h"

namespace weft {

/// A particle from which distances are measured. A particle keeps only the nearest source of each group.
struct GeodesicSource {
    std::uint32_t particle, group;
};

/// The way along the cloth to one source.
struct GeodesicReach {
    static constexpr std::uint32_t none = ~0u;
    double distance = 0;  ///< [m]
    std::uint32_t source = none, group = none;
};

/// A triangle laid flat, relative to one corner. The opposite side begins at the next corner; the corner lies
/// `along` from there and `height` above it.
struct GeodesicCorner {
    double along, height, side;  ///< [m]
    bool is_obtuse;
};

/// Distances on the rest surface from given particles, by fast marching on its triangles (Kimmel and Sethian
/// 1998).
class Geodesics {
  public:
    static constexpr std::size_t most_reached = 4;

    explicit Geodesics(const ClothModel& model);

    /// Allocates the memory of march(), which a copy lacks.
    void reserve() { front_.reserve(most_reached * reached_.size()); }

    /// Finds for each particle the groups of sources that are nearest along the cloth. Does not allocate.
    /// Precondition: reserve() has been called.
    void march(const ClothModel& model, std::span<const GeodesicSource> sources) noexcept;

    /// A particle's ways, the nearest first. Source none: no further source can be reached.
    [[nodiscard]] std::span<const GeodesicReach> from(std::uint32_t particle) const {
        return reached_[particle];
    }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Front {
        double distance;
        std::uint32_t particle, source;
    };
    using Reached = std::array<GeodesicReach, most_reached>;

    [[nodiscard]] bool is_superseded(const Front& front) const;
    void push(const Front& front);
    void reach(std::uint32_t particle, const GeodesicReach& way);
    void cross_triangle(const Triangle& particles, const std::array<GeodesicCorner, 3>& shape,
                        std::uint32_t from, const GeodesicReach& way);

    SharedBuffer<std::array<GeodesicCorner, 3>> triangles_;
    HookedVector<Reached> reached_;
    HookedVector<Front> front_;  // a heap, the nearest first
};

}  // namespace weft
