#include "demo/hands/brush.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "demo/character/garment/garment_mesh.h"
#include "demo/character/garment/gltf_file.h"
#include "demo/character/garment/obj_materials.h"
#include "demo/character/garment/painted_maps.h"
#include "demo/cutting/cut_scene.h"
#include "demo/hands/project.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr std::array all_paints{
    Paint{Map::mass, "weight", "%.2f times", 1, 0.1f, 20, 4,
          "How heavy the cloth is where it is painted, over its own weight: a hem of 10 swings and hangs."},
    Paint{Map::stiffness, "stiffness", "%.2f times", 1, 0.05f, 50, 10,
          "How hard it is to stretch, over its own stiffness: a collar has 10, a net 0.1."},
    Paint{Map::friction, "friction", "%.2f times", 1, 0, 10, 4,
          "How well it holds on what it lies on, over its own friction: 0 slides off."},
    Paint{Map::leash, "leash", "%.0f mm", 1000, 0, 0.5f, 0.03f,
          "How far it may go from its place on the body: 0 sticks to it. Only on somebody who wears it."},
};

/// The values of a map on a cloth, by vertex; the map's default where it has none.
std::vector<float> values_of(const SceneCloth& cloth, Map map) {
    const auto painted = std::ranges::find(cloth.maps, map, &PaintedMap::map);
    if (painted != cloth.maps.end()) return painted->values;
    return std::vector<float>(cloth.mesh.positions.size(), named(map).unset);
}

float distance_to_way(const Vector3& point, const Vector3& from, const Vector3& to) {
    const Vector3 way = to - from;
    const float share =
        way.squaredNorm() > 0 ? std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0f, 1.0f) : 0.0f;
    return (point - from - share * way).norm();
}

/// Values by the vertices of the mesh that is drawn over the cloth: each takes those of the nearest that is
/// simulated.
std::vector<float> spread(const SceneCloth& cloth, const std::vector<float>& values) {
    std::vector<float> spread;
    for (const std::uint32_t v : nearest_vertices(cloth.mesh, cloth.fine)) spread.push_back(values[v]);
    return spread;
}

}  // namespace

std::span<const Paint> paints() {
    return all_paints;
}

const Paint& paint_of(Map map) {
    const auto found = std::ranges::find(all_paints, map, &Paint::map);
    return found == all_paints.end() ? all_paints.front() : *found;
}

float share_of_range(Map map, float value) {
    const Paint& paint = paint_of(map);
    const float least = std::max(paint.least, 1e-3f * paint.most);
    return std::log(std::clamp(value, least, paint.most) / least) / std::log(paint.most / least);
}

void Brush::aim(const World& world, const render::Ray& ray) {
    const auto hit = world.cast_ray(ray.origin, ray.direction);
    place_ = hit && *hit ? std::optional((*hit)->position) : std::nullopt;
}

Result<void> Brush::stroke(Simulation& simulation) {
    if (!place_) {
        last_.reset();
        return {};
    }
    const Vector3 to = to_vector(*place_), from = last_ ? to_vector(*last_) : to;
    last_ = place_;
    for (std::size_t k = 0; k < simulation.content().cloths.size(); ++k) {
        const SceneCloth& cloth = simulation.content().cloths[k];
        const auto positions = vertex_positions(simulation.world(), cloth.id);
        if (!positions) return positions.error();
        std::vector<float> values = values_of(cloth, map);
        bool changed = false;
        for (std::size_t v = 0; v < values.size(); ++v) {
            if (distance_to_way(to_vector((*positions)[v]), from, to) > radius) continue;
            changed = changed || values[v] != value;
            values[v] = value;
        }
        if (!changed) continue;
        if (auto painted = simulation.paint(k, map, std::move(values)); !painted) return painted;
    }
    return {};
}

Result<void> Brush::fill(Simulation& simulation, bool with_default) const {
    for (std::size_t k = 0; k < simulation.content().cloths.size(); ++k) {
        const std::size_t vertices = simulation.content().cloths[k].mesh.positions.size();
        const std::vector<float> values(vertices, with_default ? named(map).unset : value);
        if (auto painted = simulation.paint(k, map, values); !painted) return painted;
    }
    return {};
}

Result<std::string> save_maps(const Simulation& simulation) {
    const std::filesystem::path& file = simulation.options().garment;
    if (file.empty())
        return Error{
            ErrorCode::invalid_argument,
            "maps are saved beside a garment's file, and this cloth is from none: drop a file first"};
    const SceneCloth& cloth = simulation.content().cloths.front();
    std::vector<PaintedMap> maps = cloth.maps;
    std::size_t vertices =
        std::numeric_limits<std::size_t>::max();  // those that were split or refined follow
    if (!is_gltf(file)) {
        const auto materials = read_obj_materials(file);
        if (!materials) return materials.error();
        vertices = materials->vertices;
    }
    for (PaintedMap& painted : maps) {
        if (cloth.drawn) painted.values = spread(cloth, painted.values);
        painted.values.resize(std::min(vertices, painted.values.size()));
    }
    if (auto written = write_maps(file, maps); !written) return written.error();
    return "saved " + maps_file(file).string();
}

}  // namespace weft::demo
