#include "drawing.h"

#include <glad/gl.h>

#include <algorithm>
#include <climits>
#include <Eigen/Geometry>

#include "render/view/matrices.h"
#include "tests/render/gl_objects.h"

namespace weft::render {

void Drawing::SetUp() {
#ifdef WEFT_NO_DRAWING
    GTEST_SKIP() << "OpenGL drivers are not instrumented for the thread sanitizer";
#else
    auto made = Context::offscreen(true);
    if (!made) GTEST_SKIP() << made.error().message;
    context_.emplace(std::move(*made));
    objects_ = count_gl_objects();
    auto renderer = SceneRenderer::create();
    ASSERT_TRUE(renderer) << renderer.error().message;
    renderer_.emplace(std::move(*renderer));
#endif
}

void Drawing::TearDown() {
    if (renderer_) {
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        for (const std::string& each : context_->take_complaints()) ADD_FAILURE() << "OpenGL: " << each;
    }
    renderer_.reset();
    if (context_ && counts_objects) {
        EXPECT_EQ(count_gl_objects(), objects_) << "what the renderer made is still there";
    }
    context_.reset();
}

ClothSurface Sheet::surface(const FabricLook& look) const {
    return {triangles, vertex_to_particle, texcoords, look};
}

ClothFrame Sheet::frame() const {
    return {positions, positions, normals};
}

Sheet make_sheet(std::uint32_t side, const Vec3& center, const Vec3& u, const Vec3& v) {
    const Vector3 along_u = to_vector(u), along_v = to_vector(v);
    const Vec4 normal = to_vec4(along_u.cross(along_v).normalized(), 0);
    Sheet sheet;
    for (std::uint32_t j = 0; j < side; ++j) {
        for (std::uint32_t i = 0; i < side; ++i) {
            const float a = static_cast<float>(i) / static_cast<float>(side - 1);
            const float b = static_cast<float>(j) / static_cast<float>(side - 1);
            sheet.positions.push_back(
                to_vec4(to_vector(center) + (a - 0.5f) * along_u + (b - 0.5f) * along_v, 1));
            sheet.normals.push_back(normal);
            sheet.texcoords.push_back({a * along_u.norm(), b * along_v.norm()});
            sheet.vertex_to_particle.push_back(j * side + i);
        }
    }
    for (std::uint32_t j = 0; j + 1 < side; ++j) {
        for (std::uint32_t i = 0; i + 1 < side; ++i) {
            const std::uint32_t corner = j * side + i;
            sheet.triangles.push_back({corner, corner + 1, corner + side + 1});
            sheet.triangles.push_back({corner, corner + side + 1, corner + side});
        }
    }
    return sheet;
}

ClothHandle show(SceneRenderer& renderer, const Sheet& sheet, const FabricLook& look) {
    const ClothHandle cloth = renderer.add_cloth(sheet.surface(look));
    renderer.update_cloth(cloth, sheet.frame());
    return cloth;
}

FabricLook signal_look() {
    FabricLook look;
    look.front = {0.6f, 0.01f, 0.01f};
    look.back = {0.01f, 0.4f, 0.01f};
    look.sheen = 0;
    look.thread_width = 0;
    look.translucency = 0;
    return look;
}

Pixel pixel(const Image& image, int x, int y) {
    const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x));
    return {image.rgb.at(at), image.rgb.at(at + 1), image.rgb.at(at + 2)};
}

int count_pixels(const Image& image, const std::function<bool(const Pixel&)>& condition) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) count += condition(pixel(image, x, y)) ? 1 : 0;
    return count;
}

PixelBox box_of(const Image& image, const std::function<bool(const Pixel&)>& condition) {
    PixelBox box{INT_MAX, INT_MAX, INT_MIN, INT_MIN};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!condition(pixel(image, x, y))) continue;
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x),
                   std::max(box.bottom, y)};
        }
    }
    return box;
}

PixelPoint project(const OrbitCamera& camera, const Vec3& point, int width, int height) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const Matrix4 view = camera.view(), projection = camera.projection(aspect);
    const Eigen::Vector4f clip =
        Matrix4f(projection.data()) * Matrix4f(view.data()) * to_vector(point).homogeneous();
    return {static_cast<int>((0.5f + 0.5f * clip.x() / clip.w()) * static_cast<float>(width)),
            static_cast<int>((0.5f - 0.5f * clip.y() / clip.w()) * static_cast<float>(height))};
}

Pixel pixel_at(const Image& image, const OrbitCamera& camera, const Vec3& point) {
    const PixelPoint at = project(camera, point, image.width, image.height);
    return pixel(image, at.x, at.y);
}

}  // namespace weft::render
