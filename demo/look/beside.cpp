#include "demo/look/beside.h"

#include <algorithm>

#include "demo/look/inside.h"

namespace weft::demo {

void Beside::begin(const Simulation& other, const Simulation& first, render::SceneRenderer& renderer) {
    Bounds box{{1e9f, 0, 0}, {-1e9f, 0, 0}};
    for (const SceneCloth& cloth : first.content().cloths) {
        const auto view = first.world().cloth(cloth.id);
        if (!view) continue;
        box.lower.x = std::min(box.lower.x, view->bounds.lower.x);
        box.upper.x = std::max(box.upper.x, view->bounds.upper.x);
    }
    constexpr float gap = 0.4f;  // [m]
    offset_ = {std::max(box.upper.x - box.lower.x, 0.0f) + gap, 0, 0};
    for (const SceneCloth& cloth : other.content().cloths) {
        const auto view = other.world().cloth(cloth.id);
        const std::vector<Vec2>& texcoords =
            cloth.mesh.texcoords.empty() ? cloth.mesh.pattern : cloth.mesh.texcoords;
        cloths_.push_back(renderer.add_cloth({.triangles = cloth.mesh.triangles,
                                              .vertex_to_particle = view->vertex_to_particle,
                                              .texcoords = texcoords,
                                              .look = cloth.look}));
    }
    for (const SceneSolid& solid : other.content().solids) solids_.emplace_back(solid, offset_, renderer);
}

std::span<const Vec4> Beside::moved(std::span<const Vec4> positions, std::vector<Vec4>& to) const {
    to.assign(positions.begin(), positions.end());
    for (Vec4& p : to) p.x += offset_.x;
    return to;
}

void Beside::show(const Simulation* other, const Simulation& first, render::SceneRenderer& renderer) {
    if (other == nullptr) {
        for (const render::ClothHandle cloth : cloths_) renderer.remove_cloth(cloth);
        for (DrawnSolid& solid : solids_) solid.remove(renderer);
        cloths_.clear();
        solids_.clear();
        return;
    }
    if (cloths_.empty()) begin(*other, first, renderer);
    for (std::size_t i = 0; i < cloths_.size(); ++i) {
        const SceneCloth& cloth = other->content().cloths[i];
        const auto view = other->world().cloth(cloth.id);
        if (!view) continue;
        colour_particles(ShownAsColour::nothing, cloth, *view, colours_);
        renderer.update_cloth(cloths_[i], {.positions = moved(view->positions, positions_),
                                           .previous_positions = moved(view->previous_positions, previous_),
                                           .normals = view->normals,
                                           .colours = colours_});
    }
    for (std::size_t i = 0; i < solids_.size(); ++i)
        solids_[i].update(other->content().solids[i], other->world().report().step, renderer);
}

}  // namespace weft::demo
