#include "demo/look/drawn_solid.h"

#include <numeric>
#include <utility>

#include "demo/scenes/solids.h"

namespace weft::demo {

DrawnSolid::DrawnSolid(const SceneSolid& solid, const Vec3& offset, render::SceneRenderer& renderer)
    : offset_(offset), mesh_(solid.mesh) {
    if (mesh_.positions.empty()) return;
    std::vector<std::uint32_t> each(mesh_.positions.size());
    std::iota(each.begin(), each.end(), 0u);
    handle_ = renderer.add_cloth({.triangles = mesh_.triangles,
                                  .vertex_to_particle = each,
                                  .texcoords = {},
                                  .look = {.front = solid.colour,
                                           .back = solid.colour,
                                           .roughness = 0.6f,
                                           .sheen = 0,
                                           .thread_width = 0,
                                           .translucency = 0}});
}

std::vector<Vec4> DrawnSolid::placed(const SceneSolid& solid, SolidMoment moment) {
    if (solid.place) solid.place(mesh_.positions, moment);
    std::vector<Vec4> positions;
    for (const Vec3& p : mesh_.positions)
        positions.push_back({p.x + offset_.x, p.y + offset_.y, p.z + offset_.z, 0});
    return positions;
}

void DrawnSolid::update(const SceneSolid& solid, std::uint64_t step, render::SceneRenderer& renderer) {
    if (is_drawn_ && (!solid.place || step == step_)) return;
    const bool follows = is_drawn_ && step == step_ + 1;  // the vertices of the step before are known
    const std::vector<Vec4> previous =
        follows ? std::move(positions_) : placed(solid, SolidMoment::before_last_step);
    positions_ = placed(solid, SolidMoment::now);
    is_drawn_ = true;
    step_ = step;
    renderer.update_cloth(handle_, {.positions = positions_,
                                    .previous_positions = previous,
                                    .normals = vertex_normals(mesh_),
                                    .colours = solid.tints});
}

}  // namespace weft::demo
