#include "demo/look/drawn_solid.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "demo/look/inside.h"
#include "demo/scenes/solids.h"
#include "engine/vector.h"

namespace weft::demo {

DrawnSolid::DrawnSolid(const SceneSolid& solid, render::SceneRenderer& renderer) : mesh_(solid.mesh) {
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

void DrawnSolid::update(const SceneSolid& solid, std::uint64_t step, render::SceneRenderer& renderer,
                        const Vec3& offset) {
    if (offset.x != offset_.x || offset.z != offset_.z) is_drawn_ = false;
    offset_ = offset;
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

namespace {

constexpr float jump = 1;  // a longer way in a step was none [m]

float between(float a, float b, float share) {
    return a + share * (b - a);
}
Vec3 between(const Vec3& a, const Vec3& b, float share) {
    const Vector3 way = to_vector(b) - to_vector(a);
    return way.norm() > jump ? b : to_vec3(to_vector(a) + share * way);
}
Rotation between(const Rotation& a, const Rotation& b, float share) {
    const Eigen::Quaternionf from(a.w, a.x, a.y, a.z), to(b.w, b.x, b.y, b.z);
    const Eigen::Quaternionf mean = from.normalized().slerp(share, to.normalized());
    return {mean.x(), mean.y(), mean.z(), mean.w()};
}

Sphere between(const Sphere& a, const Sphere& b, float share) {
    return {between(a.center, b.center, share), between(a.radius, b.radius, share)};
}
Capsule between(const Capsule& a, const Capsule& b, float share) {
    return {between(a.a, b.a, share), between(a.b, b.b, share), between(a.radius, b.radius, share)};
}
TaperedCapsule between(const TaperedCapsule& a, const TaperedCapsule& b, float share) {
    return {between(a.a, b.a, share), between(a.b, b.b, share), between(a.radius_a, b.radius_a, share),
            between(a.radius_b, b.radius_b, share)};
}
Box between(const Box& a, const Box& b, float share) {
    return {between(a.center, b.center, share), between(a.rotation, b.rotation, share),
            between(a.half_extents, b.half_extents, share)};
}

}  // namespace

void ColliderMotion::note(ColliderId id, const Collider& collider, std::uint64_t step) {
    const auto [found, is_new] = motions_.try_emplace(key(id), Motion{collider, collider, step});
    Motion& motion = found->second;
    if (is_new || motion.step == step) {
        motion.now = collider;  // hands may have changed it
        return;
    }
    // Several steps since the last picture share the way out evenly.
    const bool follows = step > motion.step;
    const float share = follows ? 1 - 1 / static_cast<float>(step - motion.step) : 1;
    const Collider last = motion.now;
    motion = {last, collider, step};
    motion.before = at(id, share);
}

Collider ColliderMotion::at(ColliderId id, float share) const {
    const Motion& motion = motions_.at(key(id));
    Collider collider = motion.now;
    std::visit(
        [&](auto& shape) {
            using Shape = std::remove_reference_t<decltype(shape)>;
            const auto* before = std::get_if<Shape>(&motion.before.shape);
            if constexpr (requires { between(shape, shape, share); })
                if (before != nullptr) shape = between(*before, shape, share);
        },
        collider.shape);
    return collider;
}

float room_beside(const Simulation& simulation) {
    constexpr float huge = std::numeric_limits<float>::max(), gap = 0.4f;  // [m]
    Vector3 lower = Vector3::Constant(huge), upper = Vector3::Constant(-huge);
    for (const SceneCloth& cloth : simulation.content().cloths) {
        const auto view = simulation.world().cloth(cloth.id);
        if (!view) continue;
        lower = lower.cwiseMin(to_vector(view->bounds.lower));
        upper = upper.cwiseMax(to_vector(view->bounds.upper));
    }
    const Vector3 size = (upper - lower).cwiseMax(0);
    return std::max(size.x(), size.z()) + gap;
}

void Beside::begin(const Simulation& other, render::SceneRenderer& renderer) {
    constexpr render::FabricLook ghost{.front = {0.10f, 0.75f, 0.95f},
                                       .back = {0.10f, 0.75f, 0.95f},
                                       .sheen = 0,
                                       .threads = render::Threads::none,
                                       .opacity = 0.4f};
    for (const SceneCloth& cloth : other.content().cloths) {
        const auto view = other.world().cloth(cloth.id);
        const std::vector<Vec2>& texcoords =
            cloth.mesh.texcoords.empty() ? cloth.mesh.pattern : cloth.mesh.texcoords;
        render::ClothSurface surface{.triangles = cloth.mesh.triangles,
                                     .vertex_to_particle = view->vertex_to_particle,
                                     .texcoords = texcoords,
                                     .look = is_ghost_ ? ghost : cloth.look};
        if (!is_ghost_ && !cloth.drawn) {  // the parts are those of the mesh that is drawn elsewhere
            surface.parts = cloth.surface.parts;
            surface.part_of_triangle = cloth.surface.of_triangle;
        }
        cloths_.push_back(renderer.add_cloth(surface));
    }
    if (is_ghost_) return;
    for (const SceneSolid& solid : other.content().solids) solids_.emplace_back(solid, renderer);
}

std::span<const Vec4> Beside::moved(std::span<const Vec4> positions, std::vector<Vec4>& to) const {
    to.assign(positions.begin(), positions.end());
    for (Vec4& p : to) p = {p.x + offset_.x, p.y + offset_.y, p.z + offset_.z, p.w};
    return to;
}

void Beside::show(const Simulation* other, const Vec3& offset, render::SceneRenderer& renderer) {
    if (other == nullptr) {
        for (const render::ClothHandle cloth : cloths_) renderer.remove_cloth(cloth);
        for (DrawnSolid& solid : solids_) solid.remove(renderer);
        cloths_.clear();
        solids_.clear();
        return;
    }
    offset_ = offset;
    if (cloths_.empty()) begin(*other, renderer);
    for (std::size_t i = 0; i < cloths_.size(); ++i) {
        const SceneCloth& cloth = other->content().cloths[i];
        const auto view = other->world().cloth(cloth.id);
        if (!view) continue;
        if (!is_ghost_) colour_particles(ShownAsColour::nothing, cloth, *view, colours_);
        renderer.update_cloth(cloths_[i], {.positions = moved(view->positions, positions_),
                                           .previous_positions = moved(view->previous_positions, previous_),
                                           .normals = view->normals,
                                           .colours = colours_});
    }
    for (std::size_t i = 0; i < solids_.size(); ++i)
        solids_[i].update(other->content().solids[i], other->world().report().step, renderer, offset_);
}

}  // namespace weft::demo
