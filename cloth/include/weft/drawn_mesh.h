#pragma once
// A fine mesh that is drawn over a coarse simulated one. It follows the cloth with all its own detail, and is
// rounded where the cloth's triangles are coarse.

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

/// The drawn mesh in the renderer's order: a vertex with two normals or texture coordinates is there twice.
struct DrawnSurface {
    std::span<const Vec3> vertices{};       ///< positions over the cloth at the time of binding [m]
    std::span<const Triangle> triangles{};  ///< counter-clockwise seen from the front
    std::span<const Vec2> texcoords{};      ///< one a vertex, or none; tangents point where u grows
    /// One a vertex, of any length, or none: then area-weighted means of each vertex's triangles.
    std::span<const Vec3> normals{};
};

struct DrawnMeshSettings {
    /// Fraction by which points move from the flat triangle to the tangent planes at its corners, 0 to 1
    /// (Boubekeur, Alexa, "Phong tessellation", 2008). 0: flat. 1/2 is exact where the cloth is bent like a
    /// parabola.
    float rounding = 0.5f;
    /// Greatest distance from the cloth at which a vertex is bound [m], above 0 to 10.
    float reach = 0.1f;
};

/// Buffers that update() writes, laid out as they are uploaded: each one element a vertex, or none.
struct DrawnVertices {
    std::span<Vec4> positions{};  ///< x y z [m], w 1
    std::span<Vec4> normals{};    ///< x y z, unit length, w 0
    /// x y z, unit length, along the surface; w is 1 or -1: the other tangent is w times normal x tangent (as
    /// in glTF).
    std::span<Vec4> tangents{};
};

class WEFT_API DrawnMesh {
  public:
    /// Binds each vertex to the nearest triangle of the cloth as it is now, preferring triangles within reach
    /// that face as the vertex does. A bond is barycentric coordinates and an offset that turns with the
    /// triangle. Binding takes 64 bytes a vertex, and time in proportion to (vertices + triangles) times the
    /// logarithm of triangles. Errors, with the vertex or triangle: a position that is not finite, positions
    /// out of reach (their number, and the first 16), an index out of range, other numbers of texture
    /// coordinates or normals than of vertices; a setting out of range.
    [[nodiscard]] static Result<DrawnMesh> bind(const ClothView& cloth, const DrawnSurface& surface,
                                                const DrawnMeshSettings& settings = {});
    DrawnMesh(DrawnMesh&&) noexcept;
    DrawnMesh& operator=(DrawnMesh&&) noexcept;
    ~DrawnMesh();

    [[nodiscard]] std::size_t size() const noexcept;  ///< number of vertices

    /// Writes vertices [first, first + count), as far as they exist, for the cloth's state in `cloth`. It
    /// allocates nothing and does not change the DrawnMesh, so that threads may divide the vertices among
    /// them. Spans that are too short are left alone.
    ///
    /// Precondition: `cloth` is a view of the cloth that the mesh was bound to.
    void update(const ClothView& cloth, const DrawnVertices& to, std::size_t first = 0,
                std::size_t count = SIZE_MAX) const noexcept;

  private:
    struct Bonds;
    explicit DrawnMesh(std::unique_ptr<Bonds> bonds);
    std::unique_ptr<Bonds> bonds_;
};

}  // namespace weft
