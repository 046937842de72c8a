#pragma once
// Shared by the tests that draw: a context, simple sheets, and questions to pictures.

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <optional>

#include "weft/render/context.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

/// A renderer without a display. Skips where the system cannot draw, and fails at whatever the driver objects
/// to, and at objects that the renderer leaves behind.
class Drawing : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    SceneRenderer& renderer() { return *renderer_; }
    Context& context() { return *context_; }

    bool counts_objects = true;  ///< what was made besides is left

  private:
    std::optional<Context> context_;
    std::optional<SceneRenderer> renderer_;
    std::array<int, 9> objects_{};  // before there was a renderer
};

/// Buffers of one cloth, one vertex per particle, and the normals of the map itself.
struct Sheet {
    std::vector<Vec4> positions, normals;
    std::vector<Vec2> texcoords;
    std::vector<std::uint32_t> vertex_to_particle;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    [[nodiscard]] ClothSurface surface(const FabricLook& look) const;
    [[nodiscard]] ClothFrame frame() const;
};

/// Side x side particles in the plane through `center`, spanned by `u` and `v` from edge to edge; its front
/// faces u x v.
[[nodiscard]] Sheet make_sheet(std::uint32_t side, const Vec3& center, const Vec3& u, const Vec3& v);

ClothHandle show(SceneRenderer& renderer, const Sheet& sheet, const FabricLook& look);

/// Red in front and green behind: sky and ground are neither.
[[nodiscard]] FabricLook signal_look();

struct Pixel {
    int red, green, blue;
    [[nodiscard]] int light() const { return red + green + blue; }
    [[nodiscard]] bool is_red() const { return red > 2 * green && red > 2 * blue; }
    [[nodiscard]] bool is_green() const { return green > 2 * red && green > 2 * blue; }
};

[[nodiscard]] Pixel pixel(const Image& image, int x, int y);
[[nodiscard]] int count_pixels(const Image& image, const std::function<bool(const Pixel&)>& condition);

/// Inclusive; empty while left > right.
struct PixelBox {
    int left, top, right, bottom;
};
[[nodiscard]] PixelBox box_of(const Image& image, const std::function<bool(const Pixel&)>& condition);

/// Where a point of the world lies in the picture, in pixels from the upper left corner.
struct PixelPoint {
    int x, y;
};
[[nodiscard]] PixelPoint project(const OrbitCamera& camera, const Vec3& point, int width, int height);
[[nodiscard]] Pixel pixel_at(const Image& image, const OrbitCamera& camera, const Vec3& point);

}  // namespace weft::render
