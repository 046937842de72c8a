// What a host sees of its cloths: World::cloth() and write_vertices().

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/platform.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft::test::seen {
namespace {

World serial_world() {
    WorldSettings settings;
    settings.threads = 1;
    return World::create(settings).value();
}

/// A tube with a seam, whose vertices are not the particles' numbers, held at one end.
struct Scene {
    Scene() : mesh(tube(12, 16)), world(serial_world()), cloth(world.add_cloth(mesh).value()) {
        std::vector<std::uint32_t> end;
        for (std::uint32_t v = 0; v <= 16; ++v) end.push_back(v);
        EXPECT_TRUE(world.pin(cloth, end));
    }
    void steps(int count) {
        for (int k = 0; k < count; ++k) world.step(h);
    }
    [[nodiscard]] std::size_t vertices() const { return mesh.positions.size(); }

    Mesh mesh;
    World world;
    ClothId cloth;
};

constexpr std::uint32_t untouched = 0x5eaf00d;

/// One array of structs, with something in between that is to stay.
struct Vertex {
    std::array<float, 3> position{};
    std::uint32_t mark = untouched;
    std::array<float, 3> normal{};
    std::array<float, 4> tangent{};
    std::array<float, 2> texcoord{};
    std::array<float, 3> previous_position{}, previous_normal{};

    friend bool operator==(const Vertex&, const Vertex&) = default;
};
struct Vertices {
    explicit Vertices(std::size_t count) : all(count) {}

    [[nodiscard]] VertexStreams streams() {
        const auto stream = [&](std::size_t offset) {
            return VertexStream{std::as_writable_bytes(std::span(all)).subspan(offset), sizeof(Vertex)};
        };
        return {.positions = stream(offsetof(Vertex, position)),
                .previous_positions = stream(offsetof(Vertex, previous_position)),
                .normals = stream(offsetof(Vertex, normal)),
                .previous_normals = stream(offsetof(Vertex, previous_normal)),
                .tangents = stream(offsetof(Vertex, tangent)),
                .texcoords = stream(offsetof(Vertex, texcoord))};
    }
    static Vertices of(const Scene& scene) {
        Vertices vertices(scene.vertices());
        const auto written = scene.world.write_vertices(scene.cloth, vertices.streams());
        EXPECT_TRUE(written);
        return vertices;
    }

    std::vector<Vertex> all;
};

template <class A, class B>
float dot(const A& a, const B& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

TEST(WriteVertices, IsTheViewByTheMeshsVertices) {
    Scene scene;
    scene.steps(5);
    const Vertices written = Vertices::of(scene);
    const ClothView& view = *scene.world.cloth(scene.cloth);
    ASSERT_EQ(view.texcoords.size(), scene.vertices());
    for (std::uint32_t v = 0; v < scene.vertices(); ++v) {
        const std::uint32_t i = view.vertex_to_particle[v];
        const Vertex& vertex = written.all[v];
        const Vec4 &p = view.positions[i], &q = view.previous_positions[i], &n = view.normals[i];
        EXPECT_EQ(vertex.position, (std::array{p.x, p.y, p.z}));
        EXPECT_EQ(vertex.previous_position, (std::array{q.x, q.y, q.z}));
        EXPECT_EQ(vertex.normal, (std::array{n.x, n.y, n.z}));
        EXPECT_EQ(vertex.texcoord, (std::array{scene.mesh.texcoords[v].x, scene.mesh.texcoords[v].y}));
        EXPECT_EQ(view.texcoords[v].x, scene.mesh.texcoords[v].x);
        EXPECT_EQ(vertex.mark, untouched);
    }
}

TEST(WriteVertices, TangentsPointWhereTheFirstTextureCoordinateGrows) {
    // Round a tube by u: at (cos a, y, sin a) along (-sin a, 0, cos a), at the seam's two vertices alike.
    Scene scene;
    const Vertices written = Vertices::of(scene);
    for (const Vertex& vertex : written.all) {
        const auto& [x, y, z] = vertex.position;
        const std::array around{-z, 0.0f, x};
        EXPECT_NEAR(dot(vertex.tangent, vertex.tangent), 1, 1e-5f);
        EXPECT_NEAR(dot(vertex.tangent, vertex.normal), 0, 1e-5f);
        // A seam's vertex knows only one side of itself, which lies half a cell's turn aside.
        EXPECT_GT(dot(vertex.tangent, around), 0.97f);
        const float up = vertex.normal[2] * vertex.tangent[0] - vertex.normal[0] * vertex.tangent[2];
        EXPECT_EQ(vertex.tangent[3], up > 0 ? 1 : -1) << "v grows upwards";
    }
}

TEST(WriteVertices, TangentsAtASplitVertexAreThoseOfItsOwnPanel) {
    // Two squares side by side, whose textures lie across each other.
    Mesh mesh;
    for (const float x : {0.0f, 0.1f})
        for (const float left : {0.0f, 0.1f})
            for (const float z : {0.0f, 0.1f}) mesh.positions.push_back({x + left, 0, z});
    for (const std::uint32_t first : {0u, 4u}) {
        mesh.triangles.push_back({first, first + 1, first + 3});
        mesh.triangles.push_back({first, first + 3, first + 2});
    }
    for (std::uint32_t v = 0; v < 8; ++v) {
        const Vec3& p = mesh.positions[v];
        mesh.texcoords.push_back(v < 4 ? Vec2{p.x, -p.z} : Vec2{p.z, p.x});
    }
    World world = serial_world();
    const ClothId cloth = world.add_cloth(mesh).value();
    EXPECT_EQ(world.cloth_info(cloth)->particles, 6u);
    std::array<std::array<float, 4>, 8> tangents{};
    ASSERT_TRUE(world.write_vertices(cloth, {.tangents = {std::as_writable_bytes(std::span(tangents))}}));
    for (std::size_t v = 0; v < 8; ++v) {
        EXPECT_NEAR(tangents[v][v < 4 ? 0 : 2], 1, 1e-5f) << v;
        EXPECT_EQ(tangents[v][3], 1) << v;
    }
}

TEST(WriteVertices, AMirroredTextureHasTheOtherHandedness) {
    Mesh mesh = make_sheet({.rows = 4, .columns = 5}).value();
    std::array<std::vector<std::array<float, 4>>, 2> tangents;
    for (auto& of_sheet : tangents) {
        of_sheet.resize(20);
        World world = serial_world();
        const ClothId cloth = world.add_cloth(mesh).value();
        ASSERT_TRUE(world.write_vertices(cloth, {.tangents = {std::as_writable_bytes(std::span(of_sheet))}}));
        for (Vec2& at : mesh.texcoords) at.y = -at.y;
    }
    for (std::size_t v = 0; v < 20; ++v) {
        EXPECT_NEAR(tangents[0][v][0], 1, 1e-6f);
        EXPECT_NEAR(tangents[1][v][0], 1, 1e-6f);
        EXPECT_EQ(tangents[0][v][3], -tangents[1][v][3]);
    }
}

TEST(WriteVertices, PreviousNormalsAreThoseOfTheStepBefore) {
    for (const bool grid : {false, true}) {
        Scene scene;
        if (grid) {
            scene.mesh = make_sheet({.rows = 14, .columns = 9}).value();
            scene.cloth = scene.world.add_cloth(scene.mesh).value();
            ASSERT_TRUE(scene.world.pin(scene.cloth, std::vector<std::uint32_t>{0, 8, 60}));
        }
        scene.steps(8);
        const Vertices before = Vertices::of(scene);
        const Vec3& corner = scene.mesh.positions[0];
        ASSERT_TRUE(scene.world.move_pin(scene.cloth, 0, {corner.x, corner.y + 0.05f, corner.z}));
        scene.steps(1);
        const Vertices after = Vertices::of(scene);
        float most = 0;
        for (std::size_t v = 0; v < scene.vertices(); ++v) {
            EXPECT_EQ(after.all[v].previous_position, before.all[v].position);
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(after.all[v].previous_normal[k], before.all[v].normal[k], 2e-5f) << v;
                most = std::max(most, std::abs(after.all[v].normal[k] - before.all[v].normal[k]));
            }
        }
        EXPECT_GT(most, 1e-3f) << "they turn";
    }
}

TEST(WriteVertices, VertexTrianglesAreTheMeshs) {
    Scene scene;
    const ClothView& view = *scene.world.cloth(scene.cloth);
    EXPECT_EQ(std::vector(view.vertex_triangles.begin(), view.vertex_triangles.end()), scene.mesh.triangles);
    for (std::size_t t = 0; t < view.triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(view.vertex_to_particle[view.vertex_triangles[t][c]], view.triangles[t][c]);
    const Mesh sheet = make_sheet({.rows = 4, .columns = 5}).value();
    const ClothView& of_sheet = *scene.world.cloth(scene.world.add_cloth(sheet).value());
    EXPECT_EQ(of_sheet.vertex_triangles.data(), of_sheet.triangles.data()) << "no memory for the same twice";
    EXPECT_EQ(of_sheet.vertex_triangles.size(), sheet.triangles.size());
    Mesh bare = scene.mesh;
    bare.texcoords.clear();
    const ClothView& without = *scene.world.cloth(scene.world.add_cloth(bare).value());
    EXPECT_TRUE(without.texcoords.empty());
    EXPECT_TRUE(without.vertex_triangles.empty());
}

#ifndef WEFT_WITHOUT_THREADS
TEST(WriteVertices, PartsOfThreadsAreTheWhole) {
    Scene scene;
    scene.steps(3);
    const Vertices whole = Vertices::of(scene);
    Vertices parts(scene.vertices());
    std::vector<std::thread> threads;
    for (std::size_t first = 0; first < scene.vertices(); first += 50)
        threads.emplace_back(
            [&, first] { EXPECT_TRUE(scene.world.write_vertices(scene.cloth, parts.streams(), first, 50)); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(parts.all, whole.all);
    Vertices some(scene.vertices());
    ASSERT_TRUE(scene.world.write_vertices(scene.cloth, some.streams(), 7, 2));
    for (std::size_t v = 0; v < scene.vertices(); ++v)
        EXPECT_EQ(some.all[v], v == 7 || v == 8 ? whole.all[v] : Vertex()) << v;
    ASSERT_TRUE(scene.world.write_vertices(scene.cloth, some.streams(), SIZE_MAX));
}

TEST(WriteVertices, ShowsTheLastStepWhileTheNextIsTaken) {
    Scene scene;
    scene.steps(3);
    const Vertices before = Vertices::of(scene);
    ASSERT_TRUE(scene.world.begin_step(h));
    std::thread worker([&] { EXPECT_TRUE(scene.world.work()); });
    EXPECT_EQ(Vertices::of(scene).all, before.all);
    worker.join();
    EXPECT_EQ(Vertices::of(scene).all, before.all);
    ASSERT_TRUE(scene.world.end_step());
    EXPECT_NE(Vertices::of(scene).all, before.all);
}
#endif

TEST(WriteVertices, RefusesWhatIsTooShortAndWritesNothing) {
    Scene scene;
    const std::size_t n = scene.vertices();
    std::vector<float> room(4 * n, -7.0f);
    const auto bytes = [&](std::size_t count) {
        return std::as_writable_bytes(std::span(room)).first(count);
    };
    const auto message = [&](const VertexStreams& to) {
        const auto written = scene.world.write_vertices(scene.cloth, to);
        return written ? std::string("written") : written.error().message;
    };
    EXPECT_EQ(message({.positions = {bytes(12 * n)}}), "written");
    EXPECT_EQ(message({.positions = {bytes(16 * n - 4), 16}}), "written") << "the last has no gap behind it";
    std::ranges::fill(room, -7.0f);
    EXPECT_NE(message({.positions = {bytes(12 * n - 1)}}).find("VertexStreams::positions"),
              std::string::npos);
    EXPECT_NE(message({.positions = {bytes(12 * n)}, .normals = {bytes(16 * n - 5), 16}}).find("normals"),
              std::string::npos);
    EXPECT_NE(message({.tangents = {bytes(16 * n), 12}}).find("stride of 12 bytes; a value takes 16"),
              std::string::npos);
    EXPECT_NE(message({.positions = {bytes(1)}}), "written");
    EXPECT_EQ(room, std::vector<float>(4 * n, -7.0f));

    Mesh bare = scene.mesh;
    bare.texcoords.clear();
    const ClothId without = scene.world.add_cloth(bare).value();
    EXPECT_TRUE(scene.world.write_vertices(without, {.normals = {bytes(12 * n)}}));
    EXPECT_FALSE(scene.world.write_vertices(without, {.tangents = {bytes(16 * n)}}));
    EXPECT_FALSE(scene.world.write_vertices(without, {.texcoords = {bytes(8 * n)}}));
    ASSERT_TRUE(scene.world.remove_cloth(scene.cloth));
    EXPECT_EQ(scene.world.write_vertices(scene.cloth, {}).error().code, ErrorCode::stale_id);
}

TEST(WriteVertices, OfACookedClothReadBackFromBytesIsThatOfItsMesh) {
    Scene scene;
    const Vertices of_mesh = Vertices::of(scene);
    const CookedCloth cooked = CookedCloth::create(scene.mesh).value();
    std::vector<std::byte> bytes(cooked.save_size());
    ASSERT_TRUE(cooked.save(bytes));
    scene.cloth = scene.world.add_cloth(CookedCloth::load(bytes).value()).value();
    EXPECT_EQ(Vertices::of(scene).all, of_mesh.all);
}

/// Where a view's buffers are; a step may swap the first two.
std::vector<const void*> places(const ClothView& view) {
    std::vector<const void*> all{view.positions.data(),  view.previous_positions.data(),
                                 view.velocities.data(), view.normals.data(),
                                 view.triangles.data(),  view.vertex_to_particle.data(),
                                 view.texcoords.data(),  view.vertex_triangles.data()};
    std::sort(all.begin(), all.begin() + 2, std::less<>());
    return all;
}

TEST(View, MemoryIsThereWhateverIsCalled) {
    Scene scene;
    const ClothView kept = *scene.world.cloth(scene.cloth);
    const auto expect_same = [&](const char* call) {
        EXPECT_EQ(places(*scene.world.cloth(scene.cloth)), places(kept)) << call;
        double sum = 0;  // under the address sanitizer: all of it can be read
        for (const Vec4& p : kept.positions) sum += static_cast<double>(p.x);
        for (const Vec4& p : kept.normals) sum += static_cast<double>(p.x);
        for (const Triangle& t : kept.vertex_triangles) sum += t[2];
        EXPECT_TRUE(std::isfinite(sum)) << call;
    };
    scene.steps(2);
    expect_same("step");
    ASSERT_TRUE(scene.world.pin(scene.cloth, 100));
    ASSERT_TRUE(scene.world.unpin(scene.cloth, 3));
    expect_same("pin, unpin");
    for (const Method& method : std::vector<Method>{Jacobi{}, Xpbd{}, Fibres{}, Multilevel{}}) {
        ClothSettings settings;
        settings.method = method;
        settings.fabric.areal_density = 0.3f;
        settings.self_collision.method = std::holds_alternative<Multilevel>(method)
                                             ? SelfCollisionMethod::contact
                                             : SelfCollisionMethod::off;
        ASSERT_TRUE(scene.world.set_cloth_settings(scene.cloth, settings));
        scene.steps(1);
        expect_same("set_cloth_settings");
    }
    ASSERT_TRUE(scene.world.set_map(scene.cloth, Map::stiffness, std::vector<float>(scene.vertices(), 0.5f)));
    ASSERT_TRUE(scene.world.set_map(scene.cloth, Map::mass, std::vector<float>(scene.vertices(), 2.0f)));
    expect_same("set_map");
    ASSERT_TRUE(scene.world.add_collider({.shape = Sphere{{0, 0, 0}, 0.5f}}));
    ASSERT_TRUE(scene.world.add_body({}));
    ASSERT_TRUE(scene.world.move_cloth(scene.cloth, {.translation = {1, 0, 0}}));
    ASSERT_TRUE(scene.world.shift_origin({1, 0, 0}));
    expect_same("move_cloth, shift_origin");
    std::vector<std::byte> saved(scene.world.save_size());
    ASSERT_TRUE(scene.world.save(saved));
    scene.steps(1);
    ASSERT_TRUE(scene.world.restore(saved));
    expect_same("restore");
    for (int k = 0; k < 40; ++k) ASSERT_TRUE(scene.world.add_cloth(scene.mesh));
    expect_same("add_cloth");
    scene.world = World(std::move(scene.world));
    World moved(std::move(scene.world));
    scene.world = std::move(moved);
    expect_same("a World that moves");
    ASSERT_TRUE(scene.world.begin_step(h));
    const ClothView shown = *scene.world.cloth(scene.cloth);
    EXPECT_NE(shown.positions.data(), kept.positions.data());
    EXPECT_EQ(shown.texcoords.data(), kept.texcoords.data());
    ASSERT_TRUE(scene.world.end_step());
    expect_same("end_step");
    EXPECT_EQ(shown.positions.size(), kept.positions.size());
    EXPECT_TRUE(std::isfinite(shown.positions.back().x)) << "both sets stay";
}

TEST(View, OfAClothThatIsRemovedIsEmpty) {
    Scene scene;
    const ClothId other = scene.world.add_cloth(scene.mesh).value();
    const ClothView& view = *scene.world.cloth(scene.cloth);
    const ClothView& of_other = *scene.world.cloth(other);
    ASSERT_EQ(view.positions.size(), 12u * 16);
    ASSERT_TRUE(scene.world.remove_cloth(scene.cloth));
    EXPECT_EQ(view.positions.size(), 0u);
    EXPECT_EQ(view.vertex_to_particle.size(), 0u);
    EXPECT_EQ(of_other.positions.size(), 12u * 16);
    for (int round = 0; round < 3; ++round) {  // places of ids that are taken again
        const ClothId again = scene.world.add_cloth(scene.mesh).value();
        EXPECT_EQ(scene.world.cloth(again)->positions.size(), 12u * 16);
        EXPECT_NE(&*scene.world.cloth(again), &of_other);
        ASSERT_TRUE(scene.world.remove_cloth(again));
    }
    EXPECT_EQ(of_other.positions.size(), 12u * 16);
    World moved(std::move(scene.world));
    EXPECT_EQ(&*moved.cloth(other), &of_other);
}

}  // namespace
}  // namespace weft::test::seen
