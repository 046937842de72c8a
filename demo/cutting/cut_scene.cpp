#include "demo/cutting/cut_scene.h"

#include <algorithm>
#include <utility>

#include "engine/vector.h"

namespace weft::demo {

Result<std::vector<Vec3>> vertex_positions(const World& world, ClothId cloth) {
    const auto view = world.cloth(cloth);
    if (!view) return view.error();
    std::vector<Vec3> positions;
    positions.reserve(view->vertex_to_particle.size());
    for (const std::uint32_t particle : view->vertex_to_particle)
        positions.push_back(to_vec3(xyz(view->positions[particle])));
    return positions;
}

Result<bool> cut_cloth(World& world, SceneCloth& cloth, std::span<const MeshEdge> edges) {
    if (cloth.drawn)
        return Error{ErrorCode::unsupported,
                     "a finer mesh is drawn over this cloth, which does not part with it"};
    auto cut = cut_mesh(cloth.mesh, edges);
    if (!cut) return cut.error();
    if (cut->added_particles == 0) return false;
    if (auto recut = world.recut_cloth(cloth.id, cut->mesh, cut->from); !recut) return recut.error();
    for (PaintedMap& painted : cloth.maps) {
        std::vector<float> values;
        for (const std::uint32_t vertex : cut->from) values.push_back(painted.values[vertex]);
        painted.values = std::move(values);
    }
    cloth.mesh = std::move(cut->mesh);
    return true;
}

namespace {

/// Removes the edges at pins: a split there would leave two pins in one place.
void spare_pins(const ClothView& view, std::vector<MeshEdge>& edges) {
    const auto is_pinned = [&](std::uint32_t vertex) {
        return view.positions[view.vertex_to_particle[vertex]].w == 0;
    };
    std::erase_if(edges, [&](const MeshEdge& edge) { return std::ranges::any_of(edge, is_pinned); });
}

}  // namespace

Result<bool> tear_cloth(World& world, SceneCloth& cloth, const Tearing& tearing) {
    std::vector<StrainedEdge> strained(tearing.edges);
    const auto count = world.strained_edges(cloth.id, tearing.strain, strained);
    if (!count) return count.error();
    if (*count == 0) return false;
    strained.resize(*count);
    const auto positions = vertex_positions(world, cloth.id);
    if (!positions) return positions.error();
    auto edges = edges_to_tear(cloth.mesh, *positions, strained);
    if (!edges) return edges.error();
    spare_pins(*world.cloth(cloth.id), *edges);
    return cut_cloth(world, cloth, *edges);
}

}  // namespace weft::demo
