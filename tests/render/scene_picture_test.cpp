// Pictures of what is not cloth: ground, shadows, spheres and capsules, the wind's arrow.
#include <glad/gl.h>

#include <array>
#include <cmath>

#include "drawing.h"

namespace weft::render {
namespace {

constexpr int scene_width = 320, scene_height = 200;

View from_above() {
    View view;
    view.camera = {.target = {0, 0, 0}, .distance = 5, .yaw = 0, .pitch = 0.9f};
    view.sun_direction = {1, 1, 0};
    return view;
}

using ScenePicture = Drawing;

TEST_F(ScenePicture, ASphereDarkensTheGroundAwayFromTheSun) {
    const DrawnSphere sphere{{0, 1, 0}, 0.3f};
    View view = from_above();
    const Image bare = renderer().capture(view, scene_width, scene_height);
    view.spheres = {&sphere, 1};
    const Image shaded = renderer().capture(view, scene_width, scene_height);
    const Vec3 in_shadow{-1.04f, 0, 0.06f}, mirrored{1.04f, 0, 0.06f};
    EXPECT_LT(pixel_at(shaded, view.camera, in_shadow).light(),
              0.75 * pixel_at(bare, view.camera, in_shadow).light());
    EXPECT_NEAR(pixel_at(shaded, view.camera, mirrored).light(),
                pixel_at(bare, view.camera, mirrored).light(), 6);
}

TEST_F(ScenePicture, AShadowIsSofterTheFartherItsCaster) {
    // Width of the edge: from a quarter to three quarters of the way from dark to light, along the ground.
    const auto edge_width = [&](float sphere_height) {
        const DrawnSphere sphere{{0, sphere_height, 0}, 0.4f};
        View view = from_above();
        view.sun_direction = {0, 1, 0};
        view.camera.pitch = 0.3f;
        view.camera.distance = 4;
        view.spheres = {&sphere, 1};
        const Image image = renderer().capture(view, 1280, 800);
        std::vector<int> along;
        for (float z = 0.0f; z < 0.9f; z += 0.01f)
            along.push_back(pixel_at(image, view.camera, {0.53f * z, 0, 0.85f * z}).light());
        const auto [dark, bright] = std::minmax_element(along.begin(), along.end());
        const int low = *dark + (*bright - *dark) / 4, high = *dark + (*bright - *dark) * 3 / 4;
        return std::count_if(along.begin(), along.end(),
                             [&](int light) { return light > low && light < high; });
    };
    EXPECT_GT(edge_width(3.0f), edge_width(0.9f) + 2);
}

// A search that looked past what was small took some pixels for the whole shadow.
TEST_F(ScenePicture, TheShadowOfWhatIsSmallAndHighUpHasNoSpecks) {
    View view = from_above();
    view.camera = {.target = {-1.2f, 0, 0}, .distance = 1.5f, .yaw = 0.6f, .pitch = 0.7f};
    const std::array spheres{DrawnSphere{{3, 0.5f, -3}, 0.5f}, DrawnSphere{{0, 1.2f, 0}, 0.05f}};
    view.spheres = {spheres.data(), 1};
    const Image without = renderer().capture(view, 2 * scene_width, 2 * scene_height);
    view.spheres = spheres;
    const Image image = renderer().capture(view, 2 * scene_width, 2 * scene_height);
    int darkened = 0, most = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const int by = pixel(without, x, y).light() - pixel(image, x, y).light();
            darkened += by > 5 ? 1 : 0;
            most = std::max(most, by);
        }
    EXPECT_GT(darkened, 1000);
    EXPECT_LT(most, 60) << "most of the sun is beside the ball";
}

// The map of the sun's depth reaches no farther than what casts a shadow, but the shadow's edge does.
TEST_F(ScenePicture, TheShadowOfWhatIsSmallAndHighUpIsAsWideAsTheSunIsSoft) {
    View view = from_above();
    view.sun_direction = {0, 1, 0};
    view.camera.distance = 2;
    const Image bare = renderer().capture(view, scene_width, scene_height);
    const DrawnSphere ball{{0, 2, 0}, 0.05f};
    view.spheres = {&ball, 1};
    const Image shaded = renderer().capture(view, scene_width, scene_height);
    const auto darkened = [&](float x, float z) {
        const Vec3 at{x, 0, z};
        return pixel_at(bare, view.camera, at).light() - pixel_at(shaded, view.camera, at).light();
    };
    const int inside = darkened(0.05f, 0.05f);
    EXPECT_GT(inside, 6);
    EXPECT_GT(darkened(0.14f, 0), inside / 2);
    EXPECT_GT(darkened(0, -0.14f), inside / 2);
    EXPECT_LT(darkened(0.3f, 0), 3);
}

TEST_F(ScenePicture, ANarrowShadowEdgeHasNoStairs) {
    View view = from_above();
    view.sun_direction = {0.3f, 1, 0.1f};
    const Vec3 slanted{0.5f, 0, 0.31f}, across{-0.31f, 0, 0.5f};
    show(renderer(), make_sheet(9, {0, 0.04f, 0}, slanted, across), signal_look());
    const Image image = renderer().capture(view, 2 * scene_width, 2 * scene_height);
    // Pixels are shaded by twos and twos. At an edge four of one colour are a stair.
    int edges = 0, stairs = 0;
    for (int y = 2; y + 4 < image.height; y += 2)
        for (int x = 2; x + 4 < image.width; x += 2) {
            const auto light = [&](int dx, int dy) { return pixel(image, x + dx, y + dy).light(); };
            const bool ground = !pixel(image, x, y).is_red() && !pixel(image, x - 2, y).is_red();
            const auto [dark, bright] = std::minmax({light(-2, 0), light(2, 0)});
            const int quarter = (bright - dark) / 4;
            const bool between = light(0, 0) > dark + quarter && light(0, 0) < bright - quarter;
            if (!ground || quarter < 15 || !between) continue;
            ++edges;
            const auto [least, most] = std::minmax({light(0, 0), light(1, 0), light(0, 1), light(1, 1)});
            stairs += most - least < 4 ? 1 : 0;
        }
    EXPECT_GT(edges, 20);
    EXPECT_LT(stairs, edges / 3);
}

TEST_F(ScenePicture, TheGroundIsDarkerCloseUnderABodyEvenInTheSun) {
    const DrawnSphere sphere{{0, 0.34f, 0}, 0.3f};
    View view = from_above();
    view.sun_direction = {1, 0.25f, 0};  // its shadow falls far to the left
    view.camera.pitch = 0.1f;
    view.camera.distance = 2;
    const Image bare = renderer().capture(view, scene_width, scene_height);
    view.spheres = {&sphere, 1};
    const Image image = renderer().capture(view, scene_width, scene_height);
    const Vec3 beneath{0.12f, 0, 0.1f};
    EXPECT_LT(pixel_at(image, view.camera, beneath).light() + 15,
              pixel_at(bare, view.camera, beneath).light());
}

TEST_F(ScenePicture, ABodyHighAboveTheGroundDarkensItNowhereButInItsShadow) {
    const DrawnSphere sphere{{0, 2, 0}, 0.2f};
    View view = from_above();
    view.sun_direction = {0, 1, 1};  // its shadow lies about z = -2
    const Image bare = renderer().capture(view, scene_width, scene_height);
    view.spheres = {&sphere, 1};
    const Image image = renderer().capture(view, scene_width, scene_height);
    for (const float x : {-1.5f, -0.8f, -0.15f, 0.15f, 0.9f, 1.6f})
        for (const float z : {-0.15f, 0.15f, 0.6f})
            EXPECT_NEAR(pixel_at(image, view.camera, {x, 0, z}).light(),
                        pixel_at(bare, view.camera, {x, 0, z}).light(), 4)
                << x << ", " << z;
}

TEST_F(ScenePicture, SpheresAndCapsulesFillTheirOutline) {
    const DrawnSphere sphere{{-0.8f, 0, 0}, 0.3f, {0.6f, 0.01f, 0.01f}};
    const DrawnCapsule capsule{{0.8f, -0.4f, 0}, {0.8f, 0.4f, 0}, 0.2f, {0.01f, 0.4f, 0.01f}};
    View view;
    view.camera = {.target = {0, 0, 0}, .distance = 8, .yaw = 0, .pitch = 0, .vertical_fov = 0.3f};
    view.ground = false;
    view.sun_direction = {0, 0.3f, 1};
    view.spheres = {&sphere, 1};
    view.capsules = {&capsule, 1};
    const Image image = renderer().capture(view, scene_width, scene_height);
    const float per_metre = 0.5f * scene_height / (8 * std::tan(0.15f));

    const PixelBox red = box_of(image, [](const Pixel& p) { return p.is_red(); });
    EXPECT_NEAR(red.right - red.left, 0.6f * per_metre, 4);
    EXPECT_NEAR(red.bottom - red.top, 0.6f * per_metre, 4);
    EXPECT_NEAR(0.5f * static_cast<float>(red.left + red.right), 0.5f * scene_width - 0.8f * per_metre, 2);
    const PixelBox green = box_of(image, [](const Pixel& p) { return p.is_green(); });
    EXPECT_NEAR(green.right - green.left, 0.4f * per_metre, 4);
    EXPECT_NEAR(green.bottom - green.top, 1.2f * per_metre, 4);
}

TEST_F(ScenePicture, BoxesAndTaperedCapsulesFillTheirOutline) {
    const float s = std::sqrt(0.5f);  // turned by 45 degrees about z, half extents 0.4, 0.2, 0.1
    const DrawnBox box{
        {-0.8f, 0, 0}, {0.4f * s, 0.4f * s, 0}, {-0.2f * s, 0.2f * s, 0}, {0, 0, 0.1f}, {0.6f, 0.01f, 0.01f}};
    const DrawnTaperedCapsule capsule{{0.8f, -0.4f, 0}, {0.8f, 0.4f, 0}, 0.3f, 0.1f, {0.01f, 0.4f, 0.01f}};
    View view;
    view.camera = {.target = {0, 0, 0}, .distance = 8, .yaw = 0, .pitch = 0, .vertical_fov = 0.3f};
    view.ground = false;
    view.sun_direction = {0, 0.3f, 1};
    view.boxes = {&box, 1};
    view.tapered_capsules = {&capsule, 1};
    const Image image = renderer().capture(view, scene_width, scene_height);
    const float per_metre = 0.5f * scene_height / (8 * std::tan(0.15f));

    const PixelBox red = box_of(image, [](const Pixel& p) { return p.is_red(); });
    EXPECT_NEAR(red.right - red.left, 1.2f * s * per_metre, 5);
    EXPECT_NEAR(red.bottom - red.top, 1.2f * s * per_metre, 5);
    EXPECT_NEAR(0.5f * static_cast<float>(red.left + red.right), 0.5f * scene_width - 0.8f * per_metre, 3);
    const PixelBox green = box_of(image, [](const Pixel& p) { return p.is_green(); });
    EXPECT_NEAR(green.right - green.left, 0.6f * per_metre, 4);
    EXPECT_NEAR(green.bottom - green.top, 1.2f * per_metre, 4);
    // The upper half is as wide as the cone there, and the box has a corner and not an edge at its top.
    const auto at = [&](float x, float y) {
        return pixel(image, static_cast<int>(0.5f * scene_width + x * per_metre),
                     static_cast<int>(0.5f * scene_height - y * per_metre));
    };
    EXPECT_TRUE(at(0.8f + 0.18f, 0).is_green());
    EXPECT_FALSE(at(0.8f + 0.18f, 0.3f).is_green());
    EXPECT_TRUE(at(-0.8f + 0.1f, 0.1f).is_red());
    EXPECT_FALSE(at(-0.8f - 0.3f, 0.3f).is_red());
}

TEST_F(ScenePicture, TheSkyIsAboveAndTheGroundBelowTheHorizon) {
    View view;
    view.camera.pitch = 0.2f;
    const Image image = renderer().capture(view, scene_width, scene_height);
    EXPECT_GT(pixel(image, scene_width / 2, 3).blue, pixel(image, scene_width / 2, 3).red + 10);
    view.ground = false;
    const Image no_ground = renderer().capture(view, scene_width, scene_height);
    EXPECT_EQ(pixel(image, scene_width / 2, 3).light(), pixel(no_ground, scene_width / 2, 3).light());
    EXPECT_NE(pixel(image, scene_width / 2, scene_height - 5).light(),
              pixel(no_ground, scene_width / 2, scene_height - 5).light());
}

TEST_F(ScenePicture, TheWindArrowLiesUpwindAndGrowsWithTheSpeed) {
    const DrawnSphere sphere{{0, 0.3f, 0}, 0.3f};
    View view = from_above();
    view.spheres = {&sphere, 1};
    const Image calm = renderer().capture(view, scene_width, scene_height);
    const auto changed = [&](const Vec3& wind) {
        view.wind = wind;
        const Image image = renderer().capture(view, scene_width, scene_height);
        int count = 0;
        double sum_x = 0;
        for (int y = 0; y < scene_height; ++y) {
            for (int x = 0; x < scene_width; ++x) {
                if (std::abs(pixel(image, x, y).light() - pixel(calm, x, y).light()) < 20) continue;
                ++count;
                sum_x += x;
            }
        }
        return std::pair(count, count > 0 ? sum_x / count : 0.0);
    };
    EXPECT_GT(changed({-3, 0, 0}).second, scene_width / 2 + 20);
    EXPECT_LT(changed({3, 0, 0}).second, scene_width / 2 - 20);
    EXPECT_GT(changed({12, 0, 0}).first, changed({2, 0, 0}).first);
    EXPECT_EQ(changed({0, 5, 0}).first, 0) << "a vertical wind has no direction on the ground";
}

TEST_F(ScenePicture, TheSameViewGivesTheSameBytesWhateverStateTheHostLeaves) {
    const DrawnSphere sphere{{0, 0.5f, 0}, 0.5f};
    View view = from_above();
    view.spheres = {&sphere, 1};
    const Image first = renderer().capture(view, scene_width, scene_height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 10, 10);
    glEnable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glFrontFace(GL_CW);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_NEVER);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    EXPECT_EQ(renderer().capture(view, scene_width, scene_height).rgb, first.rgb);
}

TEST_F(ScenePicture, ASizeOfZeroDrawsNothing) {
    renderer().draw(View{}, 0, 200);
    renderer().draw(View{}, 320, 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(ScenePicture, ASunWithoutDirectionStandsOverhead) {
    View view = from_above();
    view.sun_direction = {0, 1, 0};
    const Image overhead = renderer().capture(view, scene_width, scene_height);
    view.sun_direction = {0, 0, 0};
    EXPECT_EQ(renderer().capture(view, scene_width, scene_height).rgb, overhead.rgb);
}

}  // namespace
}  // namespace weft::render
