#include "demo/study/physics/experiment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "demo/must.h"

namespace weft::study {

namespace {

Vec2 point(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

std::uint32_t number_of(double parts) {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(parts)));
}

Mesh sheet_mesh(const Strip& strip) {
    const std::uint32_t across = number_of(strip.width / strip.length * strip.cells);
    Mesh mesh = make_sheet({.rows = across + 1, .columns = strip.cells + 1}).value();
    for (std::uint32_t row = 0; row <= across; ++row)
        for (std::uint32_t column = 0; column <= strip.cells; ++column)
            mesh.pattern.push_back(point(strip.length * column / strip.cells, strip.width * row / across));
    return mesh;
}

/// Columns of nodes. Odd columns are shifted by half a side, and have half sides at their ends.
Mesh triangle_mesh(const Strip& strip) {
    const double column = strip.length / strip.cells;
    const std::uint32_t across = number_of(strip.width / column * std::numbers::sqrt3 / 2);
    Mesh mesh;
    std::vector<std::vector<std::uint32_t>> columns;
    for (std::uint32_t k = 0; k <= strip.cells; ++k) {
        std::vector<double> heights{0};
        for (std::uint32_t j = 0; j < across; ++j) heights.push_back(k % 2 == 0 ? j + 1.0 : j + 0.5);
        if (k % 2 == 1) heights.push_back(across);
        std::vector<std::uint32_t> nodes;
        for (const double height : heights) {
            nodes.push_back(static_cast<std::uint32_t>(mesh.pattern.size()));
            mesh.pattern.push_back(point(column * k, strip.width * height / across));
        }
        columns.push_back(nodes);
    }
    // Between two columns, whichever next node is lower ends the next triangle.
    for (std::size_t k = 0; k + 1 < columns.size(); ++k) {
        const auto &left = columns[k], &right = columns[k + 1];
        std::size_t l = 0, r = 0;
        while (l + 1 < left.size() || r + 1 < right.size()) {
            const bool on_left =
                r + 1 == right.size() ||
                (l + 1 < left.size() && mesh.pattern[left[l + 1]].y <= mesh.pattern[right[r + 1]].y);
            const std::uint32_t next = on_left ? left[l + 1] : right[r + 1];
            mesh.triangles.push_back({left[l], right[r], next});
            ++(on_left ? l : r);
        }
    }
    return mesh;
}

}  // namespace

const char* name_of(ForceModel model) {
    switch (model) {
        case ForceModel::sheet:
            return "springs, sheet";
        case ForceModel::mesh:
            return "springs, mesh";
        case ForceModel::elements:
            return "elements, mesh";
    }
    return "";
}

ClothSettings made_of(ForceModel model, const Fabric& fabric) {
    ClothSettings settings;
    settings.fabric = fabric;
    settings.finite_elements.enabled = model == ForceModel::elements;
    settings.air_damping = 0;
    return settings;
}

Mesh strip_mesh(ForceModel model, const Strip& strip, const Place& place) {
    Mesh mesh = model == ForceModel::sheet ? sheet_mesh(strip) : triangle_mesh(strip);
    mesh.positions.clear();
    for (const Vec2& p : mesh.pattern) mesh.positions.push_back(place(p));
    return mesh;
}

float noise(std::uint32_t number) {
    std::uint32_t h = number * 0x9E3779B9u + 0x7F4A7C15u;
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return static_cast<float>((h ^ (h >> 16)) >> 8) / 8388608.0f - 1.0f;
}

namespace {

double squared(const Vec3& v) {
    const double x = v.x, y = v.y, z = v.z;
    return x * x + y * y + z * z;
}

}  // namespace

Experiment::Experiment(Mesh mesh, const ClothSettings& cloth, const WorldSettings& settings)
    : mesh_(std::move(mesh)),
      world_(must(World::create(settings))),
      cloth_(must(world_.add_cloth(mesh_, cloth))) {}

WorldSettings in_vacuum(const Vec3& gravity) {
    WorldSettings settings;
    settings.gravity = gravity;
    settings.wind.air_density = 0;
    settings.threads = 1;
    return settings;
}

void Experiment::pin(const std::function<bool(Vec2)>& of_the_pattern) {
    must(world_.pin(cloth_, vertices(of_the_pattern)));
}

void Experiment::run(double seconds, float step, const std::function<void()>& each) {
    const auto steps = std::lround(seconds / static_cast<double>(step));
    for (long k = 0; k < steps; ++k) {
        world_.step(step);
        if (each) each();
    }
}

bool Experiment::come_to_rest(double damping, double most_seconds, float still) {
    const float before = must(world_.cloth_settings(cloth_)).air_damping;
    change([&](ClothSettings& settings) { settings.air_damping = static_cast<float>(damping); });
    constexpr int wanted = 10;
    int still_steps = 0;
    const double steps = most_seconds / static_cast<double>(usual_step);
    for (int k = 0; k < steps && still_steps < wanted; ++k) {
        world_.step(usual_step);
        still_steps = world_.report().peak_speed < still ? still_steps + 1 : 0;
    }
    change([&](ClothSettings& settings) { settings.air_damping = before; });
    return still_steps == wanted;
}

void Experiment::change(const std::function<void(ClothSettings&)>& how) {
    ClothSettings settings = must(world_.cloth_settings(cloth_));
    how(settings);
    must(world_.set_cloth_settings(cloth_, settings));
}

void Experiment::change_world(const std::function<void(WorldSettings&)>& how) {
    WorldSettings settings = world_.settings();
    how(settings);
    must(world_.set_settings(settings));
}

Vec3 Experiment::at(std::uint32_t vertex) const {
    const ClothView& view = *world_.cloth(cloth_);
    const Vec4& p = view.positions[view.vertex_to_particle[vertex]];
    return {p.x, p.y, p.z};
}

Vec3 Experiment::velocity(std::uint32_t vertex) const {
    const ClothView& view = *world_.cloth(cloth_);
    const Vec4& v = view.velocities[view.vertex_to_particle[vertex]];
    return {v.x, v.y, v.z};
}

double Experiment::mass(std::uint32_t vertex) const {
    const ClothView& view = *world_.cloth(cloth_);
    const double inverse = view.positions[view.vertex_to_particle[vertex]].w;
    return inverse > 0 ? 1 / inverse : 0;
}

std::vector<std::uint32_t> Experiment::vertices(const std::function<bool(Vec2)>& of_the_pattern) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < mesh_.pattern.size(); ++i)
        if (of_the_pattern(mesh_.pattern[i])) found.push_back(i);
    return found;
}

Vec3 Experiment::mean_place(const std::vector<std::uint32_t>& vertices) const {
    double x = 0, y = 0, z = 0;
    for (const std::uint32_t vertex : vertices) {
        const Vec3 p = at(vertex);
        x += static_cast<double>(p.x);
        y += static_cast<double>(p.y);
        z += static_cast<double>(p.z);
    }
    const auto count = static_cast<double>(vertices.size());
    return {static_cast<float>(x / count), static_cast<float>(y / count), static_cast<float>(z / count)};
}

double Experiment::energy() const {
    double sum = 0;
    for (std::uint32_t i = 0; i < mesh_.pattern.size(); ++i)
        sum += mass(i) * (0.5 * squared(velocity(i)) + gravity * static_cast<double>(at(i).y));
    return sum;
}

double Experiment::rms_speed() const {
    double sum = 0, all = 0;
    for (std::uint32_t i = 0; i < mesh_.pattern.size(); ++i) {
        sum += mass(i) * squared(velocity(i));
        all += mass(i);
    }
    return std::sqrt(sum / all);
}

}  // namespace weft::study
