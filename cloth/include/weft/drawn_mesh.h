#pragma once
// A fine mesh that is drawn over a coarse simulated one. It follows the cloth with all its own detail, and is
// rounded where the cloth's triangles are coarse.

#include <array>
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

/// The bond of a drawn vertex to a triangle of cloth: what update() reads, and what a vertex shader does that
/// skins on a GPU. Upload bonds once, and ClothView::positions and normals after each step.
///
/// The formula, where x0, x1, x2 and n0, n1, n2 are positions and normals of `particles`, w0 = 1 - second -
/// third, w1 = second, w2 = third, and r is DrawnMesh::rounding():
///
///     flat     = w0 x0 + w1 x1 + w2 x2
///     rise     = w0 dot(x0 - flat, n0) n0 + w1 dot(x1 - flat, n1) n1 + w2 dot(x2 - flat, n2) n2
///     e, f     = x1 - x0, x2 - x0
///     out      = normalize(w0 n0 + w1 n1 + w2 n2)
///     along    = normalize(e - dot(e, out) out)
///     across   = cross(out, along)
///     position = flat + r rise + offset.x along + offset.y across + offset.z out
///     normal   = normal.x along + normal.y across + normal.z out
///     way      = tangent.x e + tangent.y f
///     tangent  = normalize(way - dot(way, normal) normal), with w = handedness
///
/// Where the cloth's triangle or its mean normal has no size, update() takes other directions, and a shader
/// has to guard its normalize().
struct alignas(64) DrawnBond {
    std::array<std::uint32_t, 3> particles{};  ///< the triangle's, below the number of particles
    float second = 0, third = 0;     ///< barycentric coordinates of the last two particles, 0 to 1 in sum
    std::array<float, 3> offset{};   ///< from the rounded surface, in the triangle's frame [m]
    std::array<float, 3> normal{};   ///< in that frame, unit length
    std::array<float, 2> tangent{};  ///< multiples of the triangle's sides from its first corner
    float handedness = 1;            ///< 1 or -1, as the w of DrawnVertices::tangents
    float unused = 0;
};
static_assert(sizeof(DrawnBond) == 64, "a bond fills one cache line");

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

    /// Begins a blend from what another mesh of the garment has drawn last, so that nothing jumps where this
    /// one takes over (World::set_level, carry_state()): update() writes these places and normals for the
    /// present state of `cloth`. The difference turns with the cloth's triangles, and blend() takes it away.
    /// A blend begins from any, and takes 128 bytes a vertex until it ends. Errors, by which nothing changes:
    /// other numbers than one position and one normal a vertex (normals may be left out), one that is not
    /// finite; a cloth of another mesh than was bound to.
    Result<void> begin_blend(const ClothView& cloth, std::span<const Vec4> positions,
                             std::span<const Vec4> normals = {});
    /// Sets the part of the difference that is left, 1 as at begin_blend(): call it once a step with less,
    /// over a quarter of a second. 0 ends the blend. It takes no memory, and nothing happens without a blend.
    /// bonds() follow. Error: a part that is not from 0 to 1.
    Result<void> blend(float left);

    /// Returns the bonds, one a vertex; the span holds until the DrawnMesh is gone.
    [[nodiscard]] std::span<const DrawnBond> bonds() const noexcept;
    [[nodiscard]] float rounding() const noexcept;  ///< DrawnMeshSettings::rounding of the binding

    /// Number of bytes that save() writes: 64 a vertex, and 64. They are little-endian, with a version and a
    /// checksum. Of a blend nothing is saved.
    [[nodiscard]] std::size_t save_size() const noexcept;
    /// Error: `to` has another size than save_size().
    Result<void> save(std::span<std::byte> to) const;
    /// Reads saved bonds in some 0.1 us a vertex. `cloth` is any cloth with the particles and triangles of
    /// the one that was bound to, in any pose: of the same mesh and the same version of Weft. Errors: bytes
    /// that are no such save, of another version, cut short or damaged; bonds to another mesh.
    [[nodiscard]] static Result<DrawnMesh> load(std::span<const std::byte> saved, const ClothView& cloth);

  private:
    friend WEFT_API Result<void> carry_state(World& world, ClothId from, ClothId to, const DrawnMesh& bonds);
    struct Bonds;
    explicit DrawnMesh(std::unique_ptr<Bonds> bonds);
    std::unique_ptr<Bonds> bonds_;
};

/// Has a cloth take over from another mesh of the same garment, between two steps: a finer one where the
/// viewer comes near, a coarser one where he leaves. It gets places, velocities and the places before the
/// last step from the other's surface, by World::resume_cloth(). `bonds` are of the vertices of `to`'s mesh,
/// bound once to `from` while both lie in one pose. Momentum changes by less than 2 % of the cloth's mass
/// times its root mean square speed; folds that the coarser mesh cannot have are lost. Enable `to` before and
/// disable `from` afterwards, since a disabled cloth stands still. Errors: a stale id; bonds to another mesh
/// than `from`'s, or of another number of vertices than `to`'s.
WEFT_API Result<void> carry_state(World& world, ClothId from, ClothId to, const DrawnMesh& bonds);

}  // namespace weft
