#pragma once
// A fine mesh that is drawn over a coarse one that is simulated: it follows the cloth with all its own
// detail, and is rounded where the cloth's triangles are coarse.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "weft/error.h"
#include "weft/export.h"
#include "weft/mesh.h"
#include "weft/types.h"
#include "weft/world.h"

namespace weft {

/// What is drawn, in the renderer's own order: a vertex that has two normals or texture coordinates is there
/// twice.
struct DrawnSurface {
    std::span<const Vec3> vertices{};       ///< over the cloth as it is when they are bound [m]
    std::span<const Triangle> triangles{};  ///< counter-clockwise seen from the front
    std::span<const Vec2> texcoords{};  ///< one a vertex, or none; tangents point where the first one grows
    /// One a vertex, of any length, or none: then they are those of the triangles, by area, each vertex
    /// apart.
    std::span<const Vec3> normals{};
};

struct DrawnMeshSettings {
    /// How far points are drawn from the flat triangle to the planes that its corners' normals span, 0 to 1
    /// (Boubekeur, Alexa, "Phong tessellation", 2008). 0: flat. 1/2 is exact where the cloth is bent like a
    /// parabola.
    float rounding = 0.5f;
    /// How far from the cloth a vertex may be bound [m], above 0 to 10.
    float reach = 0.1f;
};

/// Where update() writes, in the layout in which buffers are uploaded: each one element a vertex, or none.
struct DrawnVertices {
    std::span<Vec4> positions{};  ///< x y z [m], w 1
    std::span<Vec4> normals{};    ///< x y z, unit length, w 0
    /// x y z, unit length, along the surface; w is 1 or -1: the other tangent is w times normal x tangent (as
    /// in glTF).
    std::span<Vec4> tangents{};
};

class WEFT_API DrawnMesh {
  public:
    /// Binds each vertex to the nearest triangle of the cloth as it is now, of those that face as it does if
    /// one is within reach: by barycentric coordinates, and an offset that turns with the triangle. It takes
    /// 64 bytes a vertex, and time in proportion to (vertices + triangles) times the logarithm of triangles.
    /// Errors, with the vertex or triangle: a position that is not finite, positions out of reach (their
    /// number, and the first 16), an index out of range, other numbers of texture coordinates or normals than
    /// of vertices; a setting out of range.
    [[nodiscard]] static Result<DrawnMesh> bind(const ClothView& cloth, const DrawnSurface& surface,
                                                const DrawnMeshSettings& settings = {});
    DrawnMesh(DrawnMesh&&) noexcept;
    DrawnMesh& operator=(DrawnMesh&&) noexcept;
    ~DrawnMesh();

    [[nodiscard]] std::size_t size() const noexcept;  ///< vertices

    /// Writes vertices [first, first + count), those there are, as the cloth is in `cloth`. It allocates
    /// nothing and changes nothing of this: threads may share the vertices. Spans that are too short are left
    /// alone.
    ///
    /// Precondition: a view of the cloth that it was bound to.
    void update(const ClothView& cloth, const DrawnVertices& to, std::size_t first = 0,
                std::size_t count = SIZE_MAX) const noexcept;

  private:
    struct Bonds;
    explicit DrawnMesh(std::unique_ptr<Bonds> bonds);
    std::unique_ptr<Bonds> bonds_;
};

}  // namespace weft
