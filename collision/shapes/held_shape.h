#pragma once
// A shape that a World holds for the colliders that are placed instances of it.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "collision/shapes/outside_cells.h"
#include "collision/shapes/triangles/triangle_tree.h"
#include "engine/vector.h"
#include "weft/error.h"
#include "weft/shapes.h"

namespace weft {

struct HeldHeights {
    std::uint32_t rows, columns;
    float spacing;  ///< [m]
    std::vector<float> heights;

    [[nodiscard]] Vector3 vertex(std::uint32_t row, std::uint32_t column) const {
        return {static_cast<float>(column) * spacing, heights[std::size_t{row} * columns + column],
                static_cast<float>(row) * spacing};
    }
    /// One of a cell's two triangles, front up: half 0 lies along its row, 1 along its column.
    [[nodiscard]] std::array<Vector3, 3> triangle(std::uint32_t row, std::uint32_t column, int half) const {
        const Vector3 a = vertex(row, column), d = vertex(row + 1, column + 1);
        if (half == 0) return {a, d, vertex(row, column + 1)};
        return {a, vertex(row + 1, column), d};
    }
    [[nodiscard]] std::uint32_t triangles() const { return 2 * (rows - 1) * (columns - 1); }
};

struct HeldDistances {
    Vector3 origin;
    float cell;  ///< [m]
    std::array<std::uint32_t, 3> corners;
    std::vector<float> distances;  ///< x is fastest, then y

    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
        return x + corners[0] * (y + std::size_t{corners[1]} * z);
    }
};

/// A capsule inside a body, in the body's local frame: its axis and radius. It runs along a long body; in a
/// body that is as long as wide it is a ball.
struct InnerRod {
    Vector3 a, b;  ///< [m]
    float radius;  ///< [m]
    float width;   ///< greatest half width of the body across the axis [m]
};

class HeldShape {
  public:
    /// Error: a value outside its range in shapes.h, or a mesh or hull that breaks its conditions there.
    [[nodiscard]] static Result<HeldShape> make(const Shape& shape);
    /// See TriangleTree::deform. `step`: the next step, over which it moves. Errors: no triangle mesh,
    /// invalid vertices.
    Result<void> deform(std::span<const Vec3> vertices, std::uint64_t step);

    using Data = std::variant<TriangleTree, HeldHeights, HeldDistances>;
    [[nodiscard]] const Data& data() const noexcept { return data_; }
    [[nodiscard]] const Eigen::AlignedBox3f& box() const noexcept { return box_; }
    /// Points of the surface that rigid bodies touch others with: a mesh's vertices, or of more than
    /// most_edged_corners those that are farthest in 26 directions. A height field has none.
    [[nodiscard]] std::span<const Vec3> corners() const noexcept { return corners_; }
    [[nodiscard]] bool is_convex() const noexcept { return convex_; }
    /// Most corners of an edged body: a convex body whose edges can part cloth, either a hull or a closed
    /// mesh that has not been deformed.
    static constexpr std::size_t most_edged_corners = 32;
    [[nodiscard]] bool is_edged() const noexcept { return is_edged_ && original_.empty(); }
    /// The capsule inside a closed mesh that has not been deformed; null if there is none.
    [[nodiscard]] const InnerRod* rod() const noexcept {
        return rod_ && original_.empty() ? &*rod_ : nullptr;
    }
    /// Whether the shape has no far side: a particle that has passed the surface is inside, at any depth.
    [[nodiscard]] bool is_ground() const noexcept { return std::holds_alternative<HeldHeights>(data_); }
    /// Whether point q of a closed mesh may lie deeper inside than `than`; never wrongly false. Distances at
    /// the corners of coarse cells decide or, for a deformed mesh, cells known to be outside.
    [[nodiscard]] bool may_be_deeper(const Vector3& q, float than) const;
    [[nodiscard]] bool deforms_in(std::uint64_t step) const noexcept { return deforms_in_ == step; }

    /// The state of a deformation, to be hashed, saved and restored; empty for a shape that is not deformed.
    struct Deformation {
        std::span<const Vec3> vertices, displacements;
        std::uint64_t step = 0;  ///< the step over which they move by `displacements`
    };
    [[nodiscard]] Deformation deformation() const noexcept;
    /// Number of vertices that can deform.
    [[nodiscard]] std::size_t deformable() const noexcept;
    /// Reserves the memory of put_back(), which then cannot fail. May throw.
    void prepare_deformation();
    /// Restores a deformation; an empty one restores the original shape. Precondition: prepare_deformation()
    /// has run, and deform() would accept the vertices.
    void put_back(const Deformation& deformation);
    [[nodiscard]] ShapeInfo info() const;

  private:
    HeldShape(Data&& data, bool convex) : data_(std::move(data)), convex_(convex) { find_box(); }
    void find_box();
    void find_coarse();
    void find_rod();
    void find_corners();
    Data data_;
    Eigen::AlignedBox3f box_;
    HeldDistances coarse_{};      // distances of a closed mesh
    OutsideCells outside_;        // cells of a closed mesh that has been deformed
    std::vector<Vec3> original_;  // vertices before the first deformation; empty: none
    std::optional<InnerRod> rod_;
    std::vector<Vec3> corners_;
    bool convex_, is_edged_ = false;
    std::uint64_t deforms_in_ = 0;  // 0: none
};

/// Finds for each point, in the shape's local frame, the outward normal at its nearest surface point and in w
/// the signed distance, negative inside. w is `sight` if the surface is farther. Precondition: as many
/// surfaces as points.
void find_surfaces(const HeldShape& shape, std::span<const Vec3> points, float sight,
                   std::span<Vec4> surfaces);

}  // namespace weft
