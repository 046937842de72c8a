#include "demo/scenes/contact/contact_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace weft::demo {

namespace {

std::uint32_t rounded(double value) {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(value)));
}

}  // namespace

Piece piece(double length, double width, std::uint32_t particles, std::uint32_t parts) {
    const double edge = std::sqrt(length * width / particles);
    const std::uint32_t along = parts * rounded((length / edge - 1) / parts);
    return {length, width, along + 1, rounded(width * along / length) + 1};
}

Mesh placed_sheet(const Piece& piece, const PlaceOf& place) {
    Mesh mesh = make_sheet({.rows = piece.rows, .columns = piece.columns}).value();
    mesh.positions.clear();
    for (std::uint32_t row = 0; row < piece.rows; ++row) {
        for (std::uint32_t column = 0; column < piece.columns; ++column) {
            const double u = piece.length * column / (piece.columns - 1);
            const double v = piece.width * row / (piece.rows - 1);
            mesh.positions.push_back(to_point(place(u, v)));
            mesh.pattern.push_back({static_cast<float>(u), static_cast<float>(v)});
        }
    }
    return mesh;
}

std::vector<std::uint32_t> column_of(const Piece& piece, std::uint32_t column) {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t row = 0; row < piece.rows; ++row) vertices.push_back(vertex_at(piece, row, column));
    return vertices;
}

PlacedCloth joined(const std::vector<Mesh>& sheets) {
    PlacedCloth cloth;
    Mesh& mesh = cloth.mesh;
    for (const Mesh& sheet : sheets) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        cloth.layers.push_back(first);
        mesh.positions.insert(mesh.positions.end(), sheet.positions.begin(), sheet.positions.end());
        mesh.pattern.insert(mesh.pattern.end(), sheet.pattern.begin(), sheet.pattern.end());
        for (const auto& [a, b, c] : sheet.triangles)
            mesh.triangles.push_back({first + a, first + b, first + c});
    }
    return cloth;
}

std::string named(const std::string& name, Made made) {
    return made == Made::one_mesh ? name : name + " of cloths";
}

std::vector<PlacedCloth> layered(const std::vector<Mesh>& sheets, Made made) {
    if (made == Made::one_mesh) return {joined(sheets)};
    std::vector<PlacedCloth> cloths;
    for (const Mesh& sheet : sheets) cloths.push_back({.mesh = sheet, .layers = {0}});
    return cloths;
}

Mesh level_sheet(const Piece& sheet, double height, double turn) {
    return placed_sheet(sheet, [=](double u, double v) {
        const double x = u - sheet.length / 2, z = v - sheet.width / 2;
        return Eigen::Vector3d(x * std::cos(turn) - z * std::sin(turn), height,
                               x * std::sin(turn) + z * std::cos(turn));
    });
}

double usual_distance(double edge) {
    return 0.75 * edge;
}

WorldSettings still_air() {
    WorldSettings settings;
    settings.threads = 1;
    return settings;
}

WorldSettings zero_gravity() {
    WorldSettings settings = still_air();
    settings.gravity = {};
    settings.wind.air_density = 0;
    return settings;
}

Collider ground() {
    return {.shape = Plane{}};
}

Vec3 to_point(const Eigen::Vector3d& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

std::vector<SceneMaker> contact_scenes() {
    std::vector<SceneMaker> all;
    for (const auto family :
         {fold_scenes, stack_scenes, drape_scenes, forced_scenes, meeting_scenes, tangle_scenes})
        std::ranges::move(family(), std::back_inserter(all));
    return all;
}

}  // namespace weft::demo
