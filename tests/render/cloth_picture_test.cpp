// Pictures of cloth, asked for what they must show.
#include <array>
#include <cmath>
#include <memory>

#include "drawing.h"

namespace weft::render {
namespace {

constexpr int width = 320, height = 200;

bool is_red(const Pixel& p) {
    return p.is_red();
}
bool is_green(const Pixel& p) {
    return p.is_green();
}
bool is_cloth(const Pixel& p) {
    return p.is_red() || p.is_green();
}

View straight_on() {
    View view;
    view.camera = {.target = {0, 0, 0}, .distance = 3, .yaw = 0, .pitch = 0};
    view.sun_direction = {0.3f, 0.4f, 1};
    view.ground = false;
    return view;
}

/// In the plane z = 0, front towards +Z.
Sheet upright(const Vec3& center, float side) {
    return make_sheet(9, center, {side, 0, 0}, {0, side, 0});
}

using ClothPicture = Drawing;

TEST_F(ClothPicture, CounterClockwiseTrianglesShowTheirFront) {
    show(renderer(), upright({0, 0, 0}, 1), signal_look());
    View view = straight_on();
    const Image front = renderer().capture(view, width, height);
    EXPECT_GT(count_pixels(front, is_red), 3000);
    EXPECT_EQ(count_pixels(front, is_green), 0);

    view.camera.yaw = 3.14159265f;
    view.sun_direction = {0.3f, 0.4f, -1};
    const Image back = renderer().capture(view, width, height);
    EXPECT_EQ(count_pixels(back, is_red), 0);
    EXPECT_NEAR(count_pixels(back, is_green), count_pixels(front, is_red), 60);
}

TEST_F(ClothPicture, LiesWhereTheCameraProjectsIt) {
    const Sheet sheet = upright({0.7f, 0.35f, 0}, 0.4f);
    show(renderer(), sheet, signal_look());
    const View view = straight_on();
    const PixelBox box = box_of(renderer().capture(view, width, height), is_cloth);
    const PixelPoint low = project(view.camera, {0.5f, 0.15f, 0}, width, height);
    const PixelPoint high = project(view.camera, {0.9f, 0.55f, 0}, width, height);
    EXPECT_NEAR(box.left, low.x, 1);
    EXPECT_NEAR(box.bottom, low.y, 1);
    EXPECT_NEAR(box.right, high.x, 1);
    EXPECT_NEAR(box.top, high.y, 1);
}

TEST_F(ClothPicture, AlphaBlendsFromPreviousToCurrent) {
    const Sheet before = upright({-0.6f, 0, 0}, 0.5f), now = upright({0.6f, 0, 0}, 0.5f);
    const ClothHandle cloth = renderer().add_cloth(now.surface(signal_look()));
    renderer().update_cloth(cloth, {now.positions, before.positions, now.normals});
    View view = straight_on();
    for (const float alpha : {0.0f, 0.25f, 0.5f, 1.0f}) {
        view.alpha = alpha;
        const PixelBox box = box_of(renderer().capture(view, width, height), is_cloth);
        const PixelPoint center = project(view.camera, {-0.6f + 1.2f * alpha, 0, 0}, width, height);
        EXPECT_NEAR(0.5 * (box.left + box.right), center.x, 1.5) << "alpha " << alpha;
    }
}

TEST_F(ClothPicture, EdgesAreMultisampled) {
    Sheet slanted = make_sheet(2, {0, 0, 0}, {0.9f, 0.17f, 0}, {-0.17f, 0.9f, 0});
    show(renderer(), slanted, signal_look());
    const Image image = renderer().capture(straight_on(), width, height);
    const int inside = pixel(image, width / 2, height / 2).green,
              outside = pixel(image, 20, height / 2).green;
    const int mixed = count_pixels(image, [&](const Pixel& p) {
        const double share = (p.green - inside) / static_cast<double>(outside - inside);
        return share > 0.2 && share < 0.9 && p.red > p.green;
    });
    EXPECT_GT(mixed, 100) << "about one pixel in each row and column that the edge crosses";
}

TEST_F(ClothPicture, DrawsMoreParticlesThanABufferTextureMayHold) {
    const std::uint32_t side = 300;  // 90 000 particles; the upper edge holds the last ones
    show(renderer(), make_sheet(side, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), signal_look());
    const View view = straight_on();
    const PixelBox box = box_of(renderer().capture(view, width, height), is_red);
    EXPECT_NEAR(box.top, project(view.camera, {0, 0.5f, 0}, width, height).y, 1);
    EXPECT_NEAR(box.bottom, project(view.camera, {0, -0.5f, 0}, width, height).y, 1);
    EXPECT_NEAR(box.right, project(view.camera, {0.5f, 0, 0}, width, height).x, 1);
}

TEST_F(ClothPicture, VerticesOnOneParticleKeepTheirOwnTextureCoordinates) {
    // Two triangles share the diagonal's particles; only the upper left one lies in the stripe.
    Sheet sheet = make_sheet(2, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    sheet.vertex_to_particle = {0, 1, 3, 0, 3, 2};
    sheet.triangles = {{0, 1, 2}, {3, 4, 5}};
    sheet.texcoords = {{0.2f, 0}, {0.2f, 0}, {0.2f, 0}, {0.4f, 0}, {0.4f, 0}, {0.4f, 0}};
    FabricLook look = signal_look();
    look.stripe_width = 0.2f;
    look.stripe = {0.01f, 0.5f, 0.01f};
    show(renderer(), sheet, look);
    const View view = straight_on();
    const Image image = renderer().capture(view, width, height);
    const bool lower_striped = pixel_at(image, view.camera, {0.2f, -0.2f, 0}).is_green();
    const bool upper_striped = pixel_at(image, view.camera, {-0.2f, 0.2f, 0}).is_green();
    EXPECT_NE(lower_striped, upper_striped);
}

/// A look without light effects that depend on place.
FabricLook plain_white() {
    return {.front = {1, 1, 1}, .back = {1, 1, 1}, .roughness = 1, .sheen = 0, .threads = Threads::none};
}

TEST_F(ClothPicture, EachPartHasItsColourOrPicture) {
    // Left half: plain green. Right half: a picture of red over blue.
    Sheet sheet = make_sheet(3, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    sheet.texcoords.clear();
    for (const Vec4& p : sheet.positions) sheet.texcoords.push_back({p.x + 0.5f, p.y + 0.5f});
    const auto printed = std::make_shared<Image>();
    *printed = {1, 2, {255, 0, 0, 0, 0, 255}};
    const std::array<ClothPart, 2> parts{{{.front = {0.01f, 0.3f, 0.01f}, .back = {1, 1, 1}},
                                          {.front = {1, 1, 1}, .back = {1, 1, 1}, .picture = printed}}};
    std::vector<std::uint32_t> of_triangle;
    for (const auto& [a, b, c] : sheet.triangles)
        of_triangle.push_back(sheet.positions[a].x + sheet.positions[b].x + sheet.positions[c].x > 0 ? 1u
                                                                                                     : 0u);
    ClothSurface surface = sheet.surface(plain_white());
    surface.parts = parts;
    surface.part_of_triangle = of_triangle;
    renderer().update_cloth(renderer().add_cloth(surface), sheet.frame());
    const View view = straight_on();
    const Image image = renderer().capture(view, width, height);
    EXPECT_TRUE(pixel_at(image, view.camera, {-0.25f, 0.2f, 0}).is_green());
    EXPECT_TRUE(pixel_at(image, view.camera, {0.25f, 0.3f, 0}).is_red())
        << "the picture's first row is above";
    const Pixel below = pixel_at(image, view.camera, {0.25f, -0.3f, 0});
    EXPECT_GT(below.blue, 2 * below.red);
}

TEST_F(ClothPicture, AGhostLetsThroughWhatIsBehindAndHidesBehindClothInItsPlace) {
    FabricLook ghost = plain_white();
    ghost.front = ghost.back = {0.05f, 0.8f, 0.05f};
    ghost.opacity = 0.4f;
    const Sheet small = upright({0, 0, 0}, 0.6f), large = upright({0, 0, 0}, 1.2f);
    const View view = straight_on();
    const auto green_of = [&] {
        const Image image = renderer().capture(view, width, height);
        return std::pair(pixel_at(image, view.camera, {0.1f, 0.1f, 0}),
                         pixel_at(image, view.camera, {0.45f, 0.1f, 0}));
    };
    show(renderer(), small, signal_look());
    const auto [cloth, sky] = green_of();
    show(renderer(), large, ghost);
    const auto [same_place, beside] = green_of();
    EXPECT_EQ(same_place.light(), cloth.light()) << "no speckles where both are";
    EXPECT_GT(beside.green - beside.blue, sky.green - sky.blue + 20);
    EXPECT_GT(beside.blue, 40) << "the sky shows through";
}

TEST_F(ClothPicture, AFlatSheetNeverShadowsItself) {
    FabricLook look = signal_look();
    look.roughness = 1;
    show(renderer(), make_sheet(40, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), look);
    View view = straight_on();
    view.camera.distance = 2;
    for (int degrees = -80; degrees <= 80; degrees += 10) {
        const float angle = static_cast<float>(degrees) * 3.14159265f / 180;
        view.sun_direction = {std::sin(angle), 0.1f, std::cos(angle)};
        const Image image = renderer().capture(view, width, height);
        int darkest = 255, brightest = 0;
        for (const float x : {-0.4f, -0.21f, -0.03f, 0.12f, 0.37f}) {
            for (const float y : {-0.39f, -0.17f, 0.02f, 0.14f, 0.33f}) {
                const int red = pixel_at(image, view.camera, {x, y, 0}).red;
                darkest = std::min(darkest, red);
                brightest = std::max(brightest, red);
            }
        }
        EXPECT_LE(brightest - darkest, 14) << "sun at " << degrees << " degrees from the normal";
    }
}

TEST_F(ClothPicture, TheSunShinesThroughThinCloth) {
    FabricLook look = signal_look();
    const ClothHandle cloth = show(renderer(), upright({0, 0, 0}, 1), look);
    View view = straight_on();
    view.sun_direction = {0.2f, 0.3f, -1};  // from behind
    const int opaque = pixel(renderer().capture(view, width, height), width / 2, height / 2).light();
    look.translucency = 0.5f;
    renderer().set_look(cloth, look);
    EXPECT_GT(pixel(renderer().capture(view, width, height), width / 2, height / 2).light(), opaque + 10);
}

TEST_F(ClothPicture, ThreadsShowFromNearAndFadeFromAfar) {
    FabricLook look = signal_look();
    const ClothHandle cloth = show(renderer(), upright({0, 0, 0}, 1), look);
    const auto difference = [&](float distance) {
        View view = straight_on();
        view.camera.distance = distance;
        look.thread_width = 0;
        renderer().set_look(cloth, look);
        const Image plain = renderer().capture(view, width, height);
        look.thread_width = 4.5f;
        renderer().set_look(cloth, look);
        const Image woven = renderer().capture(view, width, height);
        return std::abs(pixel(plain, width / 2 + 3, height / 2 + 5).red -
                        pixel(woven, width / 2 + 3, height / 2 + 5).red);
    };
    EXPECT_LE(difference(4), 1);
    EXPECT_GT(difference(0.1f) + difference(0.11f) + difference(0.12f), 6);
}

TEST_F(ClothPicture, WireframeDrawsLinesOnTheClothOnly) {
    show(renderer(), upright({0, 0, 0}, 1), signal_look());
    View view = straight_on();
    const Image plain = renderer().capture(view, width, height);
    view.wireframe = true;
    const Image lined = renderer().capture(view, width, height);
    int darker = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            darker += pixel(lined, x, y).light() + 20 < pixel(plain, x, y).light() ? 1 : 0;
    EXPECT_GT(darker, 300);
    EXPECT_LT(darker, count_pixels(plain, is_red) + 300);
    EXPECT_EQ(pixel(lined, 10, 10).light(), pixel(plain, 10, 10).light());
}

TEST_F(ClothPicture, ARemovedClothIsGoneAndItsHandleIsIgnored) {
    const Sheet sheet = upright({0, 0, 0}, 1);
    const View view = straight_on();
    const Image empty = renderer().capture(view, width, height);
    const ClothHandle gone = show(renderer(), sheet, signal_look());
    EXPECT_GT(count_pixels(renderer().capture(view, width, height), is_red), 0);
    renderer().remove_cloth(gone);
    renderer().remove_cloth(gone);
    renderer().update_cloth(gone, sheet.frame());
    renderer().set_look(gone, signal_look());
    EXPECT_EQ(renderer().capture(view, width, height).rgb, empty.rgb);
    EXPECT_NE(show(renderer(), sheet, signal_look()), gone);
}

TEST_F(ClothPicture, AClothWithoutPositionsYetDrawsNothing) {
    const Sheet sheet = upright({0, 0, 0}, 1);
    const ClothHandle cloth = renderer().add_cloth(sheet.surface(signal_look()));
    EXPECT_NE(cloth, 0u);
    EXPECT_EQ(count_pixels(renderer().capture(straight_on(), width, height), is_cloth), 0);
}

}  // namespace
}  // namespace weft::render
