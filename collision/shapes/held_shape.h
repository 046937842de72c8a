#pragma once
// A shape that a World holds for the colliders that are placed instances of it.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "collision/shapes/outside_cells.h"
#include "collision/shapes/triangle_tree.h"
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
    /// The two triangles of a cell, front up: 0 along its row, 1 along its column.
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

/// What is round inside a body: its axis, in the body's own space, and balls about it. Of a long body what is
/// left once its sides are taken off; a ball if it is as long as it is wide.
struct InnerRod {
    Vector3 a, b;  ///< [m]
    float radius;  ///< [m]
    float width;   ///< half of what the body measures across at most [m]
};

class HeldShape {
  public:
    /// Error: a value outside its range in shapes.h, or a shape that is not what it says.
    [[nodiscard]] static Result<HeldShape> make(const Shape& shape);
    /// See TriangleTree::deform. Error: no triangle mesh. `step`: the next one, in which it moves so.
    Result<void> deform(std::span<const Vec3> vertices, std::uint64_t step);

    using Data = std::variant<TriangleTree, HeldHeights, HeldDistances>;
    [[nodiscard]] const Data& data() const noexcept { return data_; }
    [[nodiscard]] const Eigen::AlignedBox3f& box() const noexcept { return box_; }
    [[nodiscard]] bool is_convex() const noexcept { return convex_; }
    /// A convex body whose edges part cloth: a hull, or a closed mesh that has not been deformed, of at most
    /// so many corners.
    static constexpr std::size_t most_edged_corners = 32;
    [[nodiscard]] bool is_edged() const noexcept { return is_edged_ && original_.empty(); }
    /// Of a closed mesh that has not been deformed, if there is one; else null.
    [[nodiscard]] const InnerRod* rod() const noexcept {
        return rod_ && original_.empty() ? &*rod_ : nullptr;
    }
    /// Whoever passes it is inside, however deep.
    [[nodiscard]] bool is_ground() const noexcept { return std::holds_alternative<HeldHeights>(data_); }
    /// False only where the point of a closed mesh is not farther inside than that: by distances at the
    /// corners of coarse cells or, once the mesh has been deformed, by cells that are outside.
    [[nodiscard]] bool may_be_deeper(const Vector3& q, float than) const;
    [[nodiscard]] bool deforms_in(std::uint64_t step) const noexcept { return deforms_in_ == step; }

    /// What deforming has changed, to be hashed, kept and put back: nothing of a shape that has not been
    /// deformed.
    struct Deformation {
        std::span<const Vec3> vertices, displacements;
        std::uint64_t step = 0;  ///< in which they move by these
    };
    [[nodiscard]] Deformation deformation() const noexcept;
    /// How many vertices can deform.
    [[nodiscard]] std::size_t deformable() const noexcept;
    /// Room for as many as can deform, to be filled and put back: then nothing can fail. May throw.
    void prepare_deformation();
    /// Nothing: as it was made. Precondition: prepared, and vertices that deform() would take.
    void put_back(const Deformation& deformation);
    [[nodiscard]] ShapeInfo info() const;

  private:
    HeldShape(Data&& data, bool convex) : data_(std::move(data)), convex_(convex) { find_box(); }
    void find_box();
    void find_coarse();
    void find_rod();
    Data data_;
    Eigen::AlignedBox3f box_;
    HeldDistances coarse_{};      // of a closed mesh
    OutsideCells outside_;        // likewise, where it has been deformed
    std::vector<Vec3> original_;  // vertices, once it has been deformed
    std::optional<InnerRod> rod_;
    bool convex_, is_edged_ = false;
    std::uint64_t deforms_in_ = 0;  // 0: none
};

/// For each point of the shape's own space the outward normal where its surface is nearest, and in w the
/// distance, below 0 inside; `sight` where it is farther outside than that. Precondition: as many surfaces.
void find_surfaces(const HeldShape& shape, std::span<const Vec3> points, float sight,
                   std::span<Vec4> surfaces);

}  // namespace weft
