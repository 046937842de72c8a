// Simulated meshes that are made of fine ones.

#include "weft/proxy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/vector.h"
#include "weft/cooked_cloth.h"
#include "weft/drawn_mesh.h"
#include "weft/world.h"

namespace weft {
namespace {

constexpr std::uint32_t around = 120, rows = 56;

/// A wavy skirt of 0.6 m, open at waist and hem. With a thickness it has a lining, and rims that join the
/// two.
Mesh skirt(float thickness) {
    Mesh mesh;
    const std::uint32_t layer = (rows + 1) * around;
    for (std::uint32_t i = 0; i < (thickness > 0 ? 2 : 1) * layer; ++i) {
        const float u = static_cast<float>(i % around) / around,
                    v = static_cast<float>(i % layer / around) / rows;
        const float angle = 2 * std::numbers::pi_v<float> * u;
        const float radius =
            (0.14f + 0.12f * v) * (1 + 0.06f * v * std::sin(7 * angle)) - (i < layer ? 0 : thickness);
        mesh.positions.push_back({radius * std::sin(angle), 1 - 0.6f * v, radius * std::cos(angle)});
    }
    const auto add_cell = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (std::uint32_t c = 0; c < around; ++c) {
        const std::uint32_t next = (c + 1) % around, last = rows * around;
        for (std::uint32_t r = 0; r < last; r += around) {
            add_cell(r + c, r + around + c, r + around + next, r + next);
            if (thickness > 0)
                add_cell(layer + r + c, layer + r + next, layer + r + around + next, layer + r + around + c);
        }
        if (!(thickness > 0)) continue;
        add_cell(c, next, layer + next, layer + c);
        add_cell(last + c, layer + last + c, layer + last + next, last + next);
    }
    return mesh;
}

/// Adds a round plate of 7 mm that faces z, and is 2 mm thick.
void add_button(Mesh& mesh, const Vec3& at) {
    constexpr std::uint32_t corners = 12;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t k = 0; k < 2 * corners; ++k) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k % corners) / corners;
        mesh.positions.push_back({at.x + 0.007f * std::cos(angle), at.y + 0.007f * std::sin(angle),
                                  at.z + (k < corners ? 0.002f : 0)});
    }
    for (std::uint32_t k = 0; k < corners; ++k) {
        const std::uint32_t a = first + k, b = first + (k + 1) % corners;
        mesh.triangles.push_back({a, a + corners, b + corners});
        mesh.triangles.push_back({a, b + corners, b});
        if (k < 2) continue;
        mesh.triangles.push_back({first, first + k - 1, a});
        mesh.triangles.push_back({first + corners, a + corners, a + corners - 1});
    }
}

Mesh buttoned_skirt() {
    Mesh mesh = skirt(0.003f);
    for (int k = 0; k < 4; ++k)
        add_button(mesh, {0, 0.95f - 0.1f * static_cast<float>(k), 0.155f + 0.02f * static_cast<float>(k)});
    return mesh;
}

double area_of(const Mesh& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vector3 origin = to_vector(mesh.positions[a]);
        area +=
            0.5 *
            static_cast<double>(
                (to_vector(mesh.positions[b]) - origin).cross(to_vector(mesh.positions[c]) - origin).norm());
    }
    return area;
}

/// The triangles at each edge, by the edge from corner to corner.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> ways_of(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> ways;
    for (const auto& [a, b, c] : mesh.triangles)
        for (const auto& way : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++ways[way];
    return ways;
}

using Lines = std::vector<std::pair<Vector3, Vector3>>;

Lines borders_of(const Mesh& mesh) {
    Lines borders;
    const auto ways = ways_of(mesh);
    for (const auto& [way, count] : ways)
        if (!ways.contains({way.second, way.first}))
            borders.emplace_back(to_vector(mesh.positions[way.first]), to_vector(mesh.positions[way.second]));
    return borders;
}

/// The greatest distance of a line's start from the other lines.
float farthest(const Lines& from, const Lines& to) {
    float most = 0;
    for (const auto& [point, unused] : from) {
        float least = std::numeric_limits<float>::infinity();
        for (const auto& [a, b] : to) {
            const float along = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0f, 1.0f);
            least = std::min(least, (point - a - along * (b - a)).norm());
        }
        most = std::max(most, least);
    }
    return most;
}

/// Vertices - edges + triangles: 1 of a disc, 0 of a tube. No edge has more than two triangles.
int euler_number(const Mesh& mesh) {
    const auto ways = ways_of(mesh);
    int edges = 0;
    for (const auto& [way, count] : ways) {
        EXPECT_EQ(count, 1);
        edges += way.first < way.second || !ways.contains({way.second, way.first}) ? 1 : 0;
    }
    return static_cast<int>(mesh.positions.size() + mesh.triangles.size()) - edges;
}

TEST(MakeProxy, HasTheWantedSizeAndTheMeshesShape) {
    for (const bool is_doubled : {false, true}) {
        const Mesh outside = skirt(0), fine = is_doubled ? buttoned_skirt() : outside;
        for (const std::uint32_t wanted : {200u, 800u}) {
            ProxyReport report;
            const auto proxy = make_proxy(fine, {.particles = wanted}, &report);
            ASSERT_TRUE(proxy.ok()) << proxy.error().message;
            const auto count = static_cast<float>(proxy->positions.size());
            EXPECT_NEAR(count, static_cast<float>(wanted), 0.1f * static_cast<float>(wanted));
            EXPECT_EQ(euler_number(*proxy), 0);
            EXPECT_NEAR(area_of(*proxy) / area_of(outside), 1, 0.015);
            EXPECT_LT(report.longest_edge, 3 * report.shortest_edge);
            EXPECT_LT(report.longest_edge, 1.7f * report.cell);
            const Lines borders = borders_of(*proxy), of_fine = borders_of(outside);
            EXPECT_LT(farthest(of_fine, borders), 0.5f * report.cell);
            EXPECT_LT(farthest(borders, of_fine), is_doubled ? 0.0035f : 1e-6f);
            EXPECT_EQ(report.parts, 1u);
            EXPECT_EQ(report.left_out_parts, is_doubled ? 4u : 0u);
            EXPECT_EQ(report.closed_holes, 0u);
        }
    }
}

TEST(MakeProxy, CooksWithoutRepairs) {
    const auto proxy = make_proxy(buttoned_skirt(), {.particles = 800});
    ASSERT_TRUE(proxy.ok());
    const auto cooked = CookedCloth::create(*proxy);
    ASSERT_TRUE(cooked.ok());
    EXPECT_EQ(cooked->report(), CookReport{});
}

TEST(MakeProxy, CarriesTheWholeMesh) {
    const Mesh fine = buttoned_skirt();
    ProxyReport report;
    const auto proxy = make_proxy(fine, {.particles = 400}, &report);
    auto world = World::create({.threads = 1});
    const auto cloth = world->add_cloth(*proxy);
    const auto bind = [&](float reach) {
        return DrawnMesh::bind(*world->cloth(*cloth),
                               {.vertices = fine.positions, .triangles = fine.triangles}, {.reach = reach});
    };
    EXPECT_FALSE(bind(0.99f * report.reach).ok());
    const auto drawn = bind(1.01f * report.reach);
    ASSERT_TRUE(drawn.ok()) << drawn.error().message;
    std::vector<Vec4> places(drawn->size());
    drawn->update(*world->cloth(*cloth), {.positions = places});
    for (std::size_t v = 0; v < places.size(); ++v)
        EXPECT_LT((xyz(places[v]) - to_vector(fine.positions[v])).norm(), 1e-5f);
    // In motion the buttons and the lining stay where they are on the skirt.
    for (int step = 0; step < 20; ++step) world->step(1.0f / 60);
    drawn->update(*world->cloth(*cloth), {.positions = places});
    const std::uint32_t layer = (rows + 1) * around;
    for (std::uint32_t v = 0; v < layer; ++v)
        EXPECT_NEAR((xyz(places[v]) - xyz(places[v + layer])).norm(), 0.003f, 0.0015f);
}

TEST(MakeProxy, HasTheCornersOfASheet) {
    const auto sheet = make_sheet({.rows = 40, .columns = 40});
    for (const std::uint32_t wanted : {60u, 700u}) {
        const auto proxy = make_proxy(*sheet, {.particles = wanted});
        ASSERT_TRUE(proxy.ok());
        EXPECT_EQ(euler_number(*proxy), 1);
        EXPECT_NEAR(area_of(*proxy), 1, 1e-5);
        EXPECT_LT(farthest(borders_of(*proxy), borders_of(*sheet)), 1e-6f);
    }
}

/// A sheet with pleats, which are so deep [m]: turns of 3 mm and of 1.5 mm.
Mesh pleated_sheet(float depth, int pleats = 1) {
    constexpr float first = 0.003f, second = 0.0015f;
    std::vector<std::array<float, 2>> section;  // along and up
    const auto run = [&](float from, float to, float up) {
        constexpr int steps = 24;
        for (int k = 0; k < steps; ++k)
            section.push_back({from + (to - from) * static_cast<float>(k) / steps, up});
    };
    const auto turn = [&](float at, float up, float gap, float side) {
        constexpr int steps = 6;
        for (int k = 0; k < steps; ++k) {
            const float angle = std::numbers::pi_v<float> * static_cast<float>(k) / steps;
            section.push_back(
                {at + side * 0.5f * gap * std::sin(angle), up + 0.5f * gap * (1 - std::cos(angle))});
        }
    };
    float begin = 0, up = 0;
    for (int pleat = 0; pleat < pleats; ++pleat) {
        const float end = pleats == 1 ? 0.5f : begin + 1.5f * depth;
        run(begin, end, up);
        turn(end, up, first, 1);
        run(end, end - depth, up + first);
        turn(end - depth, up + first, second, -1);
        begin = end - depth;
        up += first + second;
    }
    run(begin, pleats == 1 ? 1 : begin + depth + 0.4f, up);
    constexpr std::uint32_t columns = 25;
    Mesh mesh;
    for (const auto& [along, up] : section)
        for (std::uint32_t c = 0; c < columns; ++c)
            mesh.positions.push_back({0.02f * static_cast<float>(c), up, along});
    for (std::uint32_t a = 0; a + columns < mesh.positions.size(); ++a) {
        if (a % columns == columns - 1) continue;
        mesh.triangles.push_back({a, a + columns, a + columns + 1});
        mesh.triangles.push_back({a, a + columns + 1, a + 1});
    }
    return mesh;
}

/// A proxy that has all of a pleated sheet's layers, in one piece. At each turn an edge of a cell's length
/// cuts across.
void expect_pleats_kept(const Mesh& fine, int pleats) {
    ProxyReport report;
    const auto proxy = make_proxy(fine, {.particles = 1800}, &report);
    ASSERT_TRUE(proxy.ok()) << proxy.error().message;
    EXPECT_EQ(report.left_out_triangles, 0u);
    EXPECT_EQ(report.parts, 1u);
    EXPECT_EQ(euler_number(*proxy), 1);
    constexpr double width = 0.48;
    EXPECT_LT(area_of(*proxy), area_of(fine));
    EXPECT_GT(area_of(*proxy), area_of(fine) - 2 * pleats * width * static_cast<double>(report.cell));
}

// The sides of a fold lie as near as the layers of a doubled mesh do.
TEST(MakeProxy, KeepsFoldedClothTogether) {
    for (const float depth : {0.02f, 0.05f, 0.1f, 0.2f}) {
        SCOPED_TRACE(depth);
        expect_pleats_kept(pleated_sheet(depth), 1);
    }
}

// Pleat upon pleat: a third of the area is pleats' middle layers.
TEST(MakeProxy, KeepsPleatsOfTheWholeCloth) {
    for (const int pleats : {2, 5}) {
        SCOPED_TRACE(pleats);
        expect_pleats_kept(pleated_sheet(0.1f, pleats), pleats);
    }
}

// Each part is doubled or folded by itself.
TEST(MakeProxy, LeavesOutTheLiningBesideFoldedCloth) {
    Mesh fine = skirt(0.003f);
    const auto first = static_cast<std::uint32_t>(fine.positions.size());
    const std::size_t of_skirt = fine.triangles.size();
    const Mesh folded = pleated_sheet(0.1f);
    for (const Vec3& p : folded.positions) fine.positions.push_back({p.x + 2, p.y, p.z});
    for (const auto& [a, b, c] : folded.triangles)
        fine.triangles.push_back({first + a, first + b, first + c});
    ProxyReport report;
    const auto proxy = make_proxy(fine, {.particles = 1600}, &report);
    ASSERT_TRUE(proxy.ok()) << proxy.error().message;
    EXPECT_EQ(report.parts, 2u);
    EXPECT_EQ(euler_number(*proxy), 1);  // a tube and a disc
    EXPECT_NEAR(static_cast<double>(report.left_out_triangles) / static_cast<double>(of_skirt), 0.5, 0.05);
    EXPECT_NEAR(area_of(*proxy) / (area_of(skirt(0)) + area_of(folded)), 1, 0.02);
}

// A lining that hangs out below the hem at an eighth of it goes on there, and is a layer of its own
// elsewhere.
TEST(MakeProxy, LeavesOutALiningThatGoesOnAtLittleOfItsEnds) {
    Mesh fine = skirt(0.002f);
    constexpr std::uint32_t layer = (rows + 1) * around, hem = layer + rows * around, flap = around / 8;
    std::erase_if(fine.triangles, [&](const Triangle& t) {  // rims there
        std::uint32_t outside = 0, inside = 0;
        for (const std::uint32_t v : t) {
            outside += v >= rows * around && v < rows * around + flap + 1 ? 1 : 0;
            inside += v >= hem && v < hem + flap + 1 ? 1 : 0;
        }
        return outside + inside == 3 && outside > 0 && inside > 0;
    });
    const auto first = static_cast<std::uint32_t>(fine.positions.size());
    const std::size_t before = fine.triangles.size();
    for (std::uint32_t r = 1; r < 8; ++r)
        for (std::uint32_t c = 0; c <= flap; ++c) {
            const Vec3& p = fine.positions[hem + c];
            fine.positions.push_back({p.x, p.y - 0.01f * static_cast<float>(r), p.z});
        }
    const auto at = [&](std::uint32_t r, std::uint32_t c) {
        return r == 0 ? hem + c : first + (r - 1) * (flap + 1) + c;
    };
    for (std::uint32_t r = 0; r < 7; ++r)
        for (std::uint32_t c = 0; c < flap; ++c) {
            fine.triangles.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
            fine.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
        }
    ProxyReport report;
    ASSERT_TRUE(make_proxy(fine, {.particles = 900}, &report).ok());
    EXPECT_NEAR(static_cast<double>(report.left_out_triangles) / static_cast<double>(before), 0.5, 0.05);
}

TEST(MakeProxy, RefinesACoarseMesh) {
    ProxyReport report;
    const auto proxy = make_proxy(*make_sheet({.rows = 2, .columns = 3}), {.particles = 500}, &report);
    ASSERT_TRUE(proxy.ok());
    EXPECT_EQ(proxy->positions.size(), 500u);
    EXPECT_LT(report.longest_edge, 3 * report.shortest_edge);
    EXPECT_LT(report.reach, 1e-6f);
}

TEST(MakeProxy, ClosesHolesBelowThreeEdges) {
    Mesh sheet = *make_sheet({.rows = 41, .columns = 41});
    std::erase_if(sheet.triangles, [&](const Triangle& t) {
        return std::ranges::any_of(t, [](std::uint32_t v) { return v == 20 * 41 + 20; });
    });
    ProxyReport report;
    EXPECT_EQ(euler_number(*make_proxy(sheet, {.particles = 150}, &report)), 1);
    EXPECT_EQ(report.closed_holes, 1u);
    EXPECT_EQ(euler_number(*make_proxy(sheet, {.particles = 1200}, &report)), 0);
    EXPECT_EQ(report.closed_holes, 0u);
}

TEST(MakeProxy, IsTheSameForTheSameMesh) {
    const Mesh fine = buttoned_skirt();
    const auto first = make_proxy(fine, {.particles = 300}), second = make_proxy(fine, {.particles = 300});
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_EQ(first->triangles, second->triangles);
    for (std::size_t p = 0; p < first->positions.size(); ++p)
        EXPECT_EQ(to_vector(first->positions[p]), to_vector(second->positions[p]));
}

TEST(MakeProxy, ErrorsNameWhatIsWrong) {
    Mesh mesh = skirt(0);
    const auto refusal = [&](const ProxySettings& settings) {
        const auto proxy = make_proxy(mesh, settings);
        return proxy.ok() ? std::string() : proxy.error().message;
    };
    EXPECT_NE(refusal({.particles = 11}).find("ProxySettings::particles"), std::string::npos);
    EXPECT_NE(refusal({.thickness = -1}).find("ProxySettings::thickness"), std::string::npos);
    mesh.positions[7].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refusal({}).find("positions[7]"), std::string::npos) << refusal({});
    mesh.positions[7].y = 0;
    mesh.triangles[2][1] = 99999;
    EXPECT_NE(refusal({}).find("triangle 2"), std::string::npos) << refusal({});
}

}  // namespace
}  // namespace weft
