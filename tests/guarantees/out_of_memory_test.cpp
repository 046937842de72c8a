// Memory runs out at every allocation of every public call in turn: the call says so, or works all the same,
// and a call that failed has changed nothing, now or in any later step.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/fuzz/text.h"
#include "tests/guarantees/allocation_count.h"
#include "tests/guarantees/method_cases.h"

namespace weft::test {
namespace {

constexpr float frame_time = 1.0f / 60;
constexpr std::uint32_t side = 7;
constexpr std::uint64_t most_allocations = 100'000;  // of one call

struct Tetrahedron {
    std::array<Vec3, 4> vertices{{{0, 0, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}, {0, 0, 0.2f}}};
    std::array<std::array<std::uint32_t, 3>, 4> triangles{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    [[nodiscard]] TriangleMesh mesh() const { return {vertices, triangles}; }
};

/// Two cloths that hang, with wind and a collider that they meet, after some steps.
struct Scene {
    explicit Scene(const ClothSettings& settings = {}, bool bare = false, const ClothSettings& of_other = {})
        : world(World::create(bare ? still() : windy()).value()) {
        cloth = world.add_cloth(LoweredSheet::mesh(true, side), settings).value();
        other = world.add_cloth(LoweredSheet::mesh(false, side), of_other).value();
        for (const ClothId id : {cloth, other}) EXPECT_TRUE(world.pin(id, 0));
        if (!bare) collider = world.add_collider({.shape = Sphere{{0, 0.3f, 0.05f}, 0.1f}}).value();
        if (!bare) shape = world.add_shape(Tetrahedron{}.mesh()).value();
        if (!bare) body = world.add_body({}, {.position = {0, 0.4f, 0.3f}}).value();
        step();
    }
    static WorldSettings windy() {
        WorldSettings settings;
        settings.threads = 1;  // so that allocations come in one order
        settings.wind.velocity = {0, 0, 2};
        return settings;
    }
    static WorldSettings still() {
        WorldSettings settings = windy();
        settings.wind.air_density = 0;
        return settings;
    }
    void step() {
        for (int k = 0; k < 2; ++k) world.step(frame_time);
    }
    [[nodiscard]] std::string look() const {
        return fuzz::snapshot(world, std::vector{cloth, other}, std::vector{collider});
    }

    World world;
    ClothId cloth, other;
    ColliderId collider;
    ShapeId shape;
    BodyId body;
};

using Answer = Result<void>;

template <class T>
Answer without_value(const Result<T>& result) {
    return result ? Answer() : Answer(result.error());
}

/// After how many allocations memory runs out next: after each of the first, then ever more seldom, since a
/// large call makes thousands. Calls make the same allocations in part; a shift of its own lets each try
/// others of them. WEFT_EVERY_ALLOCATION tries them all, which takes half an hour.
std::uint64_t next_tried(std::uint64_t allowed, std::size_t shift = 0) {
    static const bool every = std::getenv("WEFT_EVERY_ALLOCATION") != nullptr;
    constexpr std::uint64_t all_of = 12, seldom = 3;
    return every || allowed < all_of ? allowed + 1 : allowed + allowed / seldom + shift % 4;
}

/// A call of a World.
struct Call {
    std::string name;
    std::function<Answer(Scene&)> make;
    ClothSettings before = {};  ///< of the scene's first cloth
    bool bare = false;          ///< without air and colliders
    ClothSettings other = {};   ///< of its second
};
void PrintTo(const Call& call, std::ostream* out) {
    *out << call.name;
}

/// How a World looks in which memory never ran out.
struct Expected {
    explicit Expected(const Call& call) {
        Scene late(call.before, call.bare, call.other), soon(call.before, call.bare, call.other);
        before = late.look();
        late.step();
        without = late.look();
        EXPECT_TRUE(call.make(late)) << "even with memory";
        late.step();
        with_late = late.look();
        EXPECT_TRUE(call.make(soon));
        soon.step();
        with = soon.look();
    }
    std::string before;
    std::string with, without;  ///< the call, and two steps on
    std::string with_late;      ///< the call after the first two of four steps
};

/// Empty if all is as it must be; else what is not.
std::string fault_at(const Call& call, const Expected& expected, std::uint64_t allowed,
                     MemoryRunsOut::For how_long, bool& ran_out) {
    Scene scene(call.before, call.bare, call.other);
    Answer answer;
    {
        const MemoryRunsOut memory(allowed, how_long);
        try {
            answer = call.make(scene);
        } catch (...) {
            ran_out = memory.happened();
            return "an exception came out of it";
        }
        ran_out = memory.happened();
    }
    if (answer) {
        scene.step();
        return scene.look() == expected.with ? "" : "it worked, and later steps differ";
    }
    if (answer.error().code != ErrorCode::out_of_memory) return "its error is " + answer.error().message;
    if (scene.look() != expected.before) return "it failed and changed something";
    scene.step();
    if (scene.look() != expected.without) return "it failed, and later steps differ";
    // Now there is memory: what the first try left behind must not stand in the way.
    if (!call.make(scene)) return "with memory it fails as well";
    scene.step();
    return scene.look() == expected.with_late ? "" : "it failed, and the next try does something else";
}

class OutOfMemory : public testing::TestWithParam<Call> {};

TEST_P(OutOfMemory, ChangesNothing) {
    const Expected expected(GetParam());
    for (const MemoryRunsOut::For how_long : {MemoryRunsOut::For::one, MemoryRunsOut::For::good}) {
        bool ran_out = true;
        for (std::uint64_t allowed = 0; ran_out && allowed < most_allocations;
             allowed = next_tried(allowed, GetParam().name.size())) {
            const std::string fault = fault_at(GetParam(), expected, allowed, how_long, ran_out);
            EXPECT_EQ(fault, "") << "after " << allowed << " allocations, memory gone for "
                                 << (how_long == MemoryRunsOut::For::one ? "one" : "good");
        }
        EXPECT_FALSE(ran_out) << "it never ends";
    }
}

ClothSettings all_options(const Method& method) {
    ClothSettings settings;
    settings.method = method;
    settings.tethers.enabled = true;
    settings.self_collision.method = SelfCollisionMethod::contact;
    settings.time_scheme = TimeScheme::bdf2;
    return settings;
}

std::vector<Call> changes_of_cloths() {
    std::vector<Call> calls;
    const auto change = [&](const std::string& name, const ClothSettings& to,
                            const ClothSettings& from = {}) {
        const auto set = [to](Scene& s) { return s.world.set_cloth_settings(s.cloth, to); };
        calls.push_back({name, set, from});
    };
    for (const MethodCase& to : method_cases()) {
        if (!to.grid) continue;
        change("set_cloth_settings_" + to.name, to.cloth);
    }
    change("set_cloth_settings_back_from_all_options", {}, all_options(Multilevel{}));
    change("set_cloth_settings_from_xpbd", all_options(Multilevel{}), all_options(Xpbd{}));
    change("set_cloth_settings_from_fibres", all_options(Chebyshev{}), all_options(Fibres{}));
    const auto meeting_by = [](SelfCollisionMethod method) {
        ClothSettings settings;
        settings.self_collision = {.method = method};
        return settings;
    };
    const ClothSettings contact = meeting_by(SelfCollisionMethod::contact),
                        zones = meeting_by(SelfCollisionMethod::impact_zones);
    change("set_cloth_settings_from_contact_to_zones", zones, contact);
    const auto meet = [contact, mesh = LoweredSheet::mesh(true, side)](Scene& s) {
        return without_value(s.world.add_cloth(mesh, contact));
    };
    calls.push_back({.name = "add_cloth_as_second_with_contact", .make = meet, .before = contact});
    calls.push_back(
        {.name = "add_cloth_as_third_with_contact", .make = meet, .before = contact, .other = contact});
    calls.push_back({.name = "add_cloth_beside_zones", .make = meet, .before = contact, .other = zones});
    change("set_cloth_settings_from_zones_to_contact", contact, zones);
    for (const MethodCase& of : method_cases()) {
        const auto add = [of, mesh = LoweredSheet::mesh(of.grid, side)](Scene& s) {
            return without_value(s.world.add_cloth(mesh, of.cloth));
        };
        calls.push_back({"add_cloth_" + of.name, add});
    }
    return calls;
}

std::vector<Call> other_calls() {
    std::vector<Call> calls;
    const auto add = [&](const char* name, const std::function<Answer(Scene&)>& make,
                         const ClothSettings& before = {}) {
        calls.push_back({name, make, before});
    };
    const ClothSettings tethered = all_options(Multilevel{});
    const std::vector<std::uint32_t> row = {0, 1, 2, 3, 4, 5, 6};
    const auto set = [](auto change) {
        return [change](Scene& s) {
            WorldSettings settings = s.world.settings();
            change(settings);
            return s.world.set_settings(settings);
        };
    };
    add("set_settings_gusts", set([](WorldSettings& s) { s.wind.gust = 0.5f; }));
    add("set_settings_no_air", set([](WorldSettings& s) { s.wind.air_density = 0; }));
    add("set_settings_budget", set([](WorldSettings& s) { s.budget = 1000; }));
    add("set_importance", [](Scene& s) { return s.world.set_importance(s.cloth, 2); });
    add("set_settings_substeps", set([](WorldSettings& s) { s.substeps = 3; }));
    add("set_settings_threads", set([](WorldSettings& s) { s.threads = 2; }));

    add("measure_cloth", [mesh = LoweredSheet::mesh(false, side)](Scene& s) {
        return without_value(s.world.measure_cloth(mesh));
    });
    add("add_cooked_cloth", [mesh = LoweredSheet::mesh(true, side), tethered](Scene& s) -> Answer {
        auto cooked = CookedCloth::create(mesh, tethered);
        if (!cooked) return cooked.error();
        return without_value(s.world.add_cloth(*cooked, {.translation = {0, 1, 0}}));
    });
    const std::vector<std::byte> saved = [&] {
        const auto cooked = CookedCloth::create(LoweredSheet::mesh(false, side)).value();
        std::vector<std::byte> bytes(cooked.save_size());
        EXPECT_TRUE(cooked.save(bytes));
        return bytes;
    }();
    add("load_cooked_cloth", [saved](Scene&) { return without_value(CookedCloth::load(saved)); });
    add("set_enabled", [](Scene& s) { return s.world.set_enabled(s.cloth, false); });
    ClothSettings sleepy;
    sleepy.sleep_speed = 1e-3f;
    add(
        "wake", [](Scene& s) { return s.world.wake(s.cloth); }, sleepy);
    add("remove_cloth",
        [](Scene& s) { return s.world.cloth(s.cloth) ? s.world.remove_cloth(s.cloth) : Answer(); });
    add("pin_row", [=](Scene& s) { return s.world.pin(s.cloth, row); });
    add(
        "pin_row_tethered", [=](Scene& s) { return s.world.pin(s.cloth, row); }, tethered);
    add("unpin", [](Scene& s) { return s.world.unpin(s.cloth, 0); });
    add(
        "unpin_tethered", [](Scene& s) { return s.world.unpin(s.cloth, 0); }, tethered);
    add("move_pin", [](Scene& s) { return s.world.move_pin(s.cloth, 0, {-0.2f, 0.6f, 0}); });
    add("cloth", [](Scene& s) { return without_value(s.world.cloth(s.cloth)); });
    add("cloth_settings", [](Scene& s) { return without_value(s.world.cloth_settings(s.cloth)); });
    add("cloth_info", [](Scene& s) { return without_value(s.world.cloth_info(s.cloth)); });

    add("add_collider", [](Scene& s) { return without_value(s.world.add_collider({.shape = Plane{}})); });
    const Collider there{.shape = Sphere{{0, 0.4f, 0.05f}, 0.1f}};
    add("move_collider", [=](Scene& s) { return s.world.move_collider(s.collider, there); });
    add("place_collider", [=](Scene& s) { return s.world.place_collider(s.collider, there); });
    add("remove_collider", [](Scene& s) {
        return s.world.collider(s.collider) ? s.world.remove_collider(s.collider) : Answer();
    });
    add("collider", [](Scene& s) { return without_value(s.world.collider(s.collider)); });
    add("add_mesh", [](Scene& s) { return without_value(s.world.add_shape(Tetrahedron{}.mesh())); });
    add("add_hull",
        [](Scene& s) { return without_value(s.world.add_shape(ConvexHull{Tetrahedron{}.vertices})); });
    add("add_height_field", [](Scene& s) {
        const std::array<float, 4> heights{0, 0.1f, 0.2f, 0};
        return without_value(s.world.add_shape(HeightField{2, 2, 0.5f, heights}));
    });
    add("add_distance_field", [](Scene& s) {
        return without_value(s.world.add_shape(DistanceField{Tetrahedron{}.mesh(), 0.05f}));
    });
    add("deform_shape", [](Scene& s) {
        Tetrahedron moved;
        for (Vec3& v : moved.vertices) v.y += 0.01f;
        return s.world.deform_shape(s.shape, moved.vertices);
    });
    add("place_shape", [](Scene& s) {
        return without_value(s.world.add_collider({.shape = PlacedShape{s.shape, {0, 0.2f, 0}}}));
    });
    add("add_body", [](Scene& s) { return without_value(s.world.add_body({})); });
    add("attach", [=](Scene& s) { return s.world.attach(s.body, s.cloth, row); });
    add("detach", [=](Scene& s) { return s.world.detach(s.cloth, row); });
    add("attach_collider", [](Scene& s) { return s.world.attach_collider(s.body, s.collider); });
    add("remove_body",
        [](Scene& s) { return s.world.body_state(s.body) ? s.world.remove_body(s.body) : Answer(); });
    calls.push_back({.name = "first_body",
                     .make = [](Scene& s) { return without_value(s.world.add_body({})); },
                     .bare = true});
    const auto set_map = [](Map map, float value) {
        return [map, values = std::vector<float>(std::size_t{side} * side, value)](Scene& s) {
            return s.world.set_map(s.cloth, map, values);
        };
    };
    ClothSettings contact;
    contact.self_collision = {.method = SelfCollisionMethod::contact};
    const MeshCut cut = [&] {
        std::vector<MeshEdge> across;
        for (std::uint32_t k = 0; k + 1 < side; ++k) across.push_back({2 * side + k, 2 * side + k + 1});
        return cut_mesh(LoweredSheet::mesh(true, side), across).value();
    }();
    // The second time it is of more vertices.
    const auto recut = [=](Scene& s) -> Answer {
        if (s.world.cloth_info(s.cloth)->vertices == cut.mesh.positions.size()) return {};
        return s.world.recut_cloth(s.cloth, cut.mesh, cut.from);
    };
    add("recut_cloth", recut);
    add("recut_cloth_contact", recut, contact);
    calls.push_back({.name = "recut_cloth_bare", .make = recut, .bare = true});
    calls.push_back({.name = "recut_one_of_two", .make = recut, .before = contact, .other = contact});
    add("strained_edges", [](Scene& s) {
        std::array<StrainedEdge, 3> edges;
        return without_value(s.world.strained_edges(s.cloth, -1, edges));
    });
    add("set_map_mass", set_map(Map::mass, 2));
    add("set_map_mass_contact", set_map(Map::mass, 2), contact);
    add("set_map_stiffness", set_map(Map::stiffness, 0.5f));
    add("set_map_pin", set_map(Map::pin, 0), tethered);
    std::vector<float> middle(std::size_t{side} * side, 0);
    middle[middle.size() / 2] = 1;  // with more links than the corner that is let go
    add("set_map_another_pin", [=](Scene& s) { return s.world.set_map(s.cloth, Map::pin, middle); });
    add("set_map_friction", set_map(Map::friction, 0.5f));
    add("set_map_collider_mask", set_map(Map::collider_mask, 1));
    add("set_map_leash", set_map(Map::leash, 0.1f));
    calls.push_back({.name = "first_leash", .make = set_map(Map::leash, 0.1f), .bare = true});
    add("set_map_backstop", set_map(Map::backstop, 0.01f));
    add("move_cloth", [](Scene& s) { return s.world.move_cloth(s.cloth, {.translation = {0, 1, 0}}); });
    add("reset_cloth", [pose = LoweredSheet::mesh(true, side).positions](Scene& s) {
        return s.world.reset_cloth(s.cloth, pose);
    });
    add("resume_cloth", [pose = LoweredSheet::mesh(true, side).positions](Scene& s) {
        return s.world.resume_cloth(s.cloth, pose, pose, pose);
    });
    add("set_frame", [](Scene& s) { return s.world.set_frame(s.cloth, {.translation = {0, 1, 0}}); });
    add("leave_frame", [](Scene& s) { return s.world.leave_frame(s.cloth); });
    add("shift_origin", [](Scene& s) { return s.world.shift_origin({1, 0, 0}); });
    calls.push_back({.name = "first_collider",
                     .make = [](Scene& s) { return without_value(s.world.add_collider({.shape = Plane{}})); },
                     .bare = true});
    calls.push_back({.name = "set_settings_first_air",
                     .make = [](Scene& s) { return s.world.set_settings(Scene::windy()); },
                     .bare = true});
    add("step_apart", [](Scene& s) {
        const Answer begun = s.world.begin_step(frame_time);
        return begun ? s.world.end_step() : begun;
    });
    add("describe", [](Scene& s) { return without_value(s.world.describe()); });
    add("describe_json", [](Scene& s) { return without_value(s.world.describe(DescriptionFormat::json)); });
    add("cloth_report", [](Scene& s) { return without_value(s.world.cloth_report(s.cloth)); });
    add("profile", [](Scene& s) {
        static_cast<void>(s.world.profile());
        return Answer();
    });
    add("start_trace", [](Scene& s) {
        static_cast<void>(s.world.start_trace(100));
        return Answer();
    });
    return calls;
}

const auto name_of = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Cloths, OutOfMemory, testing::ValuesIn(changes_of_cloths()), name_of);
INSTANTIATE_TEST_SUITE_P(World, OutOfMemory, testing::ValuesIn(other_calls()), name_of);

/// A call that no World is needed for, or that only reads one.
void expect_an_answer(const std::function<Answer()>& call) {
    for (const MemoryRunsOut::For how_long : {MemoryRunsOut::For::one, MemoryRunsOut::For::good}) {
        bool ran_out = true;
        for (std::uint64_t allowed = 0; ran_out && allowed < most_allocations;
             allowed = next_tried(allowed)) {
            Answer answer;
            {
                const MemoryRunsOut memory(allowed, how_long);
                answer = call();
                ran_out = memory.happened();
            }
            if (answer) continue;
            EXPECT_TRUE(ran_out) << answer.error().message;
            EXPECT_EQ(answer.error().code, ErrorCode::out_of_memory) << answer.error().message;
        }
        EXPECT_FALSE(ran_out) << "it never ends";
    }
}

TEST(OutOfMemoryWithoutAWorld, CreateAnswers) {
    // oneTBB waits for ever if memory runs out while it sets itself up, once in a process.
    ASSERT_TRUE(World::create({.threads = 2}));
    expect_an_answer([] { return without_value(World::create(Scene::windy())); });
}

TEST(OutOfMemoryWithoutAWorld, MakeSheetAnswers) {
    expect_an_answer([] { return without_value(make_sheet({.rows = 5, .columns = 4})); });
}

TEST(OutOfMemoryWithoutAWorld, CutsAreAnswered) {
    const Mesh mesh = make_sheet({.rows = 5, .columns = 4}).value();
    const std::vector<MeshEdge> edges{{4, 5}, {5, 6}};
    const std::vector<StrainedEdge> strained{{5, 6, 1}};
    expect_an_answer([&] { return without_value(cut_mesh(mesh, edges)); });
    const Blade blade{{0, 1, -1}, {0, -1, -1}, {0, 1, 1}, {0, -1, 1}};
    CutStroke stroke;
    expect_an_answer([&] {
        CutStroke anew = stroke;
        return without_value(edges_along(mesh, mesh.positions, blade, anew));
    });
    expect_an_answer([&] { return without_value(edges_to_tear(mesh, mesh.positions, strained)); });
}

TEST(OutOfMemoryWithoutAWorld, ObjFilesAreAnswered) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "weft_out_of_memory.obj";
    const Mesh mesh = make_sheet({.rows = 5, .columns = 4}).value();
    ASSERT_TRUE(save_obj(file, mesh));
    expect_an_answer([&] { return without_value(load_obj(file)); });
    expect_an_answer([&] { return save_obj(file, mesh); });
    EXPECT_TRUE(load_obj(file)) << "the last one was written whole";
}

TEST(OutOfMemoryWithoutAWorld, ConcaveFacesAreAnswered) {
    const std::filesystem::path file =
        std::filesystem::path(testing::TempDir()) / "weft_out_of_memory_concave.obj";
    std::ofstream(file) << "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 2 0\nv 3 2 0\nv 3 3 0\nv 0 3 0\n"
                           "f 2 3 4 5 6 7 8 1\n";
    expect_an_answer([&] { return without_value(load_obj(file)); });
}

TEST(OutOfMemoryWithoutAWorld, DrawnMeshesAreAnswered) {
    const Scene scene;
    const ClothView& cloth = *scene.world.cloth(scene.cloth);
    std::vector<Vec3> vertices;
    for (const Vec4& p : cloth.positions) vertices.push_back({p.x, p.y, p.z});
    expect_an_answer([&] {
        return without_value(DrawnMesh::bind(cloth, {.vertices = vertices, .triangles = cloth.triangles}));
    });
}

TEST(OutOfMemoryWithoutAWorld, ObjErrorsAreAnswered) {
    const std::filesystem::path file =
        std::filesystem::path(testing::TempDir()) / "weft_out_of_memory_bad.obj";
    std::ofstream(file) << "v 0 0 0\nv 1 0\n";
    for (const MemoryRunsOut::For how_long : {MemoryRunsOut::For::one, MemoryRunsOut::For::good}) {
        bool ran_out = true;
        for (std::uint64_t allowed = 0; ran_out && allowed < most_allocations;
             allowed = next_tried(allowed)) {
            const MemoryRunsOut memory(allowed, how_long);
            const bool read = load_obj(file).ok();
            ran_out = memory.happened();
            ASSERT_FALSE(read);
        }
    }
}

TEST(OutOfMemoryWithoutAWorld, TracesAreWrittenOrRefused) {
    Scene scene;
    static_cast<void>(scene.world.start_trace(100));
    scene.step();
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "weft_out_of_memory.json";
    expect_an_answer([&] { return scene.world.write_trace(file); });
}

/// Error texts need memory themselves.
TEST(OutOfMemoryInErrors, IsAnErrorToo) {
    const Scene made;
    Scene scene;
    const ClothId stale{77, 3};
    ClothSettings bad;
    bad.fabric.warp = -1;
    WorldSettings bad_world;
    bad_world.substeps = 0;
    Mesh no_cloth = LoweredSheet::mesh(false, side);
    no_cloth.triangles[3][1] = 4000;
    const std::filesystem::path nowhere = "/no/such/folder/of/any/name/sheet.obj";
    const std::vector<float> three(3);
    const std::function<bool()> calls[] = {
        [&] { return World::create(bad_world).ok(); },
        [&] { return scene.world.set_settings(bad_world).ok(); },
        [&] { return scene.world.set_cloth_settings(scene.cloth, bad).ok(); },
        [&] { return scene.world.add_cloth(no_cloth).ok(); },
        [&] { return scene.world.measure_cloth(no_cloth).ok(); },
        [&] { return scene.world.add_cloth({}, bad).ok(); },
        [&] { return scene.world.remove_cloth(stale).ok(); },
        [&] { return scene.world.cloth(stale).ok(); },
        [&] { return scene.world.cloth_info({}).ok(); },
        [&] { return scene.world.pin(scene.cloth, 5000).ok(); },
        [&] { return scene.world.pin(stale, 0).ok(); },
        [&] { return scene.world.unpin(scene.cloth, 5000).ok(); },
        [&] { return scene.world.move_pin(scene.cloth, 5, {}).ok(); },
        [&] {
            return scene.world.move_pin(scene.cloth, 0, {1e9f, 0, 0}).ok();
        },
        [&] {
            return scene.world.move_cloth(scene.cloth, {.translation = {1e9f, 0, 0}}).ok();
        },
        [&] {
            return scene.world.set_frame(scene.cloth, {.rotation = {0, 0, 0, 0}}).ok();
        },
        [&] { return scene.world.reset_cloth(scene.cloth, {}).ok(); },
        [&] { return scene.world.cast_ray({}, {}).ok(); },
        [&] {
            return scene.world.closest_point({1e9f, 0, 0}).ok();
        },
        [&] { return scene.world.triangles_in_ball({}, -1, {}).ok(); },
        [&] { return scene.world.set_map(scene.cloth, Map::leash, three).ok(); },
        [&] { return scene.world.set_skin(scene.cloth, {}, {}).ok(); },
        [&] {
            return scene.world.shift_origin({1e9f, 0, 0}).ok();
        },
        [&] {
            return scene.world.add_collider({.shape = Sphere{{}, -1}}).ok();
        },
        [&] { return scene.world.move_collider(scene.collider, {.shape = Plane{}}).ok(); },
        [&] { return scene.world.remove_collider({}).ok(); },
        [&] {
            return scene.world.collider({4, 4}).ok();
        },
        [&] { return make_sheet({.rows = 1}).ok(); },
        [&] { return load_obj(nowhere).ok(); },
        [&] { return save_obj(nowhere, no_cloth).ok(); },
    };
    for (std::size_t i = 0; i < std::size(calls); ++i) {
        for (const MemoryRunsOut::For how_long : {MemoryRunsOut::For::one, MemoryRunsOut::For::good}) {
            bool ran_out = true;
            for (std::uint64_t allowed = 0; ran_out && allowed < most_allocations;
                 allowed = next_tried(allowed)) {
                bool worked = true, thrown = false;
                {
                    const MemoryRunsOut memory(allowed, how_long);
                    try {
                        worked = calls[i]();
                    } catch (...) {
                        thrown = true;
                    }
                    ran_out = memory.happened();
                }
                EXPECT_FALSE(thrown) << "call " << i << " after " << allowed;
                EXPECT_TRUE(thrown || !worked) << "call " << i << " after " << allowed;
            }
        }
    }
    EXPECT_EQ(scene.look(), made.look());
}

TEST(OutOfMemoryOfLevels, ChangesNothing) {
    for (const MemoryRunsOut::For how_long : {MemoryRunsOut::For::one, MemoryRunsOut::For::good}) {
        bool ran_out = true;
        for (std::uint64_t allowed = 0; ran_out && allowed < most_allocations;
             allowed = next_tried(allowed)) {
            World world = World::create({.threads = 1}).value();
            const ClothId fine = world.add_cloth(make_sheet({.rows = 9, .columns = 9}).value()).value();
            const ClothId coarse = world.add_cloth(make_sheet({.rows = 5, .columns = 5}).value()).value();
            const std::uint64_t before = world.state_hash();
            Answer answer;
            {
                const MemoryRunsOut memory(allowed, how_long);
                answer = world.add_level(fine, coarse);
                ran_out = memory.happened();
            }
            if (!answer) {
                EXPECT_EQ(answer.error().code, ErrorCode::out_of_memory);
                EXPECT_EQ(world.state_hash(), before);
                EXPECT_TRUE(world.cloth_settings(coarse)->enabled);
                EXPECT_TRUE(world.add_level(fine, coarse));
            }
            EXPECT_TRUE(world.set_level(fine, 1));
        }
        EXPECT_FALSE(ran_out) << "it never ends";
    }
}

}  // namespace
}  // namespace weft::test
