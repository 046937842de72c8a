// Pictures of every quality, and what is drawn of the inside of cloth.

#include "tests/render/drawing.h"

namespace weft::render::quality {
namespace {

constexpr int width = 160, height = 120;

View looking_at_a_sheet() {
    View view;
    view.camera = {.target = {0, 0.5f, 0}, .distance = 2, .yaw = 0, .pitch = 0};
    return view;
}

Sheet upright_sheet() {
    return make_sheet(20, {0, 0.5f, 0}, {0.8f, 0, 0}, {0, 0.8f, 0});
}

double difference(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int(a.rgb[i]) - int(b.rgb[i]));
    return sum / static_cast<double>(a.rgb.size());
}

using Qualities = Drawing;

TEST_F(Qualities, ShowTheSameSceneAlmost) {
    show(renderer(), upright_sheet(), signal_look());
    View view = looking_at_a_sheet();
    const Image best = renderer().capture(view, width, height);
    const Quality others[] = {
        {.samples = 1},
        {.samples = 2, .sun_map = 256, .sky_map = 64},
        {.samples = 1, .sun_map = 512, .blocker_taps = 0, .sun_taps = 1, .sky_taps = 0, .weave = false},
        {.resolution = 0.5f},
        {.samples = 1, .resolution = 0.25f}};
    for (const Quality& quality : others) {
        view.quality = quality;
        EXPECT_LT(difference(renderer().capture(view, width, height), best), 8);
    }
    view.quality = {};
    EXPECT_EQ(renderer().capture(view, width, height).rgb, best.rgb) << "and the best comes back";
}

TEST_F(Qualities, OutOfRangeCountAsTheNearest) {
    show(renderer(), upright_sheet(), signal_look());
    View view = looking_at_a_sheet();
    view.quality = {
        .samples = 1, .sun_map = 64, .blocker_taps = 0, .sun_taps = 1, .sky_taps = 0, .resolution = 0.25f};
    const Image least = renderer().capture(view, width, height);
    view.quality = {
        .samples = -3, .sun_map = 0, .blocker_taps = -1, .sun_taps = 0, .sky_taps = -9, .resolution = -1};
    EXPECT_EQ(renderer().capture(view, width, height).rgb, least.rgb);
}

TEST_F(Qualities, PartsTakeTime) {
    show(renderer(), upright_sheet(), signal_look());
    for (int i = 0; i < 12; ++i) {
        (void)renderer().capture(looking_at_a_sheet(), width, height);
        renderer().wait();
    }
    EXPECT_GT(renderer().draw_times().total(), 0);
    EXPECT_LT(renderer().draw_times().total(), 10'000);
}

using InsidePictures = Drawing;

TEST_F(InsidePictures, LinesAreDrawnAndHiddenByWhatIsBeforeThem) {
    show(renderer(), upright_sheet(), signal_look());
    View view = looking_at_a_sheet();
    const Image without = renderer().capture(view, width, height);
    const DrawnLine before[] = {{{-0.3f, 0.45f, 0.2f}, {0.3f, 0.55f, 0.2f}, {0, 0, 1}}};
    view.lines = before;
    EXPECT_GT(difference(renderer().capture(view, width, height), without), 0.05);
    const DrawnLine behind[] = {{{-0.3f, 0.45f, -0.2f}, {0.3f, 0.55f, -0.2f}, {0, 0, 1}}};
    view.lines = behind;
    EXPECT_EQ(renderer().capture(view, width, height).rgb, without.rgb);
    DrawnLine faint[] = {before[0], behind[0]};
    for (DrawnLine& line : faint) line.opacity = 0.3f;
    view.lines = std::span(faint).subspan(1);
    EXPECT_EQ(renderer().capture(view, width, height).rgb, without.rgb) << "and so are faint ones";
    view.lines = std::span(faint).first(1);
    const Image seen = renderer().capture(view, width, height);
    view.lines = faint;
    EXPECT_EQ(renderer().capture(view, width, height).rgb, seen.rgb);
    view.lines = before;
    EXPECT_LT(difference(seen, without), 0.6 * difference(renderer().capture(view, width, height), without));
}

TEST_F(InsidePictures, ColoursOfParticlesCoverTheFabric) {
    const Sheet sheet = upright_sheet();
    const ClothHandle cloth = show(renderer(), sheet, signal_look());
    const auto is_blue = [](const Pixel& p) { return p.blue > 2 * p.red && p.blue > 2 * p.green; };
    std::vector<Vec4> colours(sheet.positions.size(), Vec4{0, 0, 0.8f, 1});
    ClothFrame frame = sheet.frame();
    frame.colours = colours;
    renderer().update_cloth(cloth, frame);
    EXPECT_GT(count_pixels(renderer().capture(looking_at_a_sheet(), width, height), is_blue), 500);
    renderer().update_cloth(cloth, sheet.frame());
    EXPECT_EQ(count_pixels(renderer().capture(looking_at_a_sheet(), width, height), is_blue), 0);
}

TEST_F(InsidePictures, EveryKindOfThreadsIsDrawn) {
    for (const Threads threads : {Threads::plain, Threads::twill, Threads::knit, Threads::none}) {
        FabricLook look = signal_look();
        look.threads = threads;
        look.thread_width = 20;
        look.shine = 1;
        const ClothHandle cloth = show(renderer(), upright_sheet(), look);
        EXPECT_GT(count_pixels(renderer().capture(looking_at_a_sheet(), width, height),
                               [](const Pixel& p) { return p.is_red(); }),
                  300);
        renderer().remove_cloth(cloth);
    }
}

TEST(Camera, ARoomAtTheLeftHasTheTargetInItsMiddle) {
    OrbitCamera camera;
    camera.shift = 0.25f;
    camera.shrink = 0.8f;
    const PixelPoint place = project(camera, camera.target, 400, 300);
    EXPECT_NEAR(place.x, 150, 1);
    EXPECT_NEAR(place.y, 150, 1);
    const Ray ray = camera.ray(0.375f, 0.5f, 400.0f / 300);
    const Vec3 eye = camera.eye();
    const Vec3 to{camera.target.x - eye.x, camera.target.y - eye.y, camera.target.z - eye.z};
    const float along = to.x * ray.direction.x + to.y * ray.direction.y + to.z * ray.direction.z;
    EXPECT_NEAR(along, camera.distance, 1e-3f) << "through the target";
}

}  // namespace
}  // namespace weft::render::quality
