// Pictures as somebody found them good, stored as PNG files, against those that are drawn now. After a change
// that was meant to show, look at them anew:
//
//     WEFT_STORE_PICTURES=1 build/release/bin/weft_render_tests --gtest_filter='StoredPictures.*'

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "tests/render/drawing.h"
#include "tests/render/stored/perceptual.h"

namespace weft::render {
namespace {

constexpr int factor = 2, drawn_width = factor * 160, drawn_height = factor * 100;

/// A cloth that hangs in folds along z, of that width and height [m], its lower edge at `lower`.
Sheet folds(const Vec3& lower, float across, float high, float deep) {
    Sheet sheet = make_sheet(48, {lower.x, lower.y + 0.5f * high, lower.z}, {across, 0, 0}, {0, high, 0});
    for (std::size_t i = 0; i < sheet.positions.size(); ++i) {
        const float phase = 36 * sheet.texcoords[i].x / across;
        sheet.positions[i].z += deep * std::sin(phase);
        const float slope = deep * 36 / across * std::cos(phase), length = std::hypot(1.0f, slope);
        sheet.normals[i] = {-slope / length, 0, 1 / length, 0};
    }
    return sheet;
}

class StoredPictures : public Drawing {
  protected:
    /// A curtain in folds, one that the sun shines through, a ball that throws its shadow on a sheet, a box.
    void set_stage(const FabricLook& change) {
        FabricLook look = change;
        look.front = {0.08f, 0.22f, 0.5f};
        look.back = {0.1f, 0.2f, 0.4f};
        look.stripe_width = 0.11f;
        cloths_.push_back(show(renderer(), folds({-0.55f, 0.15f, 0}, 0.9f, 1.0f, 0.035f), look));
        look.stripe_width = 0;
        look.front = look.back = {0.5f, 0.3f, 0.05f};
        Sheet behind = folds({0.45f, 0.3f, -0.5f}, 0.7f, 0.8f, 0.02f);
        for (Vec4& normal : behind.normals) normal = {-normal.x, -normal.y, -normal.z, 0};
        for (auto& triangle : behind.triangles) std::swap(triangle[1], triangle[2]);
        cloths_.push_back(show(renderer(), behind, look));
        look.front = {0.45f, 0.06f, 0.06f};
        cloths_.push_back(
            show(renderer(), make_sheet(24, {0.55f, 0.08f, 0.35f}, {0.7f, 0, 0}, {0, 0.05f, -0.6f}), look));
        view_.spheres = spheres_;
        view_.boxes = boxes_;
        view_.camera = {.target = {0, 0.5f, 0}, .distance = 2.6f, .yaw = 0.2f, .pitch = 0.22f};
        view_.sun_direction = {-0.5f, 0.7f, -0.35f};
    }
    /// Threads of four kinds, as large as laths.
    void show_weaves(bool woven = true) {
        int place = 0;
        for (const Threads threads : {Threads::plain, Threads::twill, Threads::knit, Threads::none}) {
            FabricLook look;
            look.threads = threads;
            look.thread_width = woven ? 28 : 0;
            look.shine = threads == Threads::plain ? 0.8f : 0;
            look.roughness = threads == Threads::none ? 0.3f : 0.7f;
            const float x = 0.5f * (static_cast<float>(place % 2) - 0.5f),
                        y = 0.5f * (static_cast<float>(place / 2) - 0.5f);
            show(renderer(), make_sheet(9, {1.6f * x, y, 0}, {0.76f, 0, 0}, {0, 0.47f, 0.1f}), look);
            ++place;
        }
        view_.camera = {.target = {0, 0, 0}, .distance = 1.5f, .yaw = 0, .pitch = 0};
        view_.sun_direction = {-0.6f, 0.5f, 0.6f};
        view_.ground = false;
    }
    /// Cloth with a colour for each particle, its triangles' lines, and lines of two strengths.
    void show_inside() {
        const Sheet sheet = folds({0, 0.2f, 0}, 1.2f, 0.8f, 0.04f);
        std::vector<Vec4> colours;
        for (const Vec2& t : sheet.texcoords) colours.push_back({t.x / 1.2f, 0.1f, 1 - t.x / 1.2f, 0.8f});
        const ClothHandle cloth = show(renderer(), sheet, FabricLook());
        ClothFrame frame = sheet.frame();
        frame.colours = colours;
        renderer().update_cloth(cloth, frame);
        for (int k = 0; k < 24; ++k) {
            const float x = 0.05f * static_cast<float>(k) - 0.6f;
            lines_.push_back({{x, 0.3f, 0.3f}, {x, 0.55f, 0.3f}, {1, 1, 1}});
            lines_.push_back({{x, 0.65f, 0.3f}, {x, 0.9f, 0.3f}, {1, 1, 1}, 0.4f});
            lines_.push_back({{x, 0.3f, -0.3f}, {x, 0.9f, -0.3f}, {0, 1, 0}});  // hidden
        }
        view_.lines = lines_;
        view_.wireframe = true;
        view_.camera = {.target = {0, 0.6f, 0}, .distance = 1.9f, .yaw = 0.1f, .pitch = 0.1f};
    }

    Image draw() { return smaller(renderer().capture(view_, drawn_width, drawn_height), factor); }
    PerceptualDifference from_stored(const char* name) {
        const Image now = draw();
        const std::string file = std::string(WEFT_STORED_PICTURES) + "/" + name + ".png";
        if (std::getenv("WEFT_STORE_PICTURES") != nullptr) {
            EXPECT_TRUE(save_png(now, file.c_str()));
            return {};
        }
        const Image stored = load_png(file);
        if (stored.width != now.width || stored.height != now.height) {
            ADD_FAILURE() << file << " is not there";
            return {};
        }
        const PerceptualDifference difference = perceptual_difference(now, stored);
        const auto seen = std::filesystem::path(testing::TempDir()) / (std::string("weft_") + name + ".png");
        if (difference.is_noticed()) (void)save_png(now, seen.c_str());
        return difference;
    }
    void expect_as_stored(const char* name) {
        const PerceptualDifference difference = from_stored(name);
        EXPECT_FALSE(difference.is_noticed()) << name << ": " << difference.words() << "; it is in "
                                              << testing::TempDir() << "weft_" << name << ".png";
    }
    void expect_noticed(const char* name, const char* what) {
        if (std::getenv("WEFT_STORE_PICTURES") != nullptr) return;
        const PerceptualDifference difference = from_stored(name);
        EXPECT_TRUE(difference.is_noticed()) << what << ": " << difference.words();
    }

    View view_;
    std::vector<ClothHandle> cloths_;
    std::vector<DrawnLine> lines_;
    std::vector<DrawnSphere> spheres_{{{0.5f, 0.3f, 0.3f}, 0.12f}};
    std::vector<DrawnBox> boxes_{{{-0.75f, 0.1f, 0.4f}, {0.12f, 0, 0}, {0, 0.1f, 0}, {0, 0, 0.12f}}};
};

TEST_F(StoredPictures, OfFolds) {
    set_stage({});
    expect_as_stored("folds");
    // Differences that the measure notices.
    const View good = view_;
    view_.sun_direction.x = -view_.sun_direction.x;
    expect_noticed("folds", "the sun from the other side");
    view_ = good;
    view_.quality.sky_taps = 0;
    expect_noticed("folds", "no dark folds");
    view_ = good;
    view_.spheres = {};
    expect_noticed("folds", "no ball");
    view_ = good;
    FabricLook opaque;
    opaque.front = opaque.back = {0.5f, 0.3f, 0.05f};
    opaque.translucency = 0;
    renderer().set_look(cloths_[1], opaque);
    expect_noticed("folds", "no light through cloth");
    renderer().remove_cloth(cloths_[1]);
    expect_noticed("folds", "a cloth less");
}

TEST_F(StoredPictures, OfWeaves) {
    show_weaves();
    expect_as_stored("weaves");
    view_.quality.weave = false;
    expect_noticed("weaves", "no threads");
}

TEST_F(StoredPictures, OfTheInside) {
    show_inside();
    expect_as_stored("inside");
    view_.wireframe = false;
    expect_noticed("inside", "no triangles");
    view_.wireframe = true;
    for (DrawnLine& line : lines_) line.opacity = 1;
    expect_noticed("inside", "faint lines as strong ones");
}

// As another driver would draw it: other samples, other noise.
TEST_F(StoredPictures, AreTheSameByOtherSamples) {
    set_stage({});
    view_.quality.samples = 2;
    view_.quality.sun_taps = 24;
    view_.quality.sky_taps = 16;
    view_.quality.sun_map = 1536;
    if (std::getenv("WEFT_STORE_PICTURES") == nullptr) expect_as_stored("folds");
}

TEST(Perceptual, SeesWhatEyesSee) {
    Image grey{32, 32, std::vector<std::uint8_t>(3 * 32 * 32, 120)}, noisy = grey, striped = grey,
                                                                     tinted = grey;
    for (std::size_t i = 0; i < grey.rgb.size(); ++i) {
        noisy.rgb[i] = static_cast<std::uint8_t>(120 + static_cast<int>(i * 7919 % 5) - 2);
        striped.rgb[i] = i / 3 % 2 == 0 ? 105 : 135;
        if (i % 3 == 0) tinted.rgb[i] = 135;
    }
    EXPECT_EQ(perceptual_difference(grey, grey).colour, 0);
    EXPECT_FALSE(perceptual_difference(grey, noisy).is_noticed());
    EXPECT_GT(perceptual_difference(grey, striped).texture, 2);
    EXPECT_GT(perceptual_difference(grey, tinted).colour, 3);
    EXPECT_EQ(smaller(grey, 4).rgb, std::vector<std::uint8_t>(3 * 8 * 8, 120));
}

}  // namespace
}  // namespace weft::render
