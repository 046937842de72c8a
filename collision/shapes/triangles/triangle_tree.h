#pragma once
// A bounding volume hierarchy of triangles, with the pseudo-normals that tell inside from outside.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "collision/shapes/triangles/triangle_leaves.h"
#include "engine/vector.h"
#include "weft/error.h"
#include "weft/types.h"

namespace weft {

class TriangleTree {
  public:
    /// Bounding box of a subtree. Children are `first` and `first + 1`; a leaf's triangles begin at `first`,
    /// a multiple of TriangleLeaf::size, and fill one TriangleLeaf.
    struct Node {
        Vec3 lower, upper;           // padded against rounding, which must not prune the nearest triangle
        std::uint32_t first, count;  // count 0: an inner node
    };

    /// Merges vertices at the same position. Error: a vertex that is not finite or out of range; a triangle
    /// with a missing vertex, or with two corners that are merged; if `closed`, an edge without two
    /// triangles, a triangle wound against its neighbour, or a mesh inside out. `name` begins messages.
    [[nodiscard]] static Result<TriangleTree> make(const char* name, std::span<const Vec3> vertices,
                                                   std::span<const Corners> triangles, bool closed);

    /// Error: another number of vertices, one that is not finite or out of range, or a closed mesh turned
    /// inside out. `name` begins messages.
    [[nodiscard]] Result<void> validate_deform(const char* name, std::span<const Vec3> vertices) const;
    /// Moves the vertices and stores their displacements, added to those stored before if moved `again`.
    /// Precondition: validate_deform().
    void deform(std::span<const Vec3> vertices, bool again);
    /// Reserves the memory of put_back(), which restores earlier vertices and displacements and then
    /// allocates nothing.
    void reserve_displacements() { displacements_.reserve(vertices_.size()); }
    void put_back(std::span<const Vec3> vertices, std::span<const Vec3> displacements);

    [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }
    [[nodiscard]] std::span<const TriangleLeaf> leaves() const noexcept { return leaves_; }
    [[nodiscard]] std::span<const Vec3> vertices() const noexcept { return vertices_; }
    [[nodiscard]] std::span<const Vec3> face_normals() const noexcept { return face_normals_; }
    [[nodiscard]] std::span<const Vec3> displacements() const noexcept { return displacements_; }
    [[nodiscard]] const Corners& triangle(std::uint32_t t) const noexcept { return triangles_[t]; }
    [[nodiscard]] std::size_t size() const noexcept { return triangles_.size(); }
    [[nodiscard]] bool is_closed() const noexcept { return closed_; }
    [[nodiscard]] Eigen::AlignedBox3f box() const;

    /// Weight of a triangle's corner below which a point is on the border across from it.
    static constexpr float on_border = 1e-6f;
    /// The pseudo-normal, not normalised, at the point of a triangle with these barycentric weights: that of
    /// the face, of an edge or of a vertex (Baerentzen, Aanaes 2005).
    [[nodiscard]] Vector3 pseudo_normal(std::uint32_t triangle, const std::array<float, 3>& weights) const;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    [[nodiscard]] Result<void> find_neighbours(const char* name);
    void build();
    void fit();

    std::vector<Vec3> vertices_, displacements_;
    std::vector<std::uint32_t> representative_;  // the first vertex at the same position, by vertex
    std::vector<Corners> triangles_;             // in the order of leaves
    std::vector<Corners> neighbours_;            // across the edge from each corner to the next
    std::vector<Vec3> face_normals_, vertex_normals_;
    std::vector<Node> nodes_;
    std::vector<TriangleLeaf> leaves_;
    bool closed_ = true;
};

}  // namespace weft
