#include "meshes.h"

#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <utility>

#include "engine/vector.h"

namespace weft::test {

namespace {

/// The normalized middle of an edge, made once however often it is asked for.
class Midpoints {
  public:
    explicit Midpoints(std::vector<Vec3>& positions) : positions_(positions) {}

    std::uint32_t of(std::uint32_t a, std::uint32_t b) {
        const auto [at, is_new] =
            known_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(positions_.size()));
        if (is_new) {
            const Vector3 middle = to_vector(positions_[a]) + to_vector(positions_[b]);
            positions_.push_back(to_vec3(middle.normalized()));
        }
        return at->second;
    }

  private:
    std::vector<Vec3>& positions_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known_;
};

Mesh icosahedron() {
    const float a = 1 / std::sqrt(1 + std::numbers::phi_v<float> * std::numbers::phi_v<float>);
    const float b = a * std::numbers::phi_v<float>;
    Mesh mesh;
    mesh.positions = {{-a, b, 0},  {a, b, 0},  {-a, -b, 0}, {a, -b, 0}, {0, -a, b},  {0, a, b},
                      {0, -a, -b}, {0, a, -b}, {b, 0, -a},  {b, 0, a},  {-b, 0, -a}, {-b, 0, a}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    return mesh;
}

void append_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

}  // namespace

Mesh loose_sheet(std::uint32_t rows, std::uint32_t columns) {
    Mesh mesh = must(make_sheet({.rows = rows, .columns = columns}));
    mesh.rows = mesh.columns = 0;
    return mesh;
}

Mesh turned_sheet(float height, float turn, std::uint32_t side, float size) {
    const float c = size * std::cos(turn), s = size * std::sin(turn);
    return make_sheet({.rows = side,
                       .columns = side,
                       .origin = {-0.5f * (c + s), height, -0.5f * (c - s)},
                       .u = {c, 0, -s},
                       .v = {s, 0, c}})
        .value();
}

Mesh evenly_cut(const SheetSettings& settings) {
    Mesh mesh = must(make_sheet(settings));
    mesh.triangles.clear();
    for (std::uint32_t row = 0; row + 1 < settings.rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < settings.columns; ++column) {
            const std::uint32_t a = row * settings.columns + column, b = a + 1, c = a + settings.columns;
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({b, c, c + 1});
        }
    }
    return mesh;
}

Mesh sphere(int subdivisions) {
    Mesh mesh = icosahedron();
    for (int i = 0; i < subdivisions; ++i) {
        Midpoints midpoints(mesh.positions);
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = midpoints.of(a, b), bc = midpoints.of(b, c), ca = midpoints.of(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    return mesh;
}

Mesh tube(std::uint32_t rows, std::uint32_t columns) {
    constexpr float full_turn = 2 * std::numbers::pi_v<float>;
    Mesh mesh;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const float t = static_cast<float>(row) / static_cast<float>(rows - 1);
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const float turn = full_turn / static_cast<float>(columns);
            const float angle = turn * static_cast<float>(column % columns);
            mesh.positions.push_back({std::cos(angle), 2 * t - 1, std::sin(angle)});
            mesh.texcoords.push_back({turn * static_cast<float>(column), 2 * t});
        }
    }
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * (columns + 1) + column, b = a + columns + 1;
            append_quad(mesh, a, b, b + 1, a + 1);
        }
    }
    return mesh;
}

Mesh moebius_strip(std::uint32_t length) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < length; ++i) {
        const float angle =
            2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(length);
        for (const float side : {-0.3f, 0.3f}) {
            const float radius = 1 + side * std::cos(angle / 2);
            mesh.positions.push_back(
                {radius * std::cos(angle), side * std::sin(angle / 2), radius * std::sin(angle)});
        }
    }
    for (std::uint32_t i = 0; i + 1 < length; ++i) append_quad(mesh, 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2);
    const std::uint32_t last = 2 * (length - 1);
    append_quad(mesh, last, last + 1, 0, 1);  // half a turn on, the sides have changed places
    return mesh;
}

Mesh fan(std::uint32_t triangles) {
    Mesh mesh;
    mesh.positions.push_back({0, 0, 0});
    for (std::uint32_t i = 0; i <= triangles; ++i) {
        const float angle = 2 * static_cast<float>(i) / static_cast<float>(triangles);
        mesh.positions.push_back({std::cos(angle), 0, -std::sin(angle)});
    }
    for (std::uint32_t i = 1; i <= triangles; ++i) mesh.triangles.push_back({0, i, i + 1});
    return mesh;
}

Mesh joined(const Mesh& first, const Mesh& second, const Vec3& offset) {
    Mesh mesh;
    mesh.positions = first.positions;
    mesh.triangles = first.triangles;
    const auto shift = static_cast<std::uint32_t>(first.positions.size());
    for (const Vec3& p : second.positions)
        mesh.positions.push_back(to_vec3(to_vector(p) + to_vector(offset)));
    for (const auto& [a, b, c] : second.triangles)
        mesh.triangles.push_back({a + shift, b + shift, c + shift});
    return mesh;
}

std::vector<NamedMesh> sound_meshes() {
    return {
        {"grid", must(make_sheet({.rows = 7, .columns = 5}))},
        {"smallest grid", must(make_sheet({.rows = 2, .columns = 2}))},
        {"loose sheet", loose_sheet(6, 9)},
        {"icosahedron", sphere(0), 1, 2, false},
        {"sphere", sphere(2), 1, 2, false},
        {"tube with a seam", tube(5, 12), 1, 0},
        {"Moebius strip", moebius_strip(15), 1, 0},
        {"fan", fan(8)},
        {"one triangle", fan(1)},
        {"sheet and sphere", joined(loose_sheet(4, 4), sphere(1), {5, 0, 0}), 2, 3},
    };
}

}  // namespace weft::test
