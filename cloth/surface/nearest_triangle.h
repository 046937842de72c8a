#pragma once
// The triangle of a cloth that is nearest to a point.

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/vector.h"
#include "weft/world.h"

namespace weft {

/// Triangles by the cells of a grid that their boxes meet, sorted.
class NearestTriangle {
  public:
    /// The view must outlive this.
    explicit NearestTriangle(const ClothView& cloth);

    struct Found {
        std::uint32_t triangle = 0;
        float second = 0, third = 0;  ///< barycentric coordinates of its last two corners
        float distance = 0;           ///< [m]
    };
    /// Of those that face as `normal` does, or of all where none of these is within reach; of several as near
    /// the first. None: nothing is within reach [m].
    [[nodiscard]] std::optional<Found> to(const Vector3& point, const Vector3& normal, float reach) const;

  private:
    struct Entry {
        std::uint64_t cell;
        std::uint32_t triangle;
        friend auto operator<=>(const Entry&, const Entry&) = default;
    };
    /// The better of what was found and the triangles of one cell.
    void look(std::uint64_t cell, const Vector3& point, const Vector3& normal, std::optional<Found>& facing,
              std::optional<Found>& any) const;

    const ClothView& cloth_;
    float cell_ = 1;  // edge of a cell [m]
    std::vector<Entry> entries_;
};

}  // namespace weft
