// Cloth on each kind of shape: it lies there, slides by Coulomb's law, and is carried.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "collision/colliders/nearest_surface.h"
#include "collision/shapes/held_shape.h"
#include "engine/least_turn.h"
#include "engine/vector.h"
#include "sloping_sheet.h"
#include "struck_sheet.h"
#include "tests/cloth/fixtures.h"
#include "tests/collision/colliders/solids.h"

namespace weft::test {
namespace {

constexpr Vec3 earth{0, -9.80665f, 0};

Rotation turned_by(float angle, const Vector3& axis) {
    const Eigen::Quaternionf q(Eigen::AngleAxisf(angle, axis.normalized()));
    return {q.x(), q.y(), q.z(), q.w()};
}

struct Laid {
    float deepest = 0;  // of a particle in the shape [m]
    float speed = 0;    // of all at the end, root of the mean square [m/s]
    float highest = -1, lowest = 9;
    std::uint32_t held = 0;
    bool sound = true;
};

/// A sheet of 1 m let fall from 10 cm above onto a shape that is about 0.3 m high, and what it does in 5 s.
Laid lay(Collider shape, const Shape* of = nullptr) {
    World world = World::create({.gravity = earth}).value();
    constexpr std::uint32_t side = 32;
    const Mesh mesh =
        make_sheet(
            {.rows = side, .columns = side, .origin = {-0.5f, 0.4f, -0.5f}, .u = {1, 0, 0}, .v = {0, 0, 1}})
            .value();
    ClothSettings settings;
    settings.thickness = 0.005f;
    settings.air_damping = 1;
    settings.sleep_speed = 0;  // what it lies on is counted
    std::optional<HeldShape> held;
    if (of != nullptr) {
        held = HeldShape::make(*of).value();
        std::get<PlacedShape>(shape.shape).shape = world.add_shape(*of).value();
    }
    const ClothId id = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Plane{}, .friction = 0.8f}));
    EXPECT_TRUE(world.add_collider(shape));
    Laid laid;
    for (int step = 0; step < 300; ++step) {
        const StepReport& report = world.step(1.0f / 60);
        laid.sound = laid.sound && !has(report.flags, StepFlags::state_restored);
        laid.held = report.collider_contacts;
        for (const Vec4& p : world.cloth(id)->positions)
            laid.deepest =
                std::max(laid.deepest, -nearest_surface(shape, xyz(p), held ? &*held : nullptr).distance);
    }
    for (const Vec4& v : world.cloth(id)->velocities)
        laid.speed += xyz(v).squaredNorm() / static_cast<float>(side * side);
    laid.speed = std::sqrt(laid.speed);
    for (const Vec4& p : world.cloth(id)->positions) {
        laid.highest = std::max(laid.highest, p.y);
        laid.lowest = std::min(laid.lowest, p.y);
    }
    return laid;
}

TEST(Shapes, ClothLaidOverABoxOrATaperedCapsuleRestsOutside) {
    const Collider shapes[] = {
        {Box{{0, 0.15f, 0}, {}, {0.2f, 0.15f, 0.2f}}, 0.5f},
        {Box{{0, 0.15f, 0}, turned_by(0.6f, {1, 0.3f, 0.5f}), {0.2f, 0.1f, 0.15f}}, 0.5f},
        {TaperedCapsule{{-0.2f, 0.15f, 0}, {0.25f, 0.2f, 0.1f}, 0.15f, 0.05f}, 0.5f}};
    for (const Collider& shape : shapes) {
        const Laid laid = lay(shape);
        EXPECT_TRUE(laid.sound);
        EXPECT_LT(laid.deepest, 1e-3f) << shape.shape.index();
        EXPECT_LT(laid.speed, 0.02f) << shape.shape.index();
        EXPECT_GT(laid.highest, 0.2f) << shape.shape.index();
        EXPECT_NEAR(laid.lowest, 0.005f, 1e-3f) << shape.shape.index();
        EXPECT_GT(laid.held, 100u) << shape.shape.index();
    }
}

TEST(Shapes, ClothLaidOverHeldShapesRestsOutside) {
    const Solid ring = torus(0.25f, 0.1f, 40, 20), block = box_mesh({0.2f, 0.1f, 0.15f});
    constexpr std::uint32_t side = 21;
    std::vector<float> heights;
    for (std::uint32_t r = 0; r < side; ++r)
        for (std::uint32_t c = 0; c < side; ++c)
            heights.push_back(0.1f + 0.1f * std::sin(0.9f * static_cast<float>(r)) *
                                         std::sin(0.7f * static_cast<float>(c)));
    const auto at = [](const Vec3& position, const Rotation& rotation) {
        return Collider{PlacedShape{{}, position, rotation}, 0.5f};
    };
    struct Case {
        const char* name;
        Shape shape;
        Collider collider;
    };
    const Case cases[] = {
        {"mesh", ring.mesh(), at({0, 0.15f, 0}, turned_by(0.3f, {1, 0, 0}))},
        {"hull", ConvexHull{block.vertices}, at({0, 0.15f, 0}, turned_by(0.6f, {1, 0.3f, 0.5f}))},
        {"field", DistanceField{ring.mesh(), 0.02f}, at({0, 0.15f, 0}, turned_by(0.3f, {1, 0, 0}))},
        {"ground", HeightField{side, side, 0.1f, heights}, at({-1, 0, -1}, {})}};
    for (const Case& c : cases) {
        const Laid laid = lay(c.collider, &c.shape);
        EXPECT_TRUE(laid.sound) << c.name;
        EXPECT_LT(laid.deepest, 1e-3f) << c.name;
        EXPECT_LT(laid.speed, 0.02f) << c.name;
        EXPECT_GT(laid.highest, 0.15f) << c.name;
        EXPECT_GT(laid.held, 100u) << c.name;
    }
}

TEST(Shapes, TheWorldKeepsShapesApartAndTogether) {
    World world = World::create({.gravity = earth}).value(), other = World::create({}).value();
    const Solid block = box_mesh({0.2f, 0.1f, 0.15f});
    const ShapeId shape = world.add_shape(block.mesh()).value();
    const ShapeId second = world.add_shape(ConvexHull{block.vertices}).value();
    EXPECT_EQ(world.shape_info(shape)->triangles, 12u);
    EXPECT_NEAR(world.shape_info(shape)->bounds.upper.x, 0.2f, 1e-5f);
    const auto code = [](const auto& result) { return result.error().code; };
    EXPECT_EQ(code(other.shape_info(shape)), ErrorCode::stale_id);
    EXPECT_EQ(code(other.add_collider({PlacedShape{shape}})), ErrorCode::stale_id);
    EXPECT_EQ(code(world.add_collider({PlacedShape{}})), ErrorCode::stale_id);
    EXPECT_EQ(code(world.add_collider({PlacedShape{shape, {}, {0, 0, 0, 0}}})), ErrorCode::invalid_argument);
    EXPECT_EQ(code(world.add_collider({PlacedShape{shape, {0, NAN, 0}}})), ErrorCode::invalid_argument);

    const ColliderId placed = world.add_collider({PlacedShape{shape, {1, 2, 3}}}).value();
    EXPECT_EQ(code(world.move_collider(placed, {PlacedShape{second}})), ErrorCode::invalid_argument);
    EXPECT_EQ(code(world.move_collider(placed, {Sphere{}})), ErrorCode::invalid_argument);
    EXPECT_EQ(code(world.place_collider(placed, {PlacedShape{}})), ErrorCode::invalid_argument);
    EXPECT_EQ(std::get<PlacedShape>(world.collider(placed)->shape).position.z, 3);
    EXPECT_EQ(code(world.remove_shape(shape)), ErrorCode::invalid_argument);
    EXPECT_TRUE(world.shape_info(shape).ok());
    EXPECT_TRUE(world.move_collider(placed, {PlacedShape{shape, {1, 2, 4}}}));
    world.step(1.0f / 60);
    EXPECT_EQ(std::get<PlacedShape>(world.collider(placed)->shape).position.z, 4);
    EXPECT_TRUE(world.remove_collider(placed));
    EXPECT_TRUE(world.remove_shape(shape));
    EXPECT_EQ(code(world.remove_shape(shape)), ErrorCode::stale_id);
    EXPECT_EQ(code(world.deform_shape(shape, block.vertices)), ErrorCode::stale_id);
    EXPECT_EQ(code(world.deform_shape(second, block.vertices)), ErrorCode::invalid_argument);
}

/// A sheet on a block that is carried, as a mesh that moves or as one whose vertices do.
TEST(Shapes, AMeshCarriesClothWhetherItMovesOrDeforms) {
    for (const bool deforms : {false, true}) {
        World world = World::create(vacuum(earth)).value();
        const Solid block = box_mesh({0.5f, 0.1f, 0.5f});
        ClothSettings settings;
        settings.thickness = 0.005f;
        const Mesh mesh = make_sheet({.rows = 16,
                                      .columns = 16,
                                      .origin = {-0.2f, 0.106f, -0.2f},
                                      .u = {0.4f, 0, 0},
                                      .v = {0, 0, 0.4f}})
                              .value();
        const ClothId cloth = world.add_cloth(mesh, settings).value();
        const ShapeId shape = world.add_shape(block.mesh()).value();
        const ColliderId id = world.add_collider({PlacedShape{shape}, 2}).value();
        for (int step = 1; step <= 60; ++step) {
            // Gathers speed at 2 m/s^2, a quarter of what friction can give.
            const float t = static_cast<float>(step) / 60, way = t * t;
            Solid moved = block;
            for (Vec3& v : moved.vertices) v.x += way;
            const Result<void> answer = deforms
                                            ? world.deform_shape(shape, moved.vertices)
                                            : world.move_collider(id, {PlacedShape{shape, {way, 0, 0}}, 2});
            ASSERT_TRUE(answer);
            EXPECT_FALSE(has(world.step(1.0f / 60).flags, StepFlags::state_restored));
        }
        double x = 0, v = 0;
        for (const Vec4& p : world.cloth(cloth)->positions) x += static_cast<double>(p.x) / 256;
        for (const Vec4& p : world.cloth(cloth)->velocities) v += static_cast<double>(p.x) / 256;
        EXPECT_NEAR(x, 1, 0.015) << deforms;  // it slips until friction is known
        EXPECT_NEAR(v, 2, 0.05) << deforms;
    }
}

struct Slid {
    double way;           // in a second [m]
    double acceleration;  // in the second half of it [m/s^2]
};

/// A sheet on a slope that is the top of `ground`, turned by the angle.
Slid slide(const std::function<Collider(const Vector3& normal, float friction)>& ground, double angle,
           double friction) {
    SlopingSheet sheet(angle);
    EXPECT_TRUE(sheet.world.add_collider(ground(sheet.normal, static_cast<float>(friction))));
    const double start = sheet.place();
    sheet.run(30);
    const double speed = sheet.speed();
    sheet.run(30);
    return {sheet.place() - start, (sheet.speed() - speed) / 0.5};
}

TEST(Shapes, ASheetOnABoxHoldsAndSlidesByCoulombsLaw) {
    const auto box = [](const Vector3& normal, float friction) {
        const Eigen::Quaternionf turn = least_turn(Vector3::UnitY(), normal);
        return Collider{
            Box{to_vec3(Vector3(-0.1f * normal)), {turn.x(), turn.y(), turn.z(), turn.w()}, {5, 0.1f, 5}},
            friction};
    };
    const auto plane = [](const Vector3& normal, float friction) {
        return Collider{Plane{to_vec3(normal), 0}, friction};
    };
    const double angle = 0.5, least = std::tan(angle), g = 9.80665;
    EXPECT_NEAR(slide(box, angle, 1.02 * least).way, 0, 1e-3);
    EXPECT_GT(slide(box, angle, 0.98 * least).way, 5e-3);
    for (const double friction : {0.0, 0.2, 0.4}) {
        const double expected = g * (std::sin(angle) - friction * std::cos(angle));
        const Slid slid = slide(box, angle, friction);
        EXPECT_NEAR(slid.acceleration, expected, 0.02 * expected) << friction;
        EXPECT_NEAR(slid.way, slide(plane, angle, friction).way, 1e-3) << friction;
    }
}

TEST(Shapes, ASheetThatSticksToASlopeDoesNotCreep) {
    const double angle = 0.35;
    for (const double friction : {1.1, 1.4})
        for (const bool on_box : {false, true}) {
            SlopingSheet sheet(angle);
            const Eigen::Quaternionf turn = least_turn(Vector3::UnitY(), sheet.normal);
            Collider ground{Plane{to_vec3(sheet.normal), 0}};
            if (on_box)
                ground.shape = Box{to_vec3(Vector3(-0.1f * sheet.normal)),
                                   {turn.x(), turn.y(), turn.z(), turn.w()},
                                   {5, 0.1f, 5}};
            ground.friction = static_cast<float>(friction * std::tan(angle));
            ASSERT_TRUE(sheet.world.add_collider(ground));
            sheet.run(60);
            const double before = sheet.place();
            sheet.run(300);
            EXPECT_NEAR(sheet.place() - before, 0, 1e-5) << friction << ' ' << on_box;
        }
}

/// How far the lower end of a strip over a rod goes down, by seconds 2 to 7 [m]. On one side hangs twice as
/// much as on the other.
double creep_over_a_rod(float friction, bool is_mesh) {
    constexpr std::uint32_t rows = 97, columns = 5;
    constexpr float radius = 0.05f, thickness = 0.003f, length = 1.2f, r = radius + thickness;
    const float around = static_cast<float>(EIGEN_PI) * r, up = (length - around) / 3;
    Mesh mesh =
        make_sheet({.rows = rows, .columns = columns, .u = {0.05f, 0, 0}, .v = {0, 0, length}}).value();
    if (is_mesh) mesh.rows = mesh.columns = 0;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        const float s = length * static_cast<float>(i / columns) / (rows - 1);
        const float x = 0.05f * static_cast<float>(i % columns) / (columns - 1), t = (s - up) / r;
        if (is_mesh) mesh.pattern.push_back({x, s});
        mesh.positions[i] = s < up            ? Vec3{x, s - up, -r}
                            : s < up + around ? Vec3{x, r * std::sin(t), -r * std::cos(t)}
                                              : Vec3{x, up + around - s, r};
    }
    World world = World::create(vacuum(earth)).value();
    ClothSettings settings;
    settings.thickness = thickness;
    settings.fabric.bending = 1e-7f;
    settings.sleep_speed = 0;
    const ClothId cloth = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(world.add_collider({Capsule{{-0.2f, 0, 0}, {0.3f, 0, 0}, radius}, friction}));
    const auto lowest = [&] { return static_cast<double>(world.cloth(cloth)->bounds.lower.y); };
    for (int k = 0; k < 120; ++k) world.step(1.0f / 60);
    const double before = lowest();
    for (int k = 0; k < 300; ++k) world.step(1.0f / 60);
    return before - lowest();
}

// By Euler and Eytelwein, with the weight on the rod itself, it holds from a friction of .194 on.
TEST(Shapes, AStripOverARodHoldsOrSlips) {
    for (const bool is_mesh : {false, true})
        for (const float friction : {0.21f, 0.4f})
            EXPECT_NEAR(creep_over_a_rod(friction, is_mesh), 0, 3e-4) << friction << ' ' << is_mesh;
    EXPECT_GT(creep_over_a_rod(0.185f, false), 0.1);
}

/// A plate of 30 x 30 x 2 cm, flat against the sheet, that pushes a hung sheet 0.6 m along.
TEST(Shapes, AThinBoxMovedFastCarriesASheet) {
    constexpr float h = 1.0f / 60, travel = 0.6f;
    for (const float speed : {3.0f, 30.0f})
        for (const float phase : {0.0f, 0.35f, 0.7f}) {
            World world = World::create({.gravity = earth}).value();
            ClothSettings settings;
            settings.thickness = 0.005f;
            const Mesh mesh =
                make_sheet(
                    {.rows = 48, .columns = 48, .origin = {-0.5f, 1, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}})
                    .value();
            const ClothId id = world.add_cloth(mesh, settings).value();
            std::vector<std::uint32_t> top(48);
            for (std::uint32_t k = 0; k < 48; ++k) top[k] = k;
            ASSERT_TRUE(world.pin(id, top));
            const auto at = [&](float t) {
                const float way = std::clamp(speed * t, 0.0f, travel);
                return Collider{Box{{0, 0.4f, -0.3f + way}, turned_by(way, {0, 0, 1}), {0.15f, 0.15f, 0.01f}},
                                0.4f};
            };
            const ColliderId plate = world.add_collider(at(0)).value();
            const int turn = layers_before(world.cloth(id).value(), {0.01f, 0.5f, -1});
            const int steps = static_cast<int>(std::ceil(travel / speed / h + phase));  // when it arrives
            for (int step = 1; step <= steps; ++step) {
                ASSERT_TRUE(world.move_collider(plate, at((static_cast<float>(step) - phase) * h)));
                EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
            }
            // All about the plate the sheet lies before it.
            const ClothView view = world.cloth(id).value();
            for (const float x : {-0.08f, 0.001f, 0.08f})
                for (const float y : {-0.08f, 0.001f, 0.08f})
                    EXPECT_EQ(layers_before(view, {x, 0.4f + y, 0.3f}), turn) << speed << ' ' << phase;
        }
}

TEST(Shapes, ContactsWithABoxSayWhereItsSurfaceIs) {
    World world = World::create({.gravity = earth, .contact_reports = 4096}).value();
    const Mesh mesh =
        make_sheet(
            {.rows = 9, .columns = 9, .origin = {-0.1f, 0.306f, -0.1f}, .u = {0.2f, 0, 0}, .v = {0, 0, 0.2f}})
            .value();
    ClothSettings settings;
    settings.thickness = 0.005f;
    ASSERT_TRUE(world.add_cloth(mesh, settings));
    const ColliderId box = world.add_collider({Box{{0, 0.2f, 0}, {}, {0.4f, 0.1f, 0.4f}}, 0.5f}).value();
    for (int step = 0; step < 30; ++step) world.step(1.0f / 60);
    ASSERT_EQ(world.contacts().size(), 81u);
    for (const Contact& contact : world.contacts()) {
        EXPECT_EQ(contact.collider, box);
        EXPECT_NEAR(contact.point.y, 0.3f, 1e-5f);
        EXPECT_FLOAT_EQ(contact.normal.y, 1);
    }
}

}  // namespace
}  // namespace weft::test
