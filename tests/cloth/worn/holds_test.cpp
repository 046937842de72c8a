// Cloth whose pins, bodies or skin have gone elsewhere without it: it is there at once, in its shape.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::holds {
namespace {

constexpr std::uint32_t side_of_square = 9;

Vec3 moved(const Transform& by, const Vec4& x) {
    const auto& r = by.rotation;
    const Vec3 q{r.x, r.y, r.z};
    const auto cross = [](const Vec3& a, const Vec3& b) {
        return Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    const Vec3 c = cross(q, {x.x, x.y, x.z}), d = cross(q, c), &t = by.translation;
    return {x.x + 2 * (r.w * c.x + d.x) + t.x, x.y + 2 * (r.w * c.y + d.y) + t.y,
            x.z + 2 * (r.w * c.z + d.z) + t.z};
}

float distance(const Vec3& a, const Vec4& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

struct Hung {
    explicit Hung(const ClothSettings& settings = {}) : world(World::create({.threads = 1}).value()) {
        id =
            world.add_cloth(make_sheet({.rows = side_of_square, .columns = side_of_square}).value(), settings)
                .value();
    }
    void pin(const std::vector<std::uint32_t>& vertices) {
        pins = vertices;
        ASSERT_TRUE(world.pin(id, vertices));
    }
    void move_pins(const Transform& by) {
        std::vector<Vec3> targets;
        for (const std::uint32_t v : pins) targets.push_back(moved(by, world.cloth(id)->positions[v]));
        ASSERT_TRUE(world.move_pins(id, pins, targets));
    }
    [[nodiscard]] std::vector<Vec4> positions() const {
        const auto view = world.cloth(id)->positions;
        return {view.begin(), view.end()};
    }
    [[nodiscard]] float worst_strain() const {
        std::vector<StrainedEdge> edges(1);
        return world.strained_edges(id, 0.02f, edges).value() > 0 ? edges[0].strain : 0.0f;
    }

    World world;
    ClothId id;
    std::vector<std::uint32_t> pins;
};

const Transform far_off{{3, 0.5f, -2}, {}};
const Transform turned{{3, 0.5f, -2},
                       {0, std::numbers::sqrt2_v<float> / 2, 0, std::numbers::sqrt2_v<float> / 2}};
const Transform half_turned{{3, 0.5f, -2}, {0, 1, 0, 0}};

// Of pins: one, two, an edge, and some that are on no line.
TEST(Holds, ClothOffGoesWithItsPinsAsAWhole) {
    const std::vector<std::vector<std::uint32_t>> cases{
        {4}, {0, side_of_square - 1}, {0, 2, 4, 6, 8}, {0, 8, 76}};
    for (const auto& pins : cases) {
        for (const Transform& by : {far_off, turned, half_turned}) {
            Hung hung;
            hung.pin(pins);
            for (int k = 0; k < 90; ++k) hung.world.step(h);
            const auto before = hung.positions();
            const float strain = hung.worst_strain();
            ASSERT_TRUE(hung.world.set_enabled(hung.id, false));
            hung.move_pins(by);
            ASSERT_TRUE(hung.world.set_enabled(hung.id, true));
            const auto there = hung.positions();
            for (std::size_t v = 0; v < before.size() && pins.size() > 1; ++v)
                EXPECT_LT(distance(moved(by, before[v]), there[v]), 0.03f) << v << " of " << pins.size();
            for (const std::uint32_t v : pins)
                EXPECT_LT(distance(moved(by, before[v]), there[v]), 1e-5f) << "a pin is at its target";
            for (int k = 0; k < 20; ++k) {
                const StepReport& report = hung.world.step(h);
                EXPECT_FALSE(has(report.flags, StepFlags::speed_limited));
                EXPECT_LT(report.peak_speed, 2) << "as of cloth that is let go";
                EXPECT_LT(hung.worst_strain(), 1.5f * strain + 0.05f);
            }
        }
    }
}

TEST(Holds, SettingsThatSwitchClothOnDoTheSame) {
    Hung hung;
    hung.pin({0, side_of_square - 1});
    for (int k = 0; k < 30; ++k) hung.world.step(h);
    ClothSettings settings = hung.world.cloth_settings(hung.id).value();
    settings.enabled = false;
    ASSERT_TRUE(hung.world.set_cloth_settings(hung.id, settings));
    hung.move_pins(turned);
    settings.enabled = true;
    ASSERT_TRUE(hung.world.set_cloth_settings(hung.id, settings));
    hung.world.step(h);
    EXPECT_LT(hung.world.report().peak_speed, 2);
}

TEST(Holds, ClothWhosePinsStayedIsWhereItWasLeft) {
    Hung hung;
    hung.pin({0, side_of_square - 1});
    for (int k = 0; k < 30; ++k) hung.world.step(h);
    ASSERT_TRUE(hung.world.set_enabled(hung.id, false));
    const auto before = hung.positions();
    ASSERT_TRUE(hung.world.set_enabled(hung.id, true));
    const auto after = hung.positions();
    for (std::size_t v = 0; v < before.size(); ++v)
        EXPECT_EQ(distance({before[v].x, before[v].y, before[v].z}, after[v]), 0);
}

TEST(Holds, TheFirstSkinBringsClothThere) {
    for (const bool pinned : {false, true}) {
        Hung hung;
        if (pinned) hung.pin({0, side_of_square - 1});
        ASSERT_TRUE(hung.world.set_map(hung.id, Map::leash,
                                       std::vector<float>(side_of_square * side_of_square, 0.1f)));
        std::vector<Vec3> places;
        for (const Vec4& x : hung.positions()) places.push_back(moved(turned, x));
        ASSERT_TRUE(hung.world.set_skin(hung.id, places, {}));
        for (std::size_t v = 0; v < places.size(); ++v)
            EXPECT_LT(distance(places[v], hung.positions()[v]), 1e-5f);
        for (int k = 0; k < 20; ++k) EXPECT_LT(hung.world.step(h).peak_speed, 3) << pinned;
    }
}

TEST(Holds, ClothWithinItsLeashesStaysAtTheFirstSkin) {
    Hung hung;
    ASSERT_TRUE(
        hung.world.set_map(hung.id, Map::leash, std::vector<float>(side_of_square * side_of_square, 0.5f)));
    std::vector<Vec3> places;
    const auto before = hung.positions();
    for (const Vec4& x : before) places.push_back({x.x + 0.3f, x.y, x.z});
    ASSERT_TRUE(hung.world.set_skin(hung.id, places, {}));
    for (std::size_t v = 0; v < before.size(); ++v) EXPECT_EQ(before[v].x, hung.positions()[v].x);
}

TEST(Holds, AShapeThatHasChangedEndsWithinItsLeashes) {
    Hung hung;
    ASSERT_TRUE(
        hung.world.set_map(hung.id, Map::leash, std::vector<float>(side_of_square * side_of_square, 0.05f)));
    std::vector<Vec3> places;
    for (const Vec4& x : hung.positions()) places.push_back({x.x + 3, x.y + 0.3f * std::sin(6 * x.x), x.z});
    ASSERT_TRUE(hung.world.set_skin(hung.id, places, {}));
    for (std::size_t v = 0; v < places.size(); ++v)
        EXPECT_LT(distance(places[v], hung.positions()[v]), 0.0501f);
    EXPECT_LT(hung.world.step(h).peak_speed, 10);
}

TEST(Holds, ClothOffGoesWithItsBody) {
    Hung hung;
    const BodyId body = hung.world.add_body({.mass = 0, .gravity_scale = 0}, {}).value();
    ASSERT_TRUE(hung.world.attach(body, hung.id, std::vector<std::uint32_t>{0, side_of_square - 1}));
    for (int k = 0; k < 30; ++k) hung.world.step(h);
    ASSERT_TRUE(hung.world.set_enabled(hung.id, false));
    ASSERT_TRUE(hung.world.set_body_state(body, {.position = {3, 1, 0}}));
    ASSERT_TRUE(hung.world.set_enabled(hung.id, true));
    for (int k = 0; k < 10; ++k) EXPECT_LT(hung.world.step(h).peak_speed, 2);
}

TEST(Holds, ClothThatCannotGetThereStaysOff) {
    Hung hung;
    hung.pin({0});
    ASSERT_TRUE(hung.world.set_enabled(hung.id, false));
    ASSERT_TRUE(hung.world.move_pin(hung.id, 0, {1e5f, 0, 0}));
    const auto before = hung.world.state_hash();
    const auto refused = hung.world.set_enabled(hung.id, true);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("once at what holds it"), std::string::npos)
        << refused.error().message;
    EXPECT_EQ(hung.world.state_hash(), before);
    EXPECT_FALSE(hung.world.cloth_settings(hung.id)->enabled);
}

TEST(Holds, PinsFasterThanAllowedAreTold) {
    for (const bool contact : {false, true}) {
        ClothSettings settings;
        settings.self_collision = {.method =
                                       contact ? SelfCollisionMethod::contact : SelfCollisionMethod::off};
        Hung hung(settings);
        WorldSettings slow = hung.world.settings();
        slow.max_speed = 5;
        ASSERT_TRUE(hung.world.set_settings(slow));
        hung.pin({0, side_of_square - 1});
        EXPECT_FALSE(has(hung.world.step(h).flags, StepFlags::speed_limited));
        hung.move_pins({{0, 0.5f, 0}, {}});
        EXPECT_TRUE(has(hung.world.step(h).flags, StepFlags::speed_limited));
        EXPECT_TRUE(has(hung.world.cloth_report(hung.id)->flags, StepFlags::speed_limited));
    }
}

}  // namespace
}  // namespace weft::test::holds
