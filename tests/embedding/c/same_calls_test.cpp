// What a host in C gives reaches the World as it is: the recording of its calls is that of the same calls in
// C++.

#include <gtest/gtest.h>
#include <weft/weft.h>
#include <weft/weft_c.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "cloth/c/handles.h"
#include "cloth/record/record_format.h"

namespace weft::test {
namespace {

/// All that a host gives below, other numbers at every place.
struct Given {
    std::vector<Vec3> places, normals;
    std::vector<float> masses;
    std::array<std::uint32_t, 2> corners{0, 3};
    std::array<Vec3, 2> targets{Vec3{0, 1.1f, 0}, Vec3{1, 1.2f, 0.1f}};
    std::vector<Vec3> mesh{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}};
    std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}};
    std::array<float, 6> heights{0, 1, 2, 3, 4, 5};
    std::vector<Vec2> texcoords, pattern;
    std::vector<std::uint32_t> welds;
    Transform by{.translation = {1, 2, 3}, .rotation = {0.6f, 0, 0, 0.8f}};

    Given() {
        for (std::uint32_t k = 0; k < 20; ++k) {
            const float at = static_cast<float>(k);
            places.push_back({0.01f * at, 1 + 0.01f * at, -0.01f * at});
            normals.push_back({std::cos(0.1f * at), std::sin(0.1f * at), 0});
            masses.push_back(1 + 0.1f * at);
            texcoords.push_back({0.01f * at, 1 - 0.01f * at});
            pattern.push_back({static_cast<float>(k % 4) / 3, static_cast<float>(k / 4) / 4});
            welds.push_back(k);
        }
    }
};

/// The recorded bytes, and the generations of the ids, which differ between Worlds.
struct Tape {
    std::vector<std::byte> bytes;
    std::vector<std::uint32_t> generations;

    template <class Id>
    Id note(Id id) {
        generations.push_back(id.generation);
        return id;
    }
};

bool append(void* user, std::span<const std::byte> bytes) {
    auto& to = static_cast<Tape*>(user)->bytes;
    to.insert(to.end(), bytes.begin(), bytes.end());
    return true;
}
WeftBool append_from_c(void* user, const void* bytes, std::size_t count) {
    return append(user, {static_cast<const std::byte*>(bytes), count});
}

const SheetSettings five_by_four{.rows = 5, .columns = 4, .origin = {0, 1, 0}};

Tape calls_in_cpp(const Given& given) {
    Tape tape;
    World world = World::create().value();
    EXPECT_TRUE(world.start_recording({append, &tape}).ok());
    Mesh mesh = make_sheet(five_by_four).value();
    mesh.texcoords = given.texcoords;
    mesh.pattern = given.pattern;
    mesh.welds = given.welds;
    const ClothId cloth = tape.note(world.add_cloth(mesh, {.friction = 0.4f}).value());
    const CookedCloth cooked = CookedCloth::create(mesh).value();
    const ClothId other = tape.note(world.add_cloth(cooked, given.by).value());
    EXPECT_TRUE(world.set_importance(cloth, 2).ok());
    EXPECT_TRUE(world.set_enabled(other, false).ok());
    EXPECT_TRUE(world.set_enabled(other, true).ok());
    EXPECT_TRUE(world.pin(cloth, given.corners).ok());
    EXPECT_TRUE(world.move_pins(cloth, given.corners, given.targets).ok());
    EXPECT_TRUE(world.move_pin(cloth, 3, given.targets[0]).ok());
    EXPECT_TRUE(world.unpin(cloth, 3).ok());
    EXPECT_TRUE(world.set_map(cloth, Map::mass, given.masses).ok());
    EXPECT_TRUE(world.set_map(cloth, Map::backstop, given.masses).ok());
    EXPECT_TRUE(world.set_skin(cloth, given.places, given.normals).ok());
    EXPECT_TRUE(world.set_frame(cloth, given.by).ok());
    EXPECT_TRUE(world.leave_frame(cloth).ok());
    EXPECT_TRUE(world.move_cloth(other, given.by).ok());
    EXPECT_TRUE(world.reset_cloth(cloth, given.places).ok());
    EXPECT_TRUE(world.resume_cloth(cloth, given.places, given.places, given.normals).ok());
    EXPECT_TRUE(world.shift_origin({1, 2, 3}).ok());

    const ShapeId open = tape.note(world.add_shape(TriangleMesh{given.mesh, given.faces, false}).value());
    EXPECT_TRUE(world.deform_shape(open, given.mesh).ok());
    tape.note(world.add_shape(HeightField{2, 3, 0.5f, given.heights}).value());
    const ColliderId ball =
        tape.note(world.add_collider({.shape = Sphere{{0, -5, 0}, 0.3f}, .friction = 0.7f}).value());
    EXPECT_TRUE(world.move_collider(ball, {.shape = Sphere{{0, -4, 0}, 0.3f}}).ok());
    EXPECT_TRUE(world.place_collider(ball, {.shape = Sphere{{0, -3, 0}, 0.3f}}).ok());
    const BodyId body = tape.note(world.add_body({.mass = 2}, {.position = {0, -5, 0}}).value());
    EXPECT_TRUE(world.set_body_settings(body, {.mass = 3}).ok());
    EXPECT_TRUE(world.set_body_state(body, {.velocity = {1, 0, 0}}).ok());
    EXPECT_TRUE(world.attach_collider(body, ball).ok());
    EXPECT_TRUE(world.attach(body, other, given.corners).ok());
    EXPECT_TRUE(world.detach(other, std::span(given.corners).first(1)).ok());
    EXPECT_TRUE(world.detach_collider(ball).ok());
    const SeamId seam = tape.note(
        world.stitch(cloth, given.corners, other, given.corners, {.rest_length = 0.1f, .break_force = 5})
            .value());
    world.step(1.0f / 60);
    EXPECT_TRUE(world.unstitch(seam).ok());
    EXPECT_TRUE(world.wake(cloth).ok());
    EXPECT_TRUE(world.set_cloth_settings(cloth, {.air_damping = 0.3f}).ok());
    EXPECT_TRUE(world.set_settings({.max_speed = 40}).ok());
    EXPECT_TRUE(world.remove_body(body).ok());
    EXPECT_TRUE(world.remove_collider(ball).ok());
    EXPECT_TRUE(world.remove_shape(open).ok());
    EXPECT_TRUE(world.remove_cloth(other).ok());
    EXPECT_TRUE(world.stop_recording().ok());
    return tape;
}

template <class T>
WeftInput input(const T& list) {
    return {std::data(list), std::size(list), 0};
}

/// The sheet, with the host's lists besides.
WeftMesh* mesh_in_c(const Given& given) {
    WeftSheetSettings settings = c::to_c<WeftSheetSettings>(five_by_four);
    settings.struct_size = sizeof settings;
    WeftMesh *plain = nullptr, *mesh = nullptr;
    EXPECT_EQ(weft_mesh_make_sheet(&settings, &plain), WEFT_OK);
    WeftMeshView view{};
    view.struct_size = sizeof view;
    EXPECT_EQ(weft_mesh_view(plain, &view), WEFT_OK);
    view.texcoords = input(given.texcoords);
    view.pattern = input(given.pattern);
    view.welds = input(given.welds);
    EXPECT_EQ(weft_mesh_create(&view, &mesh), WEFT_OK);
    weft_mesh_destroy(plain);
    return mesh;
}

/// The view for C is of the same places.
void expect_same_view(const WeftWorld* world, WeftClothId id) {
    WeftClothView seen{};
    seen.struct_size = sizeof seen;
    ASSERT_EQ(weft_world_cloth(world, id, &seen), WEFT_OK);
    const ClothView& of = *world->world->cloth(std::bit_cast<ClothId>(id));
    const std::array<std::pair<const void*, const void*>, 8> pairs{{
        {seen.positions, of.positions.data()},
        {seen.previous_positions, of.previous_positions.data()},
        {seen.velocities, of.velocities.data()},
        {seen.normals, of.normals.data()},
        {seen.triangles, of.triangles.data()},
        {seen.vertex_to_particle, of.vertex_to_particle.data()},
        {seen.texcoords, of.texcoords.data()},
        {seen.vertex_triangles, of.vertex_triangles.data()},
    }};
    for (std::size_t k = 0; k < pairs.size(); ++k) EXPECT_EQ(pairs[k].first, pairs[k].second) << k;
    EXPECT_EQ(seen.bounds.upper.x, of.bounds.upper.x);
}

using Line = std::array<float, 9>;
/// Expects debug drawing to give C the same lines as C++.
void expect_same_lines(const WeftWorld* world) {
    std::vector<Line> in_cpp, in_c;
    const DebugCanvas canvas{&in_cpp, [](void* user, const Vec3& from, const Vec3& to, const Vec3& colour) {
                                 static_cast<std::vector<Line>*>(user)->push_back(
                                     std::bit_cast<Line>(std::array{from, to, colour}));
                             }};
    const WeftDebugCanvas canvas_in_c{
        &in_c,
        [](void* user, const WeftVec3* from, const WeftVec3* to, const WeftVec3* colour) {
            static_cast<std::vector<Line>*>(user)->push_back(
                std::bit_cast<Line>(std::array{*from, *to, *colour}));
        },
        nullptr};
    world->world->debug_draw(canvas, DebugParts::strain);
    EXPECT_EQ(weft_world_debug_draw(world, &canvas_in_c, WEFT_DRAW_STRAIN), WEFT_OK);
    EXPECT_FALSE(in_c.empty());
    EXPECT_EQ(in_c, in_cpp);
}

Tape calls_in_c(const Given& given) {
    Tape tape;
    WeftWorld* world = nullptr;
    EXPECT_EQ(weft_world_create(nullptr, &world), WEFT_OK);
    const WeftRecordingSink sink{append_from_c, &tape};
    EXPECT_EQ(weft_world_start_recording_to(world, &sink), WEFT_OK);
    WeftMesh* const mesh = mesh_in_c(given);
    WeftClothSettings settings;
    weft_cloth_settings_init(&settings, sizeof settings);
    settings.friction = 0.4f;
    WeftClothId cloth, other;
    EXPECT_EQ(weft_world_add_cloth(world, mesh, &settings, &cloth), WEFT_OK);
    tape.note(cloth);
    WeftCookedCloth* cooked = nullptr;
    EXPECT_EQ(weft_cooked_cloth_create(mesh, nullptr, nullptr, &cooked), WEFT_OK);
    const auto by = std::bit_cast<WeftTransform>(given.by);
    EXPECT_EQ(weft_world_add_cooked_cloth(world, cooked, &by, &other), WEFT_OK);
    tape.note(other);
    const auto& corners = given.corners;
    EXPECT_EQ(weft_world_set_importance(world, cloth, 2), WEFT_OK);
    EXPECT_EQ(weft_world_set_enabled(world, other, 0), WEFT_OK);
    EXPECT_EQ(weft_world_set_enabled(world, other, 2), WEFT_OK);  // all but 0 is true
    EXPECT_EQ(weft_world_pin(world, cloth, corners.data(), 2), WEFT_OK);
    EXPECT_EQ(weft_world_move_pins(world, cloth, corners.data(), 2, input(given.targets)), WEFT_OK);
    EXPECT_EQ(weft_world_move_pin(world, cloth, 3, std::bit_cast<WeftVec3>(given.targets[0])), WEFT_OK);
    EXPECT_EQ(weft_world_unpin(world, cloth, &corners[1], 1), WEFT_OK);
    EXPECT_EQ(weft_world_set_map(world, cloth, WEFT_MAP_MASS, input(given.masses)), WEFT_OK);
    EXPECT_EQ(weft_world_set_map(world, cloth, WEFT_MAP_BACKSTOP, input(given.masses)), WEFT_OK);
    EXPECT_EQ(weft_world_set_skin(world, cloth, input(given.places), input(given.normals)), WEFT_OK);
    EXPECT_EQ(weft_world_set_frame(world, cloth, &by), WEFT_OK);
    EXPECT_EQ(weft_world_leave_frame(world, cloth), WEFT_OK);
    EXPECT_EQ(weft_world_move_cloth(world, other, &by), WEFT_OK);
    EXPECT_EQ(weft_world_reset_cloth(world, cloth, input(given.places)), WEFT_OK);
    EXPECT_EQ(
        weft_world_resume_cloth(world, cloth, input(given.places), input(given.places), input(given.normals)),
        WEFT_OK);
    EXPECT_EQ(weft_world_shift_origin(world, {1, 2, 3}), WEFT_OK);

    WeftShape solid;
    WeftShapeId open, ground;
    weft_shape_init(&solid, sizeof solid, WEFT_TRIANGLE_MESH);
    solid.vertices = input(given.mesh);
    solid.triangles = input(given.faces);
    solid.closed = 0;
    EXPECT_EQ(weft_world_add_shape(world, &solid, &open), WEFT_OK);
    tape.note(open);
    EXPECT_EQ(weft_world_deform_shape(world, open, input(given.mesh)), WEFT_OK);
    weft_shape_init(&solid, sizeof solid, WEFT_HEIGHT_FIELD);
    solid.rows = 2;
    solid.columns = 3;
    solid.spacing = 0.5f;
    solid.heights = input(given.heights);
    EXPECT_EQ(weft_world_add_shape(world, &solid, &ground), WEFT_OK);
    tape.note(ground);
    WeftCollider collider;
    WeftColliderId ball;
    weft_collider_init(&collider, sizeof collider, WEFT_SPHERE);
    collider.radius = 0.3f;
    collider.center = {0, -5, 0};
    collider.friction = 0.7f;
    EXPECT_EQ(weft_world_add_collider(world, &collider, &ball), WEFT_OK);
    tape.note(ball);
    weft_collider_init(&collider, sizeof collider, WEFT_SPHERE);
    collider.radius = 0.3f;
    collider.center = {0, -4, 0};
    EXPECT_EQ(weft_world_move_collider(world, ball, &collider), WEFT_OK);
    collider.center = {0, -3, 0};
    EXPECT_EQ(weft_world_place_collider(world, ball, &collider), WEFT_OK);
    WeftBodySettings heavy;
    WeftBodyState state;
    WeftBodyId body;
    weft_body_settings_init(&heavy, sizeof heavy);
    weft_body_state_init(&state, sizeof state);
    heavy.mass = 2;
    state.position = {0, -5, 0};
    EXPECT_EQ(weft_world_add_body(world, &heavy, &state, &body), WEFT_OK);
    tape.note(body);
    heavy.mass = 3;
    EXPECT_EQ(weft_world_set_body_settings(world, body, &heavy), WEFT_OK);
    weft_body_state_init(&state, sizeof state);
    state.velocity = {1, 0, 0};
    EXPECT_EQ(weft_world_set_body_state(world, body, &state), WEFT_OK);
    EXPECT_EQ(weft_world_attach_collider(world, body, ball), WEFT_OK);
    EXPECT_EQ(weft_world_attach(world, body, other, corners.data(), 2), WEFT_OK);
    EXPECT_EQ(weft_world_detach(world, other, corners.data(), 1), WEFT_OK);
    EXPECT_EQ(weft_world_detach_collider(world, ball), WEFT_OK);
    WeftSeamSettings thread;
    WeftSeamId seam;
    weft_seam_settings_init(&thread, sizeof thread);
    thread.rest_length = 0.1f;
    thread.break_force = 5;
    EXPECT_EQ(weft_world_stitch(world, cloth, corners.data(), other, corners.data(), 2, &thread, &seam),
              WEFT_OK);
    tape.note(seam);
    EXPECT_EQ(weft_world_step(world, 1.0f / 60), WEFT_OK);
    expect_same_view(world, cloth);
    expect_same_lines(world);
    EXPECT_EQ(weft_world_unstitch(world, seam), WEFT_OK);
    EXPECT_EQ(weft_world_wake(world, cloth), WEFT_OK);
    weft_cloth_settings_init(&settings, sizeof settings);
    settings.air_damping = 0.3f;
    EXPECT_EQ(weft_world_set_cloth_settings(world, cloth, &settings), WEFT_OK);
    WeftWorldSettings fast;
    weft_world_settings_init(&fast, sizeof fast);
    fast.max_speed = 40;
    EXPECT_EQ(weft_world_set_settings(world, &fast), WEFT_OK);
    EXPECT_EQ(weft_world_remove_body(world, body), WEFT_OK);
    EXPECT_EQ(weft_world_remove_collider(world, ball), WEFT_OK);
    EXPECT_EQ(weft_world_remove_shape(world, open), WEFT_OK);
    EXPECT_EQ(weft_world_remove_cloth(world, other), WEFT_OK);
    EXPECT_EQ(weft_world_stop_recording(world), WEFT_OK);
    weft_mesh_destroy(mesh);
    weft_cooked_cloth_destroy(cooked);
    weft_world_destroy(world);
    return tape;
}

struct Recorded {
    std::uint32_t call;
    std::string given;
};
/// With the ids of another World in place of its own.
std::vector<Recorded> records(const Tape& tape, const std::vector<std::uint32_t>& generations) {
    std::vector<Recorded> all;
    for (std::size_t at = sizeof(RecordingHead); at + sizeof(RecordHead) <= tape.bytes.size();) {
        RecordHead head;
        std::memcpy(&head, &tape.bytes[at], sizeof head);
        at += sizeof head;
        std::string given(reinterpret_cast<const char*>(tape.bytes.data()) + at, head.bytes);
        at += head.bytes;
        for (std::size_t k = 0; k < generations.size(); ++k) {
            const auto word = [](const std::uint32_t& of) {
                return std::string(reinterpret_cast<const char*>(&of), sizeof of);
            };
            const std::string own = word(tape.generations[k]), other = word(generations[k]);
            for (std::size_t i = 0; i + 4 <= given.size(); ++i)
                if (given.compare(i, 4, own) == 0) given.replace(i, 4, other);
        }
        all.push_back({head.call, given});
    }
    return all;
}

TEST(CallsFromC, AreRecordedAsThoseOfCpp) {
    const Given given;
    const Tape in_cpp = calls_in_cpp(given), in_c = calls_in_c(given);
    ASSERT_EQ(in_c.generations.size(), in_cpp.generations.size());
    const std::vector<std::uint32_t> nobody(in_cpp.generations.size(), 0);
    const std::vector<Recorded> expected = records(in_cpp, nobody), found = records(in_c, nobody);
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_GT(found.size(), 35u);
    for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k].call, expected[k].call) << "record " << k;
        EXPECT_TRUE(found[k].given == expected[k].given)
            << "record " << k << ", call " << found[k].call << ", has other values";
    }
}

}  // namespace
}  // namespace weft::test
