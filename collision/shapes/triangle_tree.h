#pragma once
// Triangles in a hierarchy of boxes, with the normals that tell inside from outside.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/vector.h"
#include "weft/error.h"
#include "weft/types.h"

namespace weft {

using Corners = std::array<std::uint32_t, 3>;

class TriangleTree {
  public:
    /// A box around all below it. Its children are `first` and `first + 1`; a leaf has triangles from `first`
    /// on.
    struct Node {
        Vec3 lower, upper;  // a little wider than what it holds: rounding prunes nothing that is nearest
        std::uint32_t first, count;  // 0: no leaf
    };

    /// Vertices that are at one position become one. Error: a vertex that is no number or too far, a triangle
    /// of vertices that do not exist or of two that are one, and, if it is to be closed, an edge without two
    /// triangles, one that is wound against its neighbour, or all of them inside out. `name` begins messages.
    [[nodiscard]] static Result<TriangleTree> make(const char* name, std::span<const Vec3> vertices,
                                                   std::span<const Corners> triangles, bool closed);

    /// Error: as above, or another number of vertices than it was made of. `name` begins messages.
    [[nodiscard]] Result<void> validate_deform(const char* name, std::span<const Vec3> vertices) const;
    /// Moves the vertices. Their displacements are kept, added to those kept before if it is moved `again`.
    /// Precondition: validate_deform().
    void deform(std::span<const Vec3> vertices, bool again);
    /// Takes over vertices, and what they moved by, that it had before; once there is room, it takes no
    /// memory.
    void reserve_displacements() { displacements_.reserve(vertices_.size()); }
    void put_back(std::span<const Vec3> vertices, std::span<const Vec3> displacements);

    [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }
    [[nodiscard]] std::span<const Vec3> vertices() const noexcept { return vertices_; }
    [[nodiscard]] std::span<const Vec3> displacements() const noexcept { return displacements_; }
    [[nodiscard]] const Corners& triangle(std::uint32_t t) const noexcept { return triangles_[t]; }
    [[nodiscard]] std::size_t size() const noexcept { return triangles_.size(); }
    [[nodiscard]] bool is_closed() const noexcept { return closed_; }
    [[nodiscard]] Eigen::AlignedBox3f box() const;

    /// The pseudo-normal of where these weights of the corners lie on a triangle: on its face, an edge, or a
    /// vertex (Baerentzen, Aanaes 2005). Of no certain length.
    [[nodiscard]] Vector3 pseudo_normal(std::uint32_t triangle, const std::array<float, 3>& weights) const;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    [[nodiscard]] Result<void> find_neighbours(const char* name);
    void build();
    void fit();
    void find_normals();

    std::vector<Vec3> vertices_, displacements_;
    std::vector<std::uint32_t> representative_;  // of each vertex that came in
    std::vector<Corners> triangles_;             // in the order of leaves
    std::vector<Corners> neighbours_;            // across the edge from each corner to the next
    std::vector<Vec3> face_normals_, vertex_normals_;
    std::vector<Node> nodes_;
    bool closed_ = true;
};

}  // namespace weft
