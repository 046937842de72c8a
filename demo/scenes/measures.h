#pragma once
// Sheets of scenes, and measures for the scenes' checks.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "demo/scene.h"
#include "engine/vector.h"
#include "weft/weft.h"

namespace weft::demo {

/// Rows and columns of about `particles` in squares, for a sheet `width` by `height`.
struct GridSize {
    std::uint32_t rows, columns;
};
[[nodiscard]] GridSize grid_size(std::uint32_t particles, float width, float height);

/// A sheet of about `particles` in squares, with columns along u and rows along v. Throws Refusal.
[[nodiscard]] Mesh sheet_of(std::uint32_t particles, const Vec3& corner, const Vec3& u, const Vec3& v);
/// Vertices of a sheet's row or column.
[[nodiscard]] std::vector<std::uint32_t> row_of(const Mesh& sheet, std::uint32_t row);
[[nodiscard]] std::vector<std::uint32_t> column_of(const Mesh& sheet, std::uint32_t column);

[[nodiscard]] bool is_pinned(const ClothView& view, std::uint32_t vertex);
/// The position of one of the mesh's own vertices.
[[nodiscard]] Vector3 vertex_position(const ClothView& view, std::uint32_t vertex);

/// Longest and mean ratio of current to rest length, over the edges that carry structural springs: along the
/// threads of a sheet, all edges of another mesh.
struct Stretch {
    float worst = 0, mean = 0;
};
[[nodiscard]] Stretch structural_stretch(const Mesh& mesh, const ClothView& view);

/// Distance of the closest two particles whose rest positions are at least `rest_apart` from each other [m]:
/// how well layers are kept apart. For a mesh that starts as its own rest shape.
[[nodiscard]] float closest_layers(const Mesh& mesh, const ClothView& view, float rest_apart);

/// A scene of one cloth.
class OneCloth : public Scene {
  protected:
    /// Adds mesh_ to the World, as cloth_. Returns what is drawn: the cloth alone. Throws Refusal.
    SceneContent add_cloth(World& world, const ClothSettings& settings, const render::FabricLook& look,
                           const render::OrbitCamera& camera);

    ClothId cloth_;
    Mesh mesh_;
};

/// Collects what a scene expects of its end. A value that is not a number meets no expectation.
class Checks {
  public:
    void at_least(std::string_view what, float value, float bound);
    void at_most(std::string_view what, float value, float bound);
    /// The cloth's view. Expects positions and velocities to be finite.
    ClothView cloth(const World& world, ClothId id);
    /// Bounds of structural_stretch(). Infinity: the mean is not judged.
    void stretch(const Mesh& mesh, const ClothView& view, float worst,
                 float mean = std::numeric_limits<float>::infinity());
    /// Expects the vertex to be pinned, and within a tenth of a millimetre of `where`.
    void pinned_at(const ClothView& view, std::uint32_t vertex, const Vec3& where);

    /// Error: all that failed, each with its value.
    [[nodiscard]] Result<void> result() const;

  private:
    void fail(const std::string& failure);
    std::string failures_;
};

}  // namespace weft::demo
