#pragma once
// Four triangles drawn for each one of the cloth's, so that folds and edges are round where triangles are
// coarse.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/weft.h"

namespace weft::demo {

/// Vertices of the mesh, then one in the middle of each edge, drawn from the flat triangle towards the planes
/// of the edge's normals (Boubekeur, Alexa, "Phong tessellation", 2008).
class RoundedMesh {
  public:
    RoundedMesh() = default;
    RoundedMesh(std::span<const Triangle> triangles, std::span<const Vec2> texcoords, std::size_t vertices);

    [[nodiscard]] std::size_t size() const { return vertices_ + edges_.size(); }
    [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
    [[nodiscard]] std::span<const Vec2> texcoords() const { return texcoords_; }

    /// Spans of size(), by vertex.
    struct To {
        std::span<Vec4> positions, previous_positions, normals;
    };
    /// Middles go out no farther than `most` of their edges' lengths: cloth that lies on itself would be seen
    /// through itself.
    void update(const ClothView& cloth, const To& to, float most = 1) const;
    /// What is given for particles, for vertices.
    void spread(const ClothView& cloth, std::span<const Vec4> particles, std::span<Vec4> to) const;

  private:
    std::size_t vertices_ = 0;
    std::vector<std::array<std::uint32_t, 2>> edges_;  // vertices at their ends
    std::vector<Triangle> triangles_;
    std::vector<Vec2> texcoords_;
};

}  // namespace weft::demo
