// Bonds of drawn meshes as bytes, and as a shader reads them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "engine/state_hash.h"
#include "engine/vector.h"
#include "tests/cloth/mesh/drawn_cage.h"
#include "weft/drawn_mesh.h"
#include "weft/world.h"

namespace weft {
namespace {

using namespace test;

/// A surface with a height and texture coordinates over the bent sheet.
DrawnMesh bound(const Cage& cage, float rounding = 0.5f) {
    const Fine fine(13, 0.01f, true);
    std::vector<Vec3> vertices;
    for (const Vec3& p : fine.vertices) {
        const auto [at, n] = bent(p.x, p.y);
        vertices.push_back(to_vec3(at + 0.01f * std::sin(9 * p.x) * n));
    }
    auto mesh = DrawnMesh::bind(
        cage.view, {.vertices = vertices, .triangles = fine.triangles, .texcoords = fine.texcoords},
        {.rounding = rounding});
    EXPECT_TRUE(mesh.ok());
    return std::move(mesh).value();
}

std::vector<std::byte> saved(const DrawnMesh& mesh) {
    std::vector<std::byte> bytes(mesh.save_size());
    EXPECT_TRUE(mesh.save(bytes).ok());
    return bytes;
}

/// Makes the checksum of altered bytes right again.
void seal(std::vector<std::byte>& bytes) {
    std::fill_n(bytes.begin() + 40, 8, std::byte{});
    std::array<std::byte, 64> head;
    std::memcpy(head.data(), bytes.data(), head.size());
    StateHash hash;
    hash.add(std::span(&head, 1));
    hash.add(std::span<const std::byte>(bytes).subspan(64));
    const std::uint64_t value = hash.value();
    std::memcpy(bytes.data() + 40, &value, 8);
}

template <class T>
void overwrite(std::vector<std::byte>& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
    seal(bytes);
}

const auto wavy = [](float u, float v) {
    return PointAndNormal{{u, 0.1f * std::sin(5 * u + 3 * v), v}, Vector3(0.3f * u, 1, -0.2f).normalized()};
};

TEST(DrawnMeshFile, AReadMeshDrawsTheSameBytes) {
    const Cage cage(6, bent), moved(6, wavy);
    const DrawnMesh mesh = bound(cage, 0.3f);
    const auto again = DrawnMesh::load(saved(mesh), moved.view);  // in another pose
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ(again->rounding(), 0.3f);
    EXPECT_EQ(saved(*again), saved(mesh));
    Drawn drawn(mesh.size()), drawn_again(again->size());
    mesh.update(moved.view, drawn.spans());
    again->update(moved.view, drawn_again.spans());
    for (std::size_t v = 0; v < mesh.size(); ++v) {
        EXPECT_EQ(load(drawn.positions[v]), load(drawn_again.positions[v]));
        EXPECT_EQ(load(drawn.normals[v]), load(drawn_again.normals[v]));
        EXPECT_EQ(load(drawn.tangents[v]), load(drawn_again.tangents[v]));
    }
}

TEST(DrawnMeshFile, IsReadForAClothOfAnotherWorld) {
    const auto sheet = make_sheet({.rows = 12, .columns = 9});
    std::vector<std::byte> bytes;
    for (int run = 0; run < 2; ++run) {
        auto world = World::create({.threads = 1});
        ASSERT_TRUE(world->add_cloth(*make_sheet({.rows = 3, .columns = 3})).ok());
        const auto cloth = world->add_cloth(*sheet);
        if (run == 0) {
            const auto mesh = DrawnMesh::bind(*world->cloth(*cloth), {.vertices = sheet->positions});
            bytes = saved(*mesh);
        }
        EXPECT_TRUE(DrawnMesh::load(bytes, *world->cloth(*cloth)).ok());
    }
}

TEST(DrawnMeshFile, ErrorsNameWhatIsWrong) {
    const Cage cage(6, bent), finer(7, bent);
    const DrawnMesh mesh = bound(cage);
    const std::vector<std::byte> right = saved(mesh);
    const auto refusal = [&](const std::vector<std::byte>& bytes, const ClothView& cloth) {
        const auto loaded = DrawnMesh::load(bytes, cloth);
        return loaded.ok() ? std::string() : loaded.error().message;
    };
    const auto is_refused = [&](std::size_t at, auto value, const char* why) {
        std::vector<std::byte> bytes = right;
        overwrite(bytes, at, value);
        const std::string message = refusal(bytes, cage.view);
        EXPECT_NE(message.find(why), std::string::npos) << at << ": " << message;
    };
    EXPECT_EQ(refusal(right, cage.view), "");
    EXPECT_NE(refusal(right, finer.view)
                  .find("is bound to a cloth of 49 particles and 72 triangles; this one has 64 and 98"),
              std::string::npos);
    Cage turned(6, bent);
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    EXPECT_NE(refusal(right, turned.view).find("other triangles"), std::string::npos);
    for (const std::size_t size : {std::size_t{0}, std::size_t{63}, right.size() - 1, right.size() - 64})
        EXPECT_NE(refusal({right.begin(), right.begin() + static_cast<std::ptrdiff_t>(size)}, cage.view), "");
    std::vector<std::byte> damaged = right;
    damaged[1000] ^= std::byte{1};
    EXPECT_NE(refusal(damaged, cage.view).find("checksum"), std::string::npos);
    is_refused(0, 'X', "WEFTDRAW");
    is_refused(8, 7u, "has version 7; this library reads version 1");
    is_refused(20, 1.5f, "not whole");                     // the rounding
    is_refused(64 + 3 * 64, 49u, "not whole");             // a particle that the cloth does not have
    is_refused(64 + 12, std::nanf(""), "not whole");       // a barycentric coordinate
    is_refused(64 + 20, HUGE_VALF, "not whole");           // an offset
    is_refused(64 + 64 + 32, std::nanf(""), "not whole");  // a normal
    is_refused(64 + 52, 0.5f, "not whole");                // a handedness
    std::vector<std::byte> short_one(right.size() - 1);
    const auto saving = mesh.save(short_one);
    ASSERT_FALSE(saving.ok());
    EXPECT_NE(saving.error().message.find(std::to_string(right.size())), std::string::npos);
}

/// The formula of weft/drawn_mesh.h, as a vertex shader has it.
struct Shaded {
    Vector3 position, normal, tangent;

    Shaded(const DrawnBond& bond, const ClothView& cloth, float rounding) {
        const auto& [i, j, k] = bond.particles;
        const Vector3 x0 = xyz(cloth.positions[i]), x1 = xyz(cloth.positions[j]),
                      x2 = xyz(cloth.positions[k]);
        const Vector3 n0 = xyz(cloth.normals[i]), n1 = xyz(cloth.normals[j]), n2 = xyz(cloth.normals[k]);
        const float w0 = 1 - bond.second - bond.third, w1 = bond.second, w2 = bond.third;
        const Vector3 flat = w0 * x0 + w1 * x1 + w2 * x2;
        const Vector3 rise =
            w0 * (x0 - flat).dot(n0) * n0 + w1 * (x1 - flat).dot(n1) * n1 + w2 * (x2 - flat).dot(n2) * n2;
        const Vector3 e = x1 - x0, f = x2 - x0;
        const Vector3 out = (w0 * n0 + w1 * n1 + w2 * n2).normalized();
        const Vector3 along = (e - e.dot(out) * out).normalized();
        const Vector3 across = out.cross(along);
        const auto turned = [&](const std::array<float, 3>& v) {
            return Vector3(v[0] * along + v[1] * across + v[2] * out);
        };
        position = flat + rounding * rise + turned(bond.offset);
        normal = turned(bond.normal);
        const Vector3 way = bond.tangent[0] * e + bond.tangent[1] * f;
        tangent = (way - way.dot(normal) * normal).normalized();
    }
};

TEST(DrawnMeshBonds, TheFormulaIsWhatUpdateDoes) {
    const Cage cage(6, bent), moved(6, wavy);
    for (const float rounding : {0.0f, 0.5f, 1.0f}) {
        const DrawnMesh mesh = bound(cage, rounding);
        ASSERT_EQ(mesh.bonds().size(), mesh.size());
        Drawn drawn(mesh.size());
        mesh.update(moved.view, drawn.spans());
        for (std::size_t v = 0; v < mesh.size(); ++v) {
            const Shaded shaded(mesh.bonds()[v], moved.view, mesh.rounding());
            EXPECT_LT((shaded.position - xyz(drawn.positions[v])).norm(), 1e-6f);
            EXPECT_LT((shaded.normal - xyz(drawn.normals[v])).norm(), 1e-5f);
            EXPECT_LT((shaded.tangent - xyz(drawn.tangents[v])).norm(), 1e-5f);
            EXPECT_EQ(mesh.bonds()[v].handedness, drawn.tangents[v].w);
        }
    }
}

}  // namespace
}  // namespace weft
