#include "demo/cutting/knife.h"

#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float length = 100.0f;  // of the blade, from the eye [m]

Vec3 tip(const render::Ray& ray) {
    return to_vec3(to_vector(ray.origin) + length * to_vector(ray.direction));
}

}  // namespace

void Knife::begin(const Simulation& simulation, const render::Ray& ray) {
    last_ = ray;
    strokes_.assign(simulation.content().cloths.size(), {});
}

Result<void> Knife::draw_to(const render::Ray& ray, Simulation& simulation) {
    const Blade blade{last_.origin, tip(last_), ray.origin, tip(ray)};
    last_ = ray;
    Result<void> done;
    for (std::size_t k = 0; k < strokes_.size(); ++k) {
        const SceneCloth& cloth = simulation.content().cloths[k];
        const auto positions = vertex_positions(simulation.world(), cloth.id);
        if (!positions) return positions.error();
        const auto edges = edges_along(cloth.mesh, *positions, blade, strokes_[k]);
        if (!edges) return edges.error();
        if (edges->empty()) continue;
        if (auto cut = simulation.cut(k, *edges); !cut) done = cut;
    }
    return done;
}

}  // namespace weft::demo
