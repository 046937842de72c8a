// A fine mesh that is drawn over a coarse one.

#include "weft/drawn_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "engine/vector.h"
#include "tests/cloth/mesh/drawn_cage.h"
#include "weft/world.h"

namespace weft {
namespace {

using namespace test;

TEST(DrawnMesh, IsWhereItWasBound) {
    const Cage cage(6, bent);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(0, 1), above(-0.03f, 0.03f);
    std::vector<Vec3> vertices;
    for (int i = 0; i < 500; ++i) {
        const auto [p, n] = bent(place(random), place(random));
        vertices.push_back(to_vec3(p + above(random) * n));
    }
    const auto mesh = DrawnMesh::bind(cage.view, {.vertices = vertices});
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    ASSERT_EQ(mesh->size(), vertices.size());
    Drawn drawn(mesh->size());
    mesh->update(cage.view, drawn.spans());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        EXPECT_LT((xyz(drawn.positions[v]) - to_vector(vertices[v])).norm(), 1e-6f);
        EXPECT_EQ(drawn.positions[v].w, 1);
    }
}

TEST(DrawnMesh, StaysFlatWithTheCage) {
    const Cage cage(6, flat_place), wider(6, [](float u, float v) {
        return PointAndNormal{{2 * u, v, 0}, {0, 0, 1}};
    });
    const Fine fine(31, 0.02f);
    const auto mesh = DrawnMesh::bind(cage.view, fine.surface());
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    Drawn drawn(mesh->size());
    mesh->update(wider.view, drawn.spans());
    for (std::size_t v = 0; v < mesh->size(); ++v) {
        const Vec3& start = fine.vertices[v];
        EXPECT_LT((xyz(drawn.positions[v]) - Vector3(2 * start.x, start.y, 0.02f)).norm(), 2e-6f);
        EXPECT_LT((xyz(drawn.normals[v]) - Vector3::UnitZ()).norm(), 1e-6f);
        EXPECT_LT((xyz(drawn.tangents[v]) - Vector3::UnitX()).norm(), 1e-6f);
        EXPECT_EQ(drawn.tangents[v].w, 1);
    }
}

TEST(DrawnMesh, GoesAlongWithAnyRigidMotion) {
    const Cage cage(5, bent);
    const Eigen::Quaternionf turn(Eigen::AngleAxisf(1.1f, Vector3(1, -2, 0.5f).normalized()));
    const Vector3 way(3, -1, 2);
    const Cage moved(5, [&](float u, float v) {
        const auto [p, n] = bent(u, v);
        return PointAndNormal{turn * p + way, turn * n};
    });
    std::vector<Vec3> vertices, normals;
    for (int i = 0; i < 40; ++i) {
        const auto [p, n] = bent(0.025f * static_cast<float>(i), 0.5f);
        vertices.push_back(to_vec3(p + Vector3(0.01f, 0, 0.02f)));
        normals.push_back({n.x() + 0.3f, 0.2f, n.z()});
    }
    const auto mesh = DrawnMesh::bind(cage.view, {.vertices = vertices, .normals = normals});
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    Drawn drawn(mesh->size());
    mesh->update(moved.view, drawn.spans());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        EXPECT_LT((xyz(drawn.positions[v]) - (turn * to_vector(vertices[v]) + way)).norm(), 3e-6f);
        EXPECT_LT((xyz(drawn.normals[v]) - turn * to_vector(normals[v]).normalized()).norm(), 1e-5f);
        EXPECT_NEAR(xyz(drawn.tangents[v]).norm(), 1, 1e-5f);
        EXPECT_NEAR(xyz(drawn.tangents[v]).dot(xyz(drawn.normals[v])), 0, 1e-5f);
    }
}

/// The greatest distance of drawn vertices from the cylinder that the cage is bent to.
float error_on_cylinder(std::uint32_t cells, float rounding, float height = 0) {
    const Cage rest(cells, flat_place), round(cells, bent);
    const Fine fine(60, height);
    const auto mesh = DrawnMesh::bind(rest.view, fine.surface(), {.rounding = rounding});
    Drawn drawn(mesh->size());
    mesh->update(round.view, drawn.spans());
    float worst = 0;
    for (const Vec4& p : drawn.positions)
        worst = std::max(worst, std::abs(std::hypot(p.x, p.z) - (0.4f + height)));
    return worst;
}

TEST(DrawnMesh, IsRoundedWhereTheCageIsBent) {
    // A chord of 1/8 m in a circle of 0.4 m lies 4.9 mm inside it.
    EXPECT_NEAR(error_on_cylinder(8, 0), 4.9e-3f, 3e-4f);
    EXPECT_LT(error_on_cylinder(8, 0.5f), 3e-4f);
    EXPECT_LT(error_on_cylinder(8, 0.5f, 0.01f), 4e-4f);
    // Of the fourth order in the cage's edges, not of the second.
    EXPECT_LT(error_on_cylinder(16, 0.5f), error_on_cylinder(8, 0.5f) / 10);
}

TEST(DrawnMesh, HasTheSurfacesNormalsAndTangents) {
    const Cage rest(10, flat_place), round(10, bent);
    for (const bool mirrored : {false, true}) {
        const Fine fine(25, 0, mirrored);
        const auto mesh = DrawnMesh::bind(rest.view, fine.surface());
        ASSERT_TRUE(mesh.ok());
        Drawn drawn(mesh->size());
        mesh->update(round.view, drawn.spans());
        for (std::size_t v = 0; v < mesh->size(); ++v) {
            const float angle = fine.vertices[v].x / 0.4f;
            EXPECT_LT((xyz(drawn.normals[v]) - Vector3(std::sin(angle), 0, std::cos(angle))).norm(), 0.01f);
            const Vector3 along = (mirrored ? -1.0f : 1.0f) * Vector3(std::cos(angle), 0, -std::sin(angle));
            EXPECT_LT((xyz(drawn.tangents[v]) - along).norm(), 0.01f);
            EXPECT_EQ(drawn.tangents[v].w, mirrored ? -1 : 1);
        }
    }
}

TEST(DrawnMesh, OfTwoLayersFollowsTheOneThatFacesAsItDoes) {
    Cage cage(4, flat_place);
    // A second layer 5 mm before the first, with its front to the other side.
    const auto count = static_cast<std::uint32_t>(cage.positions.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        cage.positions.push_back(cage.positions[i]);
        cage.positions.back().z = 0.005f;
        cage.normals.push_back({0, 0, -1, 0});
    }
    for (std::size_t t = 0, layer = cage.triangles.size(); t < layer; ++t) {
        const auto [a, b, c] = cage.triangles[t];
        cage.triangles.push_back({a + count, c + count, b + count});
    }
    cage.view = {.positions = cage.positions, .normals = cage.normals, .triangles = cage.triangles};
    const Fine fine(9, 0.004f);
    const auto mesh = DrawnMesh::bind(cage.view, fine.surface());
    ASSERT_TRUE(mesh.ok());
    for (std::uint32_t i = count; i < 2 * count; ++i) cage.positions[i].z = 5;
    Drawn drawn(mesh->size());
    mesh->update(cage.view, drawn.spans());
    for (const Vec4& p : drawn.positions) EXPECT_NEAR(p.z, 0.004f, 1e-6f);
}

TEST(DrawnMesh, BindsToTheNearestTriangle) {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> place(0, 1), shake(-0.04f, 0.04f);
    const Cage cage(12, [&](float u, float v) { return PointAndNormal{{u, v, shake(random)}, {0, 0, 1}}; });
    std::vector<Vec3> vertices;
    for (int i = 0; i < 300; ++i) vertices.push_back({place(random), place(random), shake(random)});
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        float least = 1;  // by many points of all triangles
        for (const Triangle& t : cage.triangles) {
            for (int i = 0; i <= 24; ++i) {
                for (int j = 0; i + j <= 24; ++j) {
                    const float b = static_cast<float>(i) / 24, c = static_cast<float>(j) / 24;
                    const Vector3 p = (1 - b - c) * xyz(cage.positions[t[0]]) +
                                      b * xyz(cage.positions[t[1]]) + c * xyz(cage.positions[t[2]]);
                    least = std::min(least, (p - to_vector(vertices[v])).norm());
                }
            }
        }
        std::vector<Vec3> one{vertices[v]};
        EXPECT_TRUE(DrawnMesh::bind(cage.view, {.vertices = one}, {.reach = least + 1e-5f}).ok());
        if (least > 0.004f) {
            EXPECT_FALSE(DrawnMesh::bind(cage.view, {.vertices = one}, {.reach = least - 0.003f}).ok());
        }
    }
}

/// A search begins where the vertex before was found: only its time may depend on that.
TEST(DrawnMesh, HasTheSameBondsInAnyOrderOfVertices) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(0, 1), shake(-0.03f, 0.03f);
    const Cage cage(12, bent);
    std::vector<Vec3> vertices, normals;
    for (int i = 0; i < 500; ++i) {
        const auto [p, n] = bent(place(random), place(random));
        vertices.push_back(to_vec3(p + shake(random) * n));
        normals.push_back(to_vec3(shake(random) * n));
    }
    std::vector<std::size_t> order(vertices.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::shuffle(order, random);
    std::vector<Vec3> shuffled_vertices, shuffled_normals;
    for (const std::size_t v : order) {
        shuffled_vertices.push_back(vertices[v]);
        shuffled_normals.push_back(normals[v]);
    }
    const auto mesh = DrawnMesh::bind(cage.view, {.vertices = vertices, .normals = normals});
    const auto other =
        DrawnMesh::bind(cage.view, {.vertices = shuffled_vertices, .normals = shuffled_normals});
    ASSERT_TRUE(mesh.ok() && other.ok());
    const Cage moved(12, [](float u, float v) {
        return PointAndNormal{{u, v, u * v}, Vector3(-v, -u, 1).normalized()};
    });
    Drawn drawn(order.size()), again(order.size());
    mesh->update(moved.view, drawn.spans());
    other->update(moved.view, again.spans());
    for (std::size_t k = 0; k < order.size(); ++k) {
        EXPECT_EQ(xyz(again.positions[k]), xyz(drawn.positions[order[k]]));
        EXPECT_EQ(xyz(again.normals[k]), xyz(drawn.normals[order[k]]));
    }
}

/// A surface that lies on the cloth and is wound the other way, as the inside of a garment: nothing within
/// reach faces any vertex. Twice the cells a side are four times the triangles.
TEST(DrawnMesh, BindsToTheBackInALittleMoreThanTheTimeOfTheFront) {
    const auto seconds = [](std::uint32_t cells, bool back) {
        const Cage cage(cells, bent);
        std::vector<Vec3> vertices, normals;
        for (std::size_t i = 0; i < cage.positions.size(); ++i) {
            vertices.push_back(to_vec3(xyz(cage.positions[i])));
            normals.push_back(to_vec3((back ? -1.0f : 1.0f) * xyz(cage.normals[i])));
        }
        const std::clock_t begin = std::clock();
        const auto mesh =
            DrawnMesh::bind(cage.view, {.vertices = vertices, .normals = normals}, {.reach = 10});
        EXPECT_TRUE(mesh.ok());
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    EXPECT_LT(seconds(96, true), 20 * seconds(96, false) + 0.1);
    EXPECT_LT(seconds(96, true), 20 * seconds(48, true) + 0.1);
}

TEST(DrawnMesh, ReachesFarFromASmallCloth) {
    const Cage small(8, [](float u, float v) {
        return PointAndNormal{{0.01f * u, 0.01f * v, 0}, {0, 0, 1}};
    });
    const std::vector<Vec3> near_reach(200, Vec3{0, 0, 9.9f}), beyond(200, Vec3{0, 0, 10.1f});
    const std::clock_t begin = std::clock();
    EXPECT_TRUE(DrawnMesh::bind(small.view, {.vertices = near_reach}, {.reach = 10}).ok());
    EXPECT_FALSE(DrawnMesh::bind(small.view, {.vertices = beyond}, {.reach = 10}).ok());
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 0.1);
}

TEST(DrawnMesh, NamesAllThatIsOutOfReach) {
    const Cage cage(4, flat_place);
    Fine fine(9);
    for (const std::size_t v : {3u, 40u, 41u}) fine.vertices[v].z = 1;
    auto mesh = DrawnMesh::bind(cage.view, fine.surface());
    ASSERT_FALSE(mesh.ok());
    EXPECT_NE(mesh.error().message.find("3 of the 100 vertices"), std::string::npos) << mesh.error().message;
    EXPECT_NE(mesh.error().message.find("0.1 m: vertices 3, 40, 41"), std::string::npos);
    for (Vec3& p : fine.vertices) p.z = 1;
    mesh = DrawnMesh::bind(cage.view, fine.surface());
    ASSERT_FALSE(mesh.ok());
    EXPECT_NE(mesh.error().message.find("14, 15, ..."), std::string::npos) << mesh.error().message;
}

TEST(DrawnMesh, WritesThePartThatIsAskedFor) {
    const Cage cage(4, flat_place);
    const Fine fine(9);
    const auto mesh = DrawnMesh::bind(cage.view, fine.surface());
    ASSERT_TRUE(mesh.ok());
    Drawn all(mesh->size()), parts(mesh->size());
    mesh->update(cage.view, all.spans());
    for (Vec4& p : parts.positions) p = {9, 9, 9, 9};
    mesh->update(cage.view, parts.spans(), 10, 20);
    EXPECT_EQ(parts.positions[9].x, 9);
    EXPECT_EQ(parts.positions[30].x, 9);
    mesh->update(cage.view, parts.spans(), 0, 10);
    mesh->update(cage.view, parts.spans(), 30);
    mesh->update(cage.view, parts.spans(), mesh->size() + 5, 3);
    for (std::size_t v = 0; v < mesh->size(); ++v) EXPECT_EQ(parts.positions[v].x, all.positions[v].x);
    std::vector<Vec4> too_short(mesh->size() - 1, Vec4{7, 7, 7, 7});
    mesh->update(cage.view, {.positions = too_short});
    EXPECT_EQ(too_short[0].x, 7);
}

TEST(DrawnMesh, StaysFiniteOnACageOfNoArea) {
    const Cage cage(4, flat_place), gone(4, [](float, float) {
        return PointAndNormal{{1, 2, 3}, {0, 0, 0}};
    });
    const Fine fine(9, 0.01f);
    const auto mesh = DrawnMesh::bind(cage.view, fine.surface());
    Drawn drawn(mesh->size());
    mesh->update(gone.view, drawn.spans());
    for (const Vec4& p : drawn.positions) EXPECT_LT((xyz(p) - Vector3(1, 2, 3)).norm(), 0.011f);
    for (const Vec4& n : drawn.normals) EXPECT_NEAR(xyz(n).norm(), 1, 1e-4f);
}

TEST(DrawnMesh, ErrorsNameWhatIsWrong) {
    const Cage cage(4, flat_place);
    const Fine fine(3);
    const auto refusal = [&](const DrawnSurface& surface, const DrawnMeshSettings& settings = {}) {
        const auto mesh = DrawnMesh::bind(cage.view, surface, settings);
        return mesh.ok() ? std::string() : mesh.error().message;
    };
    EXPECT_EQ(refusal(fine.surface()), "");
    Fine broken = fine;
    broken.vertices[5].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refusal(broken.surface()).find("vertex 5"), std::string::npos);
    broken = fine;
    broken.vertices[7].z = 0.5f;
    EXPECT_NE(refusal(broken.surface()).find("vertex 7 of the drawn surface is further"), std::string::npos);
    EXPECT_EQ(refusal(broken.surface(), {.reach = 0.6f}), "");
    broken = fine;
    broken.triangles[2][1] = 16;
    EXPECT_NE(refusal(broken.surface()).find("triangle 2 of the drawn surface has vertex 16"),
              std::string::npos);
    broken = fine;
    broken.texcoords.pop_back();
    EXPECT_NE(refusal(broken.surface()).find("15 texture coordinates for 16 vertices"), std::string::npos);
    broken = fine;
    broken.texcoords[3].x = std::numeric_limits<float>::infinity();
    EXPECT_NE(refusal(broken.surface()).find("vertex 3"), std::string::npos);
    EXPECT_NE(refusal(fine.surface(), {.rounding = 1.5f}).find("rounding"), std::string::npos);
    EXPECT_NE(refusal(fine.surface(), {.reach = 0}).find("reach"), std::string::npos);
    const std::vector<Vec3> normals(2);
    EXPECT_NE(refusal({.vertices = fine.vertices, .normals = normals}).find("2 normals"), std::string::npos);
}

TEST(DrawnMesh, FollowsAClothInAWorld) {
    auto world = World::create({.threads = 1});
    const auto sheet = make_sheet({.rows = 20, .columns = 20});
    const auto cloth = world->add_cloth(*sheet);
    ASSERT_TRUE(world->pin(*cloth, 0).ok());
    std::vector<Vec3> vertices;
    for (int i = 0; i < 50; ++i) vertices.push_back({-0.5f + 0.02f * static_cast<float>(i), 0.004f, 0.1f});
    const auto mesh = DrawnMesh::bind(*world->cloth(*cloth), {.vertices = vertices});
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    for (int i = 0; i < 60; ++i) world->step(1.0f / 60);
    Drawn drawn(mesh->size());
    mesh->update(*world->cloth(*cloth), drawn.spans());
    for (const Vec4& p : drawn.positions) {
        float nearest = 1;
        for (const Vec4& q : world->cloth(*cloth)->positions)
            nearest = std::min(nearest, (xyz(p) - xyz(q)).norm());
        EXPECT_LT(nearest, 0.06f);
    }
}

}  // namespace
}  // namespace weft
