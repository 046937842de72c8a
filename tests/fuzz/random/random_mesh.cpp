#include "tests/fuzz/random/random_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace weft::fuzz {

namespace {

Vec3 middle(const Vec3& a, const Vec3& b) {
    return {0.5f * (a.x + b.x), 0.5f * (a.y + b.y), 0.5f * (a.z + b.z)};
}

Mesh random_sheet(Random& random) {
    SheetSettings sheet;
    sheet.rows = static_cast<std::uint32_t>(random.whole(2, 40));
    sheet.columns = static_cast<std::uint32_t>(random.whole(2, 40));
    sheet.origin = random.point(1);
    const float length = random.of_any_size(0.05f, 3);
    const bool lies = random.chance(0.5);
    sheet.u = {length, 0, 0};
    sheet.v = lies ? Vec3{0, 0, length} : Vec3{0, -length, 0};
    return make_sheet(sheet).value();
}

Mesh octahedron() {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    return mesh;
}

/// Triangles about one vertex: a disc, or a full fan.
Mesh fan(Random& random) {
    constexpr float turn = 6.2831853f;
    const auto corners = static_cast<std::uint32_t>(random.whole(3, 60));
    const bool closed = random.chance(0.5);
    Mesh mesh;
    mesh.positions.push_back({});
    for (std::uint32_t i = 0; i < corners; ++i) {
        const float angle = turn * static_cast<float>(i) / static_cast<float>(corners);
        mesh.positions.push_back({std::cos(angle), 0, std::sin(angle)});
    }
    for (std::uint32_t i = 1; i < corners; ++i) mesh.triangles.push_back({0, i + 1, i});
    if (closed) mesh.triangles.push_back({0, 1, corners});
    return mesh;
}

/// Each triangle into four.
void subdivide(Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle_of = [&](std::uint32_t a, std::uint32_t b) {
        const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), mesh.positions.size());
        if (is_new) mesh.positions.push_back(middle(mesh.positions[a], mesh.positions[b]));
        return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
}

Mesh random_surface(Random& random) {
    Mesh mesh = random.chance(0.5) ? octahedron() : fan(random);
    while (mesh.triangles.size() < 400 && random.chance(0.6)) subdivide(mesh);
    const float size = random.of_any_size(0.05f, 2);
    const float noise = random.chance(0.5) ? 0.1f : 0;
    for (Vec3& p : mesh.positions) {
        const Vec3 moved = random.point(noise);
        p = {size * (p.x + moved.x), size * (p.y + moved.y), size * (p.z + moved.z)};
    }
    return mesh;
}

void append(Mesh& mesh, const Mesh& other, const Vec3& shift) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : other.positions)
        mesh.positions.push_back({p.x + shift.x, p.y + shift.y, p.z + shift.z});
    for (const auto [a, b, c] : other.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
}

Mesh random_components(Random& random) {
    const int count = random.whole(2, 60);
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        Mesh piece = octahedron();
        if (random.chance(0.5)) piece = make_sheet({.rows = 2, .columns = 2}).value();
        append(mesh, piece, random.point(20));
    }
    return mesh;
}

/// Two panels, front and back, sewn along three of their sides: at a seam each has vertices of its own, which
/// lie at one position in space and apart in the pattern.
Mesh random_bag(Random& random) {
    const auto side = static_cast<std::uint32_t>(random.whole(2, 20));
    const float ease = random.between(1, 1.3f);  // the pattern's size over the space between
    Mesh panel = make_sheet({.rows = side, .columns = side}).value();
    panel.rows = panel.columns = 0;
    Mesh bag;
    for (const float front : {1.0f, -1.0f}) {
        append(bag, panel, {});
        for (std::uint32_t row = 0; row < side; ++row) {
            for (std::uint32_t column = 0; column < side; ++column) {
                const Vec3 flat = panel.positions[row * side + column];
                const bool sewn = row == 0 || column == 0 || column + 1 == side;
                Vec3& p = bag.positions[bag.pattern.size()];
                if (!sewn) p.y += 0.02f * front;
                bag.pattern.push_back({ease * flat.x + 2 * front, ease * flat.z});
            }
        }
    }
    const auto half = static_cast<std::uint32_t>(bag.triangles.size() / 2);
    for (std::uint32_t t = half; t < bag.triangles.size(); ++t)
        std::swap(bag.triangles[t][1], bag.triangles[t][2]);
    return bag;
}

/// Adds oddities with which a mesh may still be cloth; where it is not, the error says so.
void make_odd(Random& random, Mesh& mesh) {
    const auto vertex = [&] { return random.below(mesh.positions.size()); };
    const auto triangle = [&]() -> Triangle& { return mesh.triangles[random.below(mesh.triangles.size())]; };
    switch (random.below(9)) {
        case 0: {  // slivers
            const Triangle corners = triangle();
            const Vec3 foot = middle(mesh.positions[corners[0]], mesh.positions[corners[1]]);
            const float height = random.of_any_size(1e-9f, 1e-2f);
            mesh.positions[corners[2]] = {foot.x, foot.y + height, foot.z};
            break;
        }
        case 1:  // vertices that will be welded
            for (Triangle& t : mesh.triangles) {
                if (!random.chance(0.3)) continue;
                mesh.positions.push_back(mesh.positions[t[0]]);
                if (!mesh.pattern.empty()) mesh.pattern.push_back(mesh.pattern[t[0]]);
                t[0] = static_cast<std::uint32_t>(mesh.positions.size() - 1);
            }
            break;
        case 2:  // loose vertices
            for (std::uint32_t i = random.below(5) + 1; i > 0; --i) {
                mesh.positions.push_back(random.point(2));
                if (!mesh.pattern.empty()) mesh.pattern.push_back({});
            }
            break;
        case 3:  // wound against its neighbours
            std::swap(triangle()[0], triangle()[1]);
            break;
        case 6: {  // a fin on an edge, which may have two triangles
            const Triangle at = triangle();
            mesh.positions.push_back(random.point(1));
            if (!mesh.pattern.empty()) mesh.pattern.push_back({random.between(-1, 1), random.between(-1, 1)});
            mesh.triangles.push_back({at[0], at[1], static_cast<std::uint32_t>(mesh.positions.size() - 1)});
            break;
        }
        case 7: {  // the same triangle again
            Triangle again = triangle();
            if (random.chance(0.5)) std::swap(again[0], again[1]);
            mesh.triangles.push_back(again);
            break;
        }
        case 4:  // no area
            triangle()[0] = triangle()[1];
            break;
        case 5:  // two vertices in one place
            mesh.positions[vertex()] = mesh.positions[vertex()];
            break;
        default:  // a hole
            if (mesh.triangles.size() > 1)
                mesh.triangles.erase(mesh.triangles.begin() + random.below(mesh.triangles.size()));
            break;
    }
}

/// Adds a fault that no cloth may have.
void spoil(Random& random, Mesh& mesh) {
    Vec3& p = mesh.positions[random.below(mesh.positions.size())];
    switch (random.below(7)) {
        case 0:
            p.x = std::numeric_limits<float>::quiet_NaN();
            break;
        case 1:
            p.y = -std::numeric_limits<float>::infinity();
            break;
        case 2:
            p.z = 1e20f;
            break;
        case 3:
            mesh.triangles[random.below(mesh.triangles.size())][random.below(3)] =
                static_cast<std::uint32_t>(mesh.positions.size()) + random.below(1u << 31);
            break;
        case 4:
            mesh.pattern.resize(mesh.positions.size() + 1);
            break;
        case 5:
            mesh.triangles.clear();
            break;
        default:
            mesh.texcoords.resize(mesh.positions.size() - 1);
            break;
    }
}

Mesh random_whole_mesh(Random& random) {
    switch (random.below(8)) {
        case 0:
        case 1:
            return random_surface(random);
        case 2:
            return random_components(random);
        case 3:
            return random_bag(random);
        default:
            break;
    }
    Mesh sheet = random_sheet(random);
    if (random.chance(0.4)) sheet.rows = sheet.columns = 0;
    if (random.chance(0.1)) std::swap(sheet.rows, sheet.columns);
    return sheet;
}

}  // namespace

Drawn<Mesh> random_mesh(Random& random) {
    Drawn<Mesh> drawn{random_whole_mesh(random)};
    Mesh& mesh = drawn.value;
    // A surface with noise may cross over itself in one point, and a sheet may claim columns for rows.
    drawn.answer = Answer::either;
    if (random.chance(0.3)) mesh.texcoords.resize(mesh.positions.size());
    if (random.chance(0.1)) {
        spoil(random, mesh);
        drawn.answer = Answer::refused;
    } else {
        while (random.chance(0.25)) {
            make_odd(random, mesh);
            if (!mesh.texcoords.empty()) mesh.texcoords.resize(mesh.positions.size());
        }
    }
    return drawn;
}

}  // namespace weft::fuzz
