#pragma once
// A finer mesh for drawing: four triangles for each of the cloth's, so that folds of coarse meshes are round.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/weft.h"

namespace weft::demo {

/// The mesh's vertices, then one per edge: the edge's middle, moved towards the tangent planes at its ends
/// (Boubekeur, Alexa, "Phong tessellation", 2008).
class RoundedMesh {
  public:
    RoundedMesh() = default;
    RoundedMesh(std::span<const Triangle> triangles, std::span<const Vec2> texcoords, std::size_t vertices);

    [[nodiscard]] std::size_t size() const { return vertices_ + edges_.size(); }
    [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
    [[nodiscard]] std::span<const Vec2> texcoords() const { return texcoords_; }

    /// Results by vertex, in spans of size().
    struct To {
        std::span<Vec4> positions, previous_positions, normals;
    };
    /// Middles move by at most `most` of their edges' lengths; more lets drawn layers in contact intersect.
    void update(const ClothView& cloth, const To& to, float most = 1) const;
    /// Interpolates a quantity of particles to vertices.
    void spread(const ClothView& cloth, std::span<const Vec4> particles, std::span<Vec4> to) const;

  private:
    std::size_t vertices_ = 0;
    std::vector<std::array<std::uint32_t, 2>> edges_;  // vertices at their ends
    std::vector<Triangle> triangles_;
    std::vector<Vec2> texcoords_;
};

}  // namespace weft::demo
