// A cloth that is cut between steps, as a host sees it: what it keeps, that it comes apart, and that it is
// recorded, saved and refused as all else.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

#include "engine/vector.h"
#include "tests/cloth/contact/crossing_count.h"
#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

constexpr float frame = 1.0f / 60;
constexpr std::uint32_t side = 13;

WorldSettings settings_of(int threads = 1) {
    WorldSettings settings;
    settings.threads = threads;
    settings.wind.velocity = {1, 0, 2};
    return settings;
}

/// Hangs down from its first row.
Mesh hanging_sheet() {
    return must(make_sheet(
        {.rows = side, .columns = side, .origin = {-0.5f, 1, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}}));
}

std::vector<std::uint32_t> first_row() {
    std::vector<std::uint32_t> row(side);
    for (std::uint32_t k = 0; k < side; ++k) row[k] = k;
    return row;
}

/// Along row `row` of the sheet, from its first column to column `to`.
MeshCut cut_along(const Mesh& mesh, std::uint32_t row, std::uint32_t to = side - 1) {
    std::vector<MeshEdge> edges;
    for (std::uint32_t k = 0; k < to; ++k) edges.push_back({row * side + k, row * side + k + 1});
    return must(cut_mesh(mesh, edges));
}

struct Hung {
    explicit Hung(const ClothSettings& settings = {}, int threads = 1, bool is_grid = true)
        : world(must(World::create(settings_of(threads)))), mesh(hanging_sheet()) {
        if (!is_grid) mesh.rows = mesh.columns = 0;
        cloth = must(world.add_cloth(mesh, settings));
        EXPECT_TRUE(world.pin(cloth, first_row()));
        step(10);
    }
    void step(int steps) {
        for (int k = 0; k < steps; ++k) world.step(frame);
    }
    Result<void> recut(const MeshCut& cut) {
        const auto answer = world.recut_cloth(cloth, cut.mesh, cut.from);
        if (answer) mesh = cut.mesh;
        return answer;
    }
    [[nodiscard]] Vector3 at(std::uint32_t vertex) const {
        const ClothView& view = *world.cloth(cloth);
        return xyz(view.positions[view.vertex_to_particle[vertex]]);
    }

    World world;
    Mesh mesh;
    ClothId cloth;
};

struct Case {
    const char* name;
    std::function<void(ClothSettings&)> set = [](ClothSettings&) {};
    std::function<void(Hung&)> prepare = [](Hung&) {};
};

std::vector<float> of_each(float first, float last) {
    std::vector<float> values(std::size_t{side} * side);
    for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = first + (last - first) * static_cast<float>(k) / static_cast<float>(values.size());
    return values;
}

std::vector<Case> cases() {
    const auto add_ball = [](Hung& hung) {  // onto which the wind blows the sheet
        EXPECT_TRUE(hung.world.add_collider({.shape = Sphere{{0, 0.8f, 0.155f}, 0.15f}}));
    };
    const auto give_maps = [](Hung& hung) {
        EXPECT_TRUE(hung.world.set_map(hung.cloth, Map::mass, of_each(0.3f, 3)));
        EXPECT_TRUE(hung.world.set_map(hung.cloth, Map::stiffness, of_each(0.5f, 2)));
        EXPECT_TRUE(hung.world.set_map(hung.cloth, Map::leash, of_each(0.2f, 1)));
        EXPECT_TRUE(hung.world.set_map(hung.cloth, Map::backstop, of_each(0.01f, 0.3f)));
        const std::vector<Vec3> normals(hung.mesh.positions.size(), Vec3{0, 0, 1});
        EXPECT_TRUE(hung.world.set_skin(hung.cloth, hung.mesh.positions, normals));
    };
    const auto with_contact = [](ClothSettings& s) {
        s.self_collision = {.method = SelfCollisionMethod::contact};
    };
    return {
        {.name = "by_default"},
        {.name = "euler", .set = [](ClothSettings& s) { s.time_scheme = TimeScheme::backward_euler; }},
        {.name = "xpbd",
         .set =
             [](ClothSettings& s) {
                 s.method = Xpbd{};
                 s.substeps = 16;
             }},
        {.name = "elements", .set = [](ClothSettings& s) { s.finite_elements.enabled = true; }},
        {.name = "tethers", .set = [](ClothSettings& s) { s.tethers.enabled = true; }},
        {.name = "on_a_ball", .prepare = add_ball},
        {.name = "avoidance",
         .set = [](ClothSettings& s) { s.self_collision = {.method = SelfCollisionMethod::avoidance}; }},
        {.name = "contact", .set = with_contact, .prepare = add_ball},
        {.name = "maps", .prepare = give_maps},
        {.name = "in_a_frame",
         .set = [](ClothSettings& s) { s.frame_inertia = {.linear = 0.5f, .angular = 0.5f}; },
         .prepare =
             [](Hung& h) {
                 EXPECT_TRUE(h.world.set_frame(h.cloth, {.translation = {0, 1, 0}}));
             }},
        {.name = "on_a_body",
         .prepare =
             [](Hung& h) {
                 const BodyId body = must(h.world.add_body({}, {.position = {0, 0, 0}}));
                 EXPECT_TRUE(h.world.attach(body, h.cloth, std::vector<std::uint32_t>{side * side - 1}));
             }},
        {.name = "on_a_budget",
         .prepare =
             [](Hung& h) {
                 WorldSettings settings = h.world.settings();
                 settings.budget = 1000;
                 EXPECT_TRUE(h.world.set_settings(settings));
             }},
    };
}

Hung hung_as(const Case& of, int threads = 1, bool is_grid = true) {
    ClothSettings settings;
    of.set(settings);
    Hung hung(settings, threads, is_grid);
    of.prepare(hung);
    hung.step(5);
    return hung;
}

TEST(RecutCloth, WhereNothingIsCutNothingChanges) {
    for (const Case& of : cases()) {
        SCOPED_TRACE(of.name);
        Hung left = hung_as(of), recut = hung_as(of);
        ASSERT_EQ(left.world.state_hash(), recut.world.state_hash());
        for (int k = 0; k < 8; ++k) {
            ASSERT_TRUE(recut.recut(must(cut_mesh(recut.mesh, {}))));
            ASSERT_EQ(left.world.state_hash(), recut.world.state_hash()) << "after " << k;
            left.step(2);
            recut.step(2);
            ASSERT_EQ(left.world.state_hash(), recut.world.state_hash()) << "two steps after " << k;
        }
        EXPECT_EQ(must(left.world.cloth_settings(left.cloth)).method.index(),
                  must(recut.world.cloth_settings(recut.cloth)).method.index());
    }
}

struct Momentum {
    Vector3 linear = Vector3::Zero();
    double mass = 0;
};

Momentum momentum_of(const ClothView& view) {
    Momentum sum;
    for (std::size_t i = 0; i < view.positions.size(); ++i) {
        if (view.positions[i].w == 0) continue;
        const double m = 1 / static_cast<double>(view.positions[i].w);
        sum.mass += m;
        sum.linear += (m * xyz(view.velocities[i]).cast<double>()).cast<float>();
    }
    return sum;
}

TEST(RecutCloth, KeepsMassPlaceAndMomentum) {
    for (const Case& of : cases()) {
        SCOPED_TRACE(of.name);
        Hung hung = hung_as(of);
        const Momentum before = momentum_of(*hung.world.cloth(hung.cloth));
        std::vector<Vector3> places;
        for (std::uint32_t v = 0; v < side * side; ++v) places.push_back(hung.at(v));
        const float mass = must(hung.world.cloth_info(hung.cloth)).mass;
        const MeshCut cut = cut_along(hung.mesh, 5);
        ASSERT_TRUE(hung.recut(cut));
        const Momentum after = momentum_of(*hung.world.cloth(hung.cloth));
        EXPECT_NEAR(after.mass, before.mass, 1e-5 * before.mass);
        EXPECT_NEAR(must(hung.world.cloth_info(hung.cloth)).mass, mass, 1e-5f * mass);
        EXPECT_LT((after.linear - before.linear).norm(), 1e-5f * static_cast<float>(before.mass));
        for (std::uint32_t v = 0; v < cut.from.size(); ++v)
            EXPECT_LT((hung.at(v) - places[cut.from[v]]).norm(), 5e-3f / side) << "vertex " << v;
    }
}

TEST(RecutCloth, ThePartsComeApart) {
    for (const Case& of : cases()) {
        if (std::string(of.name) == "in_a_frame" || std::string(of.name) == "maps")
            continue;  // held by these
        SCOPED_TRACE(of.name);
        Hung hung = hung_as(of);
        const MeshCut cut = cut_along(hung.mesh, 5);
        ASSERT_TRUE(hung.recut(cut));
        EXPECT_EQ(must(hung.world.cloth_info(hung.cloth)).components, 2u);
        const float left = hung.at(0).y();
        hung.step(30);
        // A free fall of half a second is 1.2 m, less the air's drag.
        EXPECT_LT(hung.at(side * side - 2).y(), -0.3f) << "it fell";
        EXPECT_FLOAT_EQ(hung.at(0).y(), left) << "what was pinned hangs";
        EXPECT_GT(hung.at(3 * side).y(), 0.4f);
        Soup soup;
        soup.add(*hung.world.cloth(hung.cloth));
        if (std::string(of.name) == "contact") {
            EXPECT_EQ(soup.crossings(), 0);
        }
        EXPECT_EQ(hung.world.report().flags, StepFlags::none);
    }
}

// What the cut leaves does not burst: neither the springs' rest, nor the lips that lie on each other.
TEST(RecutCloth, NothingJumps) {
    for (const Case& of : cases()) {
        SCOPED_TRACE(of.name);
        // What Xpbd leaves unsolved is another on a mesh than on a grid.
        const bool is_grid = std::string(of.name) != "xpbd";
        Hung whole = hung_as(of, 1, is_grid), cut = hung_as(of, 1, is_grid);
        ASSERT_TRUE(cut.recut(cut_along(cut.mesh, 5, 4)));
        float farthest = 0;
        for (int k = 0; k < 3; ++k) {
            whole.step(1);
            cut.step(1);
            for (std::uint32_t v = 0; v < side * side; ++v)
                farthest = std::max(farthest, (cut.at(v) - whole.at(v)).norm());
        }
        EXPECT_LT(farthest, 0.02f) << "in three frames, in which what falls free falls 1 cm";
    }
}

TEST(RecutCloth, HasTheSameBytesOnAnyThreads) {
    for (const Case& of : cases()) {
        if (std::string(of.name) == "on_a_budget") continue;  // which is by the clock
        SCOPED_TRACE(of.name);
        std::vector<std::uint64_t> hashes;
        for (const int threads : {1, 2, 7}) {
            Hung hung = hung_as(of, threads);
            ASSERT_TRUE(hung.recut(cut_along(hung.mesh, 5)));
            hung.step(10);
            hashes.push_back(hung.world.state_hash());
        }
        EXPECT_EQ(hashes[0], hashes[1]);
        EXPECT_EQ(hashes[0], hashes[2]);
    }
}

TEST(RecutCloth, PinsTheCopiesOfWhatIsPinned) {
    Hung hung;
    std::vector<MeshEdge> down;
    for (std::uint32_t row = 0; row + 1 < side; ++row) down.push_back({row * side + 6, (row + 1) * side + 6});
    const MeshCut cut = must(cut_mesh(hung.mesh, down));
    ASSERT_EQ(cut.added_particles, side);
    ASSERT_TRUE(hung.recut(cut));
    const ClothView& view = *hung.world.cloth(hung.cloth);
    std::size_t pinned = 0;
    for (std::uint32_t v = 0; v < cut.from.size(); ++v)
        pinned += view.positions[view.vertex_to_particle[v]].w == 0 ? 1 : 0;
    EXPECT_EQ(pinned, side + 1u);
    const Vector3 held = hung.at(6);
    hung.step(20);
    for (std::uint32_t v = 0; v < cut.from.size(); ++v)
        if (cut.from[v] == 6) {
            EXPECT_EQ(hung.at(v), held);
            EXPECT_TRUE(hung.world.move_pin(hung.cloth, v, {0, 1.1f, 0})) << "by its own number";
        }
}

TEST(RecutCloth, IsSavedAndRestored) {
    for (const Case& of : cases()) {
        if (std::string(of.name) == "on_a_budget") continue;
        SCOPED_TRACE(of.name);
        Hung hung = hung_as(of);
        std::vector<std::byte> before(hung.world.save_size());
        ASSERT_TRUE(hung.world.save(before));
        ASSERT_TRUE(hung.recut(cut_along(hung.mesh, 5)));
        hung.step(3);
        const auto refused = hung.world.restore(before);
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().message.find("particles"), std::string::npos) << refused.error().message;

        std::vector<std::byte> saved(hung.world.save_size());
        ASSERT_TRUE(hung.world.save(saved));
        hung.step(5);
        const std::uint64_t hash = hung.world.state_hash();
        ASSERT_TRUE(hung.world.restore(saved));
        hung.step(5);
        EXPECT_EQ(hung.world.state_hash(), hash);
    }
}

TEST(RecutCloth, ASaveOfOtherTrianglesOfAsManyParticlesIsRefused) {
    Hung hung, other;
    ASSERT_TRUE(hung.recut(cut_along(hung.mesh, 5)));
    ASSERT_TRUE(other.recut(cut_along(other.mesh, 4)));
    std::vector<std::byte> saved(hung.world.save_size());
    ASSERT_TRUE(hung.world.save(saved));
    const std::uint64_t hash = other.world.state_hash();
    const auto refused = other.world.restore(saved);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("other triangles"), std::string::npos) << refused.error().message;
    EXPECT_EQ(other.world.state_hash(), hash);
}

TEST(RecutCloth, RefusesByNameAndChangesNothing) {
    Hung hung;
    const MeshCut cut = cut_along(hung.mesh, 5);
    const std::uint64_t hash = hung.world.state_hash();
    const auto expect_says = [&](const Result<void>& answer, const std::string& what) {
        ASSERT_FALSE(answer) << what;
        EXPECT_NE(answer.error().message.find(what), std::string::npos) << answer.error().message;
        EXPECT_EQ(hung.world.state_hash(), hash);
        EXPECT_EQ(must(hung.world.cloth_info(hung.cloth)).vertices, side * side);
    };
    expect_says(hung.world.recut_cloth({}, cut.mesh, cut.from), "ClothId is null");
    expect_says(hung.world.recut_cloth(hung.cloth, cut.mesh, std::span(cut.from).first(3)), "`from` has 3");
    std::vector<std::uint32_t> from = cut.from;
    from[7] = side * side;
    expect_says(hung.world.recut_cloth(hung.cloth, cut.mesh, from), "from[7]: vertex 169 does not exist");
    expect_says(hung.world.recut_cloth(hung.cloth, {}, {}), "no triangles");
    Mesh folded = loose_sheet(2, 3);
    folded.texcoords.clear();
    folded.positions.push_back(folded.positions[1]);
    expect_says(hung.world.recut_cloth(hung.cloth, folded, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6}),
                "vertices 1 and 6 are one particle, but come from vertices 1 and 6");
    ASSERT_TRUE(hung.world.begin_step(frame));
    EXPECT_FALSE(hung.world.recut_cloth(hung.cloth, cut.mesh, cut.from));
    ASSERT_TRUE(hung.world.end_step());
}

// A cloth that others lie on wakes them; contact between cloths goes on.
TEST(RecutCloth, MeetsOtherClothAsBefore) {
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    World world = must(World::create({.threads = 1}));
    const Mesh mesh = must(make_sheet({.rows = 9, .columns = 9}));
    const ClothId lower = must(world.add_cloth(mesh, settings));
    Mesh above = mesh;
    for (Vec3& p : above.positions) p.y += 0.05f;
    const ClothId upper = must(world.add_cloth(above, settings));
    const std::vector<std::uint32_t> corners = {0, 8, 72, 80};
    ASSERT_TRUE(world.pin(lower, corners));
    for (int k = 0; k < 20; ++k) world.step(frame);
    std::vector<MeshEdge> edges;
    for (std::uint32_t k = 2; k < 6; ++k) edges.push_back({9 * 4 + k, 9 * 4 + k + 1});
    const MeshCut cut = must(cut_mesh(mesh, edges));
    ASSERT_TRUE(world.recut_cloth(lower, cut.mesh, cut.from));
    for (int k = 0; k < 60; ++k) {
        world.step(frame);
        ASSERT_EQ(world.report().crossings, 0u) << "step " << k;
    }
    Soup soup;
    soup.add(*world.cloth(lower));
    soup.add(*world.cloth(upper));
    EXPECT_EQ(soup.crossings(), 0);
    EXPECT_GT(world.cloth(upper)->bounds.lower.y, -1.0f) << "it lies on the cut one still";
}

TEST(StrainedEdges, AreThoseThatAreLongest) {
    World world = must(World::create({.gravity = {0, 0, 0}, .threads = 1}));
    const Mesh mesh = must(make_sheet({.rows = 5, .columns = 5}));
    const ClothId cloth = must(world.add_cloth(mesh));
    std::array<StrainedEdge, 4> edges;
    EXPECT_EQ(must(world.strained_edges(cloth, 0.01f, edges)), 0u);
    ASSERT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{12, 13}));
    ASSERT_TRUE(world.move_pin(cloth, 13, {0.3f, 0, 0}));  // of 0.25
    world.step(1.0f / 240);
    const std::uint32_t count = must(world.strained_edges(cloth, 0.01f, edges));
    ASSERT_GE(count, 1u);
    EXPECT_EQ(edges[0].a, 12u);
    EXPECT_EQ(edges[0].b, 13u);
    EXPECT_NEAR(edges[0].strain, 0.2f, 1e-3f);
    for (std::uint32_t k = 1; k < count; ++k) EXPECT_LE(edges[k].strain, edges[k - 1].strain);
    EXPECT_EQ(must(world.strained_edges(cloth, 0.01f, std::span(edges).first(1))), 1u);
    EXPECT_EQ(must(world.strained_edges(cloth, 0.5f, edges)), 0u);
    EXPECT_FALSE(world.strained_edges(cloth, NAN, edges));
    EXPECT_FALSE(world.strained_edges({}, 0, edges));
}

// A sheet whose ends are drawn apart tears in two, and no edge is left far beyond what it stands.
TEST(StrainedEdges, TearAClothInTwo) {
    constexpr float stands = 0.15f;
    World world = must(World::create({.gravity = {0, 0, 0}, .threads = 1}));
    Mesh mesh = must(make_sheet({.rows = 9, .columns = 13}));
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    const ClothId cloth = must(world.add_cloth(mesh, settings));
    std::vector<std::uint32_t> ends;
    for (std::uint32_t row = 0; row < 9; ++row) ends.insert(ends.end(), {row * 13, row * 13 + 12});
    ASSERT_TRUE(world.pin(cloth, ends));
    std::vector<Vec3> positions;
    std::array<StrainedEdge, 4> strained;
    int cuts = 0;
    for (int k = 0; k < 90; ++k) {
        for (const std::uint32_t v : ends) {
            Vec3 to = mesh.positions[v];
            to.x *= 1 + 0.005f * static_cast<float>(k);
            ASSERT_TRUE(world.move_pin(cloth, v, to));
        }
        world.step(frame);
        const std::uint32_t count = must(world.strained_edges(cloth, stands, strained));
        if (count == 0) continue;
        positions.resize(mesh.positions.size());
        VertexStreams streams;
        const ClothView& view = *world.cloth(cloth);
        for (std::size_t v = 0; v < positions.size(); ++v)
            positions[v] = to_vec3(xyz(view.positions[view.vertex_to_particle[v]]));
        const MeshCut cut =
            must(cut_mesh(mesh, must(edges_to_tear(mesh, positions, std::span(strained).first(count)))));
        if (cut.added_particles == 0) continue;
        ++cuts;
        ASSERT_TRUE(world.recut_cloth(cloth, cut.mesh, cut.from));
        mesh = cut.mesh;
    }
    EXPECT_GE(cuts, 3) << "a tear runs";
    EXPECT_GE(must(world.cloth_info(cloth)).components, 2u);
    EXPECT_EQ(must(world.strained_edges(cloth, 2 * stands, strained)), 0u);
    EXPECT_EQ(world.report().crossings, 0u);
}

}  // namespace
}  // namespace weft::test
