#include "demo/headless/picture.h"

#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

namespace weft::demo {

namespace {

render::DrawnBox drawn(const Box& box) {
    const Rotation& r = box.rotation;
    const Eigen::Matrix3f axes = Eigen::Quaternionf(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
    const auto to_face = [&](int axis, float half) {
        const Eigen::Vector3f way = half * axes.col(axis);
        return Vec3{way.x(), way.y(), way.z()};
    };
    return {.center = box.center,
            .x = to_face(0, box.half_extents.x),
            .y = to_face(1, box.half_extents.y),
            .z = to_face(2, box.half_extents.z),
            .color = collider_colour};
}

constexpr std::size_t most_rounded = 50'000;  // particles; more are fine enough by themselves

}  // namespace

Picture::Picture(render::SceneRenderer renderer) : renderer_(std::move(renderer)) {}

Result<Picture> Picture::create() {
    auto renderer = render::SceneRenderer::create();
    if (!renderer) return renderer.error();
    return Picture(std::move(*renderer));
}

void Picture::show(const Simulation& simulation) {
    for (const render::ClothHandle cloth : cloths_) renderer_.remove_cloth(cloth);
    for (DrawnSolid& solid : solids_) solid.remove(renderer_);
    cloths_.clear();
    solids_.clear();
    motion_.forget();
    motion_beside_.forget();
    fine_.clear();
    shown_rounded_ = rounds();
    shown_painted_ = inside_.painted.has_value();
    for (const SceneCloth& cloth : simulation.content().cloths) show_cloth(cloth, simulation.world());
    for (const SceneSolid& solid : simulation.content().solids) solids_.emplace_back(solid, renderer_);
    cuts_ = simulation.cuts();
    update(simulation);
}

void Picture::show_cloth(const SceneCloth& cloth, const World& world) {
    const auto view = world.cloth(cloth.id);
    const bool fine_is_drawn = draws_fine(cloth);
    const Mesh& mesh = fine_is_drawn ? cloth.fine : cloth.mesh;
    const std::vector<Vec2>& texcoords = mesh.texcoords.empty() ? mesh.pattern : mesh.texcoords;
    Fine fine;
    if (!fine_is_drawn && shown_rounded_ && view->positions.size() <= most_rounded)
        fine.rounded = RoundedMesh(mesh.triangles, texcoords, view->vertex_to_particle.size());
    const bool rounded = fine.rounded.size() > 0;
    const std::size_t own = fine_is_drawn ? cloth.drawn->size() : fine.rounded.size();
    for (std::vector<Vec4>* each : {&fine.positions, &fine.previous_positions, &fine.normals})
        each->resize(own);
    std::vector<std::uint32_t> each(own);
    std::iota(each.begin(), each.end(), 0u);
    const std::span<const std::uint32_t> particles = each;
    render::ClothSurface surface{.triangles = mesh.triangles,
                                 .vertex_to_particle = own > 0 ? particles : view->vertex_to_particle,
                                 .texcoords = texcoords,
                                 .look = cloth.look};
    if (fine_is_drawn || !cloth.drawn) {  // the parts are those of the drawn mesh
        surface.parts = cloth.surface.parts;
        surface.part_of_triangle = cloth.surface.of_triangle;
    }
    SurfaceParts of_rounded;
    if (rounded && !surface.parts.empty()) {
        of_rounded = refined(cloth.surface);
        surface.part_of_triangle = of_rounded.of_triangle;
    }
    if (rounded) {
        surface.triangles = fine.rounded.triangles();
        surface.texcoords = fine.rounded.texcoords();
    }
    cloths_.push_back(renderer_.add_cloth(surface));
    fine_.push_back(std::move(fine));
}

void Picture::set_look(const QualityLevel& level, const Inside& inside) {
    quality_ = level.quality;
    rounded_ = level.rounded;
    inside_ = inside;
}

void Picture::set_beside(const Simulation& other, const Simulation& truth, const Simulation& first,
                         float yaw) {
    if (other_ == nullptr) room_beside_ = room_beside(first);
    other_ = &other;
    truth_ = &truth;
    offset_ = {room_beside_ * std::cos(yaw), 0, -room_beside_ * std::sin(yaw)};
}

void Picture::set_alone() {
    other_ = truth_ = nullptr;
    offset_ = {};
}

void Picture::update(const Simulation& simulation) {
    const bool is_other = rounds() != shown_rounded_ || inside_.painted.has_value() != shown_painted_;
    if (cuts_ != simulation.cuts() || is_other) return show(simulation);  // show() updates
    const std::vector<SceneSolid>& solids = simulation.content().solids;
    for (std::size_t i = 0; i < solids_.size(); ++i)
        solids_[i].update(solids[i], simulation.world().report().step, renderer_);
    for (std::size_t i = 0; i < cloths_.size(); ++i) {
        const SceneCloth& drawn = simulation.content().cloths[i];
        const auto cloth = simulation.world().cloth(drawn.id);
        renderer_.set_look(cloths_[i], drawn.look);
        if (draws_fine(drawn)) {
            update_fine(drawn, *cloth, i);
            continue;
        }
        if (inside_.painted)
            colour_by_map(*inside_.painted, drawn, *cloth, colours_);
        else
            colour_particles(inside_.colour, drawn, *cloth, colours_);
        if (fine_[i].rounded.size() > 0) {
            update_rounded(*cloth, i,
                           simulation.world().cloth_settings(drawn.id)->self_collision.method !=
                               SelfCollisionMethod::off);
            continue;
        }
        renderer_.update_cloth(cloths_[i], {.positions = cloth->positions,
                                            .previous_positions = cloth->previous_positions,
                                            .normals = cloth->normals,
                                            .colours = colours_});
    }
    drawing_.take(simulation.world(), inside_.parts);
    simulation.scene().annotate(simulation.world(), drawing_);
    beside_.show(other_, offset_, renderer_);
    ghost_.show(truth_, {}, renderer_);
    ghost_beside_.show(truth_, offset_, renderer_);
}

void Picture::update_rounded(const ClothView& view, std::size_t index, bool lies_on_itself) {
    constexpr float most = 0.03f;  // an edge that turns by 14 degrees; contact keeps layers 10 times as far
                                   // apart
    Fine& fine = fine_[index];
    fine.rounded.update(view, {fine.positions, fine.previous_positions, fine.normals},
                        lies_on_itself ? most : 1);
    fine.colours.resize(colours_.empty() ? 0 : fine.rounded.size());
    if (!colours_.empty()) fine.rounded.spread(view, colours_, fine.colours);
    renderer_.update_cloth(cloths_[index], {.positions = fine.positions,
                                            .previous_positions = fine.previous_positions,
                                            .normals = fine.normals,
                                            .colours = fine.colours});
}

void Picture::update_fine(const SceneCloth& cloth, const ClothView& view, std::size_t index) {
    Fine& fine = fine_[index];
    cloth.drawn->update(view, {.positions = fine.positions, .normals = fine.normals});
    ClothView before = view;
    before.positions = view.previous_positions;
    cloth.drawn->update(before, {.positions = fine.previous_positions});
    renderer_.update_cloth(cloths_[index], {.positions = fine.positions,
                                            .previous_positions = fine.previous_positions,
                                            .normals = fine.normals});
}

void Picture::add_collider(const World& world, ColliderId id, ColliderMotion& motion) {
    const auto present = world.collider(id);
    if (!present) return;
    motion.note(id, *present, world.report().step);
    const Collider shown = motion.at(id, view_.alpha);
    const Collider* const collider = &shown;
    if (const auto* sphere = std::get_if<Sphere>(&collider->shape)) {
        spheres_.push_back({sphere->center, sphere->radius, collider_colour});
    } else if (const auto* capsule = std::get_if<Capsule>(&collider->shape)) {
        capsules_.push_back({capsule->a, capsule->b, capsule->radius, collider_colour});
    } else if (const auto* tapered = std::get_if<TaperedCapsule>(&collider->shape)) {
        tapered_capsules_.push_back(
            {tapered->a, tapered->b, tapered->radius_a, tapered->radius_b, collider_colour});
    } else if (const auto* box = std::get_if<Box>(&collider->shape)) {
        boxes_.push_back(drawn(*box));
    }
}

const render::View& Picture::view(const Simulation& simulation, const render::OrbitCamera& camera,
                                  float alpha, std::span<const ColliderId> thrown,
                                  std::span<const render::DrawnLine> lines) {
    spheres_.clear();
    capsules_.clear();
    tapered_capsules_.clear();
    boxes_.clear();
    view_.alpha = alpha;
    for (const ColliderId id : simulation.content().drawn_colliders)
        add_collider(simulation.world(), id, motion_);
    for (const ColliderId id : thrown) add_collider(simulation.world(), id, motion_);
    if (other_ != nullptr) add_colliders_beside();
    spheres_.insert(spheres_.end(), drawing_.spheres.begin(), drawing_.spheres.end());
    capsules_.insert(capsules_.end(), drawing_.capsules.begin(), drawing_.capsules.end());
    view_.camera = camera;
    view_.ground_height = simulation.content().ground_height;
    view_.quality = quality_;
    view_.wireframe = inside_.wireframe;
    lines_.assign(drawing_.lines.begin(), drawing_.lines.end());
    lines_.insert(lines_.end(), lines.begin(), lines.end());
    view_.lines = lines_;
    view_.spheres = spheres_;
    view_.capsules = capsules_;
    view_.tapered_capsules = tapered_capsules_;
    view_.boxes = boxes_;
    view_.wind = shows_wind ? simulation.world().settings().wind.velocity : Vec3{};
    return view_;
}

void Picture::add_colliders_beside() {
    const std::size_t spheres = spheres_.size(), capsules = capsules_.size(),
                      tapered = tapered_capsules_.size(), boxes = boxes_.size();
    for (const ColliderId id : other_->content().drawn_colliders)
        add_collider(other_->world(), id, motion_beside_);
    const auto move = [by = offset_](Vec3& p) { p = {p.x + by.x, p.y + by.y, p.z + by.z}; };
    for (std::size_t i = spheres; i < spheres_.size(); ++i) move(spheres_[i].center);
    for (std::size_t i = capsules; i < capsules_.size(); ++i) move(capsules_[i].a), move(capsules_[i].b);
    for (std::size_t i = tapered; i < tapered_capsules_.size(); ++i)
        move(tapered_capsules_[i].a), move(tapered_capsules_[i].b);
    for (std::size_t i = boxes; i < boxes_.size(); ++i) move(boxes_[i].center);
}

}  // namespace weft::demo
