#include "demo/scenes/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "demo/character/garment/garment_mesh.h"
#include "demo/must.h"
#include "engine/error_text.h"

namespace weft::demo {

namespace {

/// Calls f(vertex, vertex) for every structural edge; inner edges of a general mesh come twice.
template <class F>
void for_structural_edges(const Mesh& mesh, const F& f) {
    if (mesh.columns == 0) {
        for (const Triangle& t : mesh.triangles) {
            for (std::size_t corner = 0; corner < 3; ++corner) f(t[corner], t[(corner + 1) % 3]);
        }
        return;
    }
    for (std::uint32_t row = 0; row < mesh.rows; ++row) {
        for (std::uint32_t column = 0; column < mesh.columns; ++column) {
            const std::uint32_t vertex = row * mesh.columns + column;
            if (column + 1 < mesh.columns) f(vertex, vertex + 1);
            if (row + 1 < mesh.rows) f(vertex, vertex + mesh.columns);
        }
    }
}

std::string text(float value) {
    return number_text(static_cast<double>(value));
}

}  // namespace

GridSize grid_size(std::uint32_t particles, float width, float height) {
    const auto count = static_cast<float>(particles);
    const auto columns =
        std::max(2u, static_cast<std::uint32_t>(std::lround(std::sqrt(count * width / height))));
    const auto rows =
        std::max(2u, static_cast<std::uint32_t>(std::lround(count / static_cast<float>(columns))));
    return {rows, columns};
}

Mesh sheet_of(std::uint32_t particles, const Vec3& corner, const Vec3& u, const Vec3& v) {
    const GridSize grid = grid_size(particles, to_vector(u).norm(), to_vector(v).norm());
    return must(make_sheet({.rows = grid.rows, .columns = grid.columns, .origin = corner, .u = u, .v = v}));
}

std::vector<std::uint32_t> row_of(const Mesh& sheet, std::uint32_t row) {
    std::vector<std::uint32_t> vertices(sheet.columns);
    std::iota(vertices.begin(), vertices.end(), row * sheet.columns);
    return vertices;
}

std::vector<std::uint32_t> column_of(const Mesh& sheet, std::uint32_t column) {
    std::vector<std::uint32_t> vertices(sheet.rows);
    for (std::uint32_t row = 0; row < sheet.rows; ++row) vertices[row] = row * sheet.columns + column;
    return vertices;
}

bool is_pinned(const ClothView& view, std::uint32_t vertex) {
    return view.positions[view.vertex_to_particle[vertex]].w == 0;
}

Vector3 vertex_position(const ClothView& view, std::uint32_t vertex) {
    return xyz(view.positions[view.vertex_to_particle[vertex]]);
}

Stretch structural_stretch(const Mesh& mesh, const ClothView& view) {
    Stretch stretch;
    double sum = 0;
    std::size_t edges = 0;
    for_structural_edges(mesh, [&](std::uint32_t a, std::uint32_t b) {
        if (is_pinned(view, a) && is_pinned(view, b)) return;
        const float length = (vertex_position(view, a) - vertex_position(view, b)).norm();
        const float ratio = length / rest_length(mesh, a, b);
        stretch.worst = std::max(stretch.worst, ratio);
        sum += static_cast<double>(ratio);
        ++edges;
    });
    stretch.mean = static_cast<float>(sum / static_cast<double>(edges));
    return stretch;
}

float closest_layers(const Mesh& mesh, const ClothView& view, float rest_apart) {
    std::vector<std::uint32_t> by_x(mesh.positions.size());
    std::iota(by_x.begin(), by_x.end(), 0u);
    std::ranges::sort(by_x, {}, [&](std::uint32_t vertex) { return vertex_position(view, vertex).x(); });

    float closest = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < by_x.size(); ++i) {
        const Vector3 a = vertex_position(view, by_x[i]);
        for (std::size_t j = i + 1; j < by_x.size(); ++j) {
            const Vector3 b = vertex_position(view, by_x[j]);
            if (b.x() - a.x() >= closest) break;
            const float distance = (a - b).norm();
            if (distance < closest && rest_length(mesh, by_x[i], by_x[j]) >= rest_apart) closest = distance;
        }
    }
    return closest;
}

SceneContent OneCloth::add_cloth(World& world, const ClothSettings& settings, const render::FabricLook& look,
                                 const render::OrbitCamera& camera) {
    cloth_ = must(world.add_cloth(mesh_, settings));
    SceneContent content;
    content.cloths.push_back({cloth_, mesh_, look});
    content.camera = camera;
    return content;
}

void Checks::at_least(std::string_view what, float value, float bound) {
    if (!(value >= bound)) {
        fail(std::string(what) + " is " + text(value) + ", expected at least " + text(bound));
    }
}

void Checks::at_most(std::string_view what, float value, float bound) {
    if (!(value <= bound)) {
        fail(std::string(what) + " is " + text(value) + ", expected at most " + text(bound));
    }
}

void Checks::stretch(const Mesh& mesh, const ClothView& view, float worst, float mean) {
    const Stretch stretch = structural_stretch(mesh, view);
    at_most("worst stretch", stretch.worst, worst);
    at_most("mean stretch", stretch.mean, mean);
}

ClothView Checks::cloth(const World& world, ClothId id) {
    const ClothView view = world.cloth(id).value();
    for (const std::span<const Vec4> values : {view.positions, view.velocities}) {
        const auto broken = std::ranges::find_if(values, [](const Vec4& v) { return !xyz(v).allFinite(); });
        if (broken != values.end()) {
            fail("particle " + std::to_string(broken - values.begin()) + " is not finite");
            break;
        }
    }
    return view;
}

void Checks::pinned_at(const ClothView& view, std::uint32_t vertex, const Vec3& where) {
    const std::string name = "pinned vertex " + std::to_string(vertex);
    if (!is_pinned(view, vertex)) fail(name + " is free");
    const float away = (vertex_position(view, vertex) - to_vector(where)).norm();
    at_most(name + "'s distance from its place [m]", away, 1e-4f);
}

void Checks::fail(const std::string& failure) {
    if (!failures_.empty()) failures_ += "; ";
    failures_ += failure;
}

Result<void> Checks::result() const {
    if (failures_.empty()) return {};
    return Error{ErrorCode::invalid_argument, failures_};
}

}  // namespace weft::demo
