#include "weft_nodes.h"

#include <gdextension_interface.h>

#include <cstddef>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/utility_functions.hpp>
#include <span>
#include <vector>

namespace {

weft::Vec3 to_weft(const godot::Vector3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Reports an error of Weft to Godot. True if there was none.
template <class T>
bool went_well(const weft::Result<T>& result) {
    if (!result) godot::UtilityFunctions::push_error("Weft: ", result.error().message.c_str());
    return result.ok();
}

std::span<std::byte> bytes_of(
    godot::PackedVector3Array& array) {  // Vector3 is three floats, except in builds for large worlds
    static_assert(sizeof(godot::Vector3) == 3 * sizeof(float), "large worlds: write floats, and copy");
    return std::as_writable_bytes(std::span(array.ptrw(), static_cast<std::size_t>(array.size())));
}

}  // namespace

void WeftWorld::_enter_tree() {
    auto world = weft::World::create();
    if (!went_well(world)) return;
    world_.emplace(std::move(world).value());
    apply_wind();
    set_physics_process_priority(1000);  // after the cloths, which set their pins' targets
}

void WeftWorld::_exit_tree() {
    world_.reset();
}

void WeftWorld::_physics_process(double seconds) {
    if (!world_ || godot::Engine::get_singleton()->is_editor_hint()) return;
    const weft::StepReport& report = world_->step(static_cast<float>(seconds));
    if (weft::has(report.flags, weft::StepFlags::state_restored))
        godot::UtilityFunctions::push_warning("Weft: a cloth was put back to the start of the step");
}

void WeftWorld::set_wind(const godot::Vector3& metres_a_second) {
    wind_ = metres_a_second;
    apply_wind();
}

void WeftWorld::apply_wind() {
    if (!world_) return;
    weft::WorldSettings settings = world_->settings();
    settings.wind.velocity = to_weft(wind_);
    settings.wind.gust = 0.3f;
    went_well(world_->set_settings(settings));
}

void WeftWorld::_bind_methods() {
    godot::ClassDB::bind_method(godot::D_METHOD("set_wind", "metres_a_second"), &WeftWorld::set_wind);
    godot::ClassDB::bind_method(godot::D_METHOD("get_wind"), &WeftWorld::get_wind);
    ADD_PROPERTY(godot::PropertyInfo(godot::Variant::VECTOR3, "wind"), "set_wind", "get_wind");
}

weft::World* WeftCloth::world() const {
    auto* const parent = godot::Object::cast_to<WeftWorld>(get_parent());
    return parent != nullptr ? parent->world() : nullptr;
}

void WeftCloth::_ready() {
    if (world() == nullptr) return;
    const weft::SheetSettings shape{
        .rows = 32, .columns = 32, .origin = {-0.5f, 0, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}};
    auto mesh = weft::make_sheet(shape);
    if (!went_well(mesh)) return;
    for (std::uint32_t column = 0; column < shape.columns; ++column) {
        held_.push_back(column);
        at_rest_.push_back(mesh->positions[column]);
    }
    targets_.resize(held_.size());
    const godot::Transform3D place = get_global_transform();
    for (weft::Vec3& p : mesh->positions) p = to_weft(place.xform(godot::Vector3(p.x, p.y, p.z)));
    const auto cloth = world()->add_cloth(*mesh);
    if (!went_well(cloth) || !went_well(world()->pin(*cloth, held_))) return;
    cloth_ = *cloth;
    positions_.resize(static_cast<std::int64_t>(mesh->positions.size()));
    previous_.resize(positions_.size());
    normals_.resize(positions_.size());
    take_triangles();
    mesh_.instantiate();
    set_mesh(mesh_);
}

void WeftCloth::take_triangles() {
    const weft::ClothView view = *world()->cloth(cloth_);
    triangles_.resize(static_cast<std::int64_t>(3 * view.vertex_triangles.size()));
    std::int64_t at = 0;
    for (const weft::Triangle& corners : view.vertex_triangles)
        for (const int k : {0, 2, 1})
            triangles_[at++] = static_cast<std::int32_t>(corners[k]);  // Godot's fronts are clockwise
}

void WeftCloth::_exit_tree() {
    if (world() != nullptr && cloth_ != weft::ClothId{}) went_well(world()->remove_cloth(cloth_));
    cloth_ = {};
}

// Moves the upper edge with the node, before the World's step.
void WeftCloth::_physics_process(double) {
    if (world() == nullptr || cloth_ == weft::ClothId{}) return;
    const godot::Transform3D place = get_global_transform();
    for (std::size_t i = 0; i < held_.size(); ++i)
        targets_[i] = to_weft(place.xform(godot::Vector3(at_rest_[i].x, at_rest_[i].y, at_rest_[i].z)));
    went_well(world()->move_pins(cloth_, held_, targets_));
}

void WeftCloth::_process(double) {
    if (world() == nullptr || cloth_ == weft::ClothId{}) return;
    weft::VertexStreams streams;
    streams.positions.bytes = bytes_of(positions_);
    streams.previous_positions.bytes = bytes_of(previous_);
    streams.normals.bytes = bytes_of(normals_);
    if (!went_well(world()->write_vertices(cloth_, streams))) return;
    const auto alpha =
        static_cast<float>(godot::Engine::get_singleton()->get_physics_interpolation_fraction());
    godot::PackedVector3Array drawn = positions_, lit = normals_;
    const godot::Transform3D to_node =
        get_global_transform().affine_inverse();  // Godot draws the node with its own transform
    for (std::int64_t i = 0; i < drawn.size(); ++i) {
        drawn[i] = to_node.xform(previous_[i].lerp(positions_[i], alpha));
        lit[i] = to_node.basis.xform(normals_[i]);
    }

    godot::Array arrays;
    arrays.resize(godot::Mesh::ARRAY_MAX);
    arrays[godot::Mesh::ARRAY_VERTEX] = drawn;
    arrays[godot::Mesh::ARRAY_NORMAL] = lit;
    arrays[godot::Mesh::ARRAY_INDEX] = triangles_;
    mesh_->clear_surfaces();
    mesh_->add_surface_from_arrays(godot::Mesh::PRIMITIVE_TRIANGLES, arrays);
}

namespace {

void initialize(godot::ModuleInitializationLevel level) {
    if (level != godot::MODULE_INITIALIZATION_LEVEL_SCENE) return;
    godot::ClassDB::register_class<WeftWorld>();
    godot::ClassDB::register_class<WeftCloth>();
}

void terminate(godot::ModuleInitializationLevel) {}

}  // namespace

extern "C" GDExtensionBool GDE_EXPORT weft_godot_init(GDExtensionInterfaceGetProcAddress get,
                                                      GDExtensionClassLibraryPtr library,
                                                      GDExtensionInitialization* initialization) {
    godot::GDExtensionBinding::InitObject init(get, library, initialization);
    init.register_initializer(initialize);
    init.register_terminator(terminate);
    init.set_minimum_library_initialization_level(godot::MODULE_INITIALIZATION_LEVEL_SCENE);
    return init.init();
}
