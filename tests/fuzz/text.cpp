#include "tests/fuzz/text.h"

#include <array>
#include <cstdio>

#include "tests/fuzz/script.h"

namespace weft::fuzz {

// All of one overload set, each after those that it calls.

std::string text_of(float value) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.9g", static_cast<double>(value));
    return text.data();
}

template <class Integer>
requires std::is_integral_v<Integer>
static std::string text_of(Integer value) {
    return std::to_string(value);
}
template <class Enum>
requires std::is_enum_v<Enum>
static std::string text_of(Enum value) {
    return std::to_string(static_cast<long long>(value));
}

/// "Name{first, second}".
static std::string braced(const char* name, std::initializer_list<std::string> values) {
    std::string text = std::string(name) + '{';
    const char* separator = "";
    for (const std::string& value : values) {
        text.append(separator).append(value);
        separator = ", ";
    }
    return text + '}';
}

std::string text_of(const Vec3& v) {
    return std::string("(") + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + ")";
}

static std::string text_of(const Jacobi& m) {
    return braced("Jacobi", {text_of(m.iterations), text_of(m.exact_mean_motion)});
}
static std::string text_of(const Chebyshev& m) {
    return braced("Chebyshev", {text_of(m.iterations), text_of(m.exact_mean_motion)});
}
static std::string text_of(const ConjugateGradient& m) {
    return braced("ConjugateGradient", {text_of(m.iterations)});
}
static std::string text_of(const Multilevel& m) {
    return braced("Multilevel", {text_of(m.passes), text_of(m.tolerance)});
}
static std::string text_of(const Xpbd& m) {
    return braced("Xpbd", {text_of(m.iterations)});
}
static std::string text_of(const Fibres& m) {
    return braced("Fibres",
                  {text_of(m.iterations), text_of(m.vertical), text_of(m.horizontal), text_of(m.shear)});
}
static std::string text_of(const SymplecticEuler&) {
    return "SymplecticEuler{}";
}

static std::string text_of(const Sphere& s) {
    return braced("Sphere", {text_of(s.center), text_of(s.radius)});
}
static std::string text_of(const Capsule& s) {
    return braced("Capsule", {text_of(s.a), text_of(s.b), text_of(s.radius)});
}
static std::string text_of(const TaperedCapsule& s) {
    return braced("TaperedCapsule", {text_of(s.a), text_of(s.b), text_of(s.radius_a), text_of(s.radius_b)});
}
static std::string text_of(const Rotation& r) {
    return braced("", {text_of(r.x), text_of(r.y), text_of(r.z), text_of(r.w)});
}
static std::string text_of(const Box& s) {
    return braced("Box", {text_of(s.center), text_of(s.rotation), text_of(s.half_extents)});
}
static std::string text_of(const PlacedShape& s) {
    return braced("PlacedShape", {text_of(s.shape.index), text_of(s.position), text_of(s.rotation)});
}
static std::string text_of(const Plane& s) {
    return braced("Plane", {text_of(s.normal), text_of(s.offset)});
}

std::string text_of(const Collider& collider) {
    return std::visit([](const auto& shape) { return text_of(shape); }, collider.shape) + ", friction " +
           text_of(collider.friction) + ", " +
           braced("surface", {text_of(collider.thickness), text_of(collider.restitution),
                              text_of(collider.layers), text_of(collider.is_trigger)});
}

static std::string text_of(const Fabric& f) {
    return braced("Fabric",
                  {text_of(f.areal_density), text_of(f.warp), text_of(f.weft), text_of(f.shear),
                   text_of(f.bending), text_of(f.bending_ratio), text_of(f.damping), text_of(f.stiffening)});
}
static std::string text_of(const FiniteElements& f) {
    return braced("FiniteElements",
                  {text_of(f.enabled), text_of(f.poisson), text_of(f.dihedral), text_of(f.consistent_mass)});
}
static std::string text_of(const Tethers& t) {
    return braced("Tethers", {text_of(t.enabled), text_of(t.slack)});
}
static std::string text_of(const SelfCollision& s) {
    return braced("SelfCollision", {text_of(s.method), text_of(s.distance), text_of(s.friction),
                                    text_of(s.restitution), text_of(s.layers), text_of(s.mask)});
}
static std::string text_of(const Filling& f) {
    return braced("Filling", {text_of(f.kind), text_of(f.pressure), text_of(f.volume), text_of(f.outside)});
}
std::string text_of(const ClothSettings& s) {
    return braced("ClothSettings", {text_of(s.fabric),
                                    text_of(s.finite_elements),
                                    std::visit([](const auto& method) { return text_of(method); }, s.method),
                                    text_of(s.time_scheme),
                                    text_of(s.substeps),
                                    text_of(s.tethers),
                                    text_of(s.self_collision),
                                    text_of(s.air_damping),
                                    text_of(s.thickness),
                                    text_of(s.friction),
                                    text_of(s.back_friction_ratio),
                                    text_of(s.restitution),
                                    text_of(s.collider_mask),
                                    text_of(s.collider_response),
                                    text_of(s.frame_inertia.linear),
                                    text_of(s.frame_inertia.angular),
                                    text_of(s.frame_inertia.centrifugal),
                                    text_of(s.enabled),
                                    text_of(s.sleep_speed),
                                    text_of(s.importance),
                                    text_of(s.teleport_distance),
                                    text_of(s.teleport_angle),
                                    text_of(s.gravity_scale),
                                    text_of(s.wind_scale),
                                    text_of(s.filling),
                                    std::to_string(s.key)});
}

static std::string text_of(const AirSource& a) {
    return braced("AirSource",
                  {text_of(a.kind), text_of(a.position), text_of(a.velocity), text_of(a.radius)});
}
static std::string text_of(const std::array<AirSource, 8>& sources) {
    std::string text;
    for (const AirSource& each : sources)
        if (each.kind != AirSourceKind::none) text += text_of(each);
    return '{' + text + '}';
}
static std::string text_of(const AirShelter& a) {
    return braced("AirShelter",
                  {text_of(a.kind), text_of(a.position), text_of(a.rotation), text_of(a.half_extents),
                   text_of(a.radius), text_of(a.border), text_of(a.exposure)});
}
static std::string text_of(const std::array<AirShelter, 8>& shelters) {
    std::string text;
    for (const AirShelter& each : shelters)
        if (each.kind != AirShelterKind::none) text += text_of(each);
    return '{' + text + '}';
}
static std::string text_of(const Wind& w) {
    return braced(
        "Wind", {text_of(w.velocity), text_of(w.gust), text_of(w.gust_length), text_of(w.air_density),
                 text_of(w.drag), text_of(w.lift), text_of(w.seed), text_of(w.sources), text_of(w.shelters)});
}
static std::string text_of(const Executor& e) {
    return braced("Executor", {text_of(e.run != nullptr), text_of(e.width)});
}
std::string text_of(const WorldSettings& s) {
    return braced("WorldSettings",
                  {text_of(s.gravity), text_of(s.wind), text_of(s.max_speed), text_of(s.substeps),
                   text_of(s.contact_reports), text_of(s.threads), text_of(s.budget), text_of(s.executor)});
}

std::string text_of(const ClothInfo& i) {
    return braced("ClothInfo", {text_of(i.vertices),
                                text_of(i.particles),
                                text_of(i.welded_vertices),
                                text_of(i.triangles),
                                text_of(i.components),
                                text_of(i.structural_springs),
                                text_of(i.shear_springs),
                                text_of(i.bending_elements),
                                text_of(i.border_edges),
                                text_of(i.dropped_triangles),
                                text_of(i.turned_triangles),
                                text_of(i.flipped_triangles),
                                text_of(i.softened_triangles),
                                text_of(i.misoriented_edges),
                                text_of(i.loose_particles),
                                text_of(i.mean_edge),
                                text_of(i.mass),
                                text_of(i.least_bending),
                                text_of(i.bytes),
                                text_of(i.shared_bytes),
                                text_of(i.scratch_bytes)});
}

static std::string text_of(const Mesh& mesh) {
    return std::to_string(mesh.positions.size()) + " vertices, " + std::to_string(mesh.triangles.size()) +
           " triangles" + (mesh.pattern.empty() ? "" : ", a pattern") +
           (mesh.rows > 0 ? ", " + std::to_string(mesh.rows) + " x " + std::to_string(mesh.columns) : "");
}

static std::string text_of(const std::vector<std::uint32_t>& vertices) {
    std::string text = std::to_string(vertices.size()) + " vertices:";
    for (std::size_t i = 0; i < vertices.size() && i < 8; ++i)
        text.append(" ").append(std::to_string(vertices[i]));
    return vertices.size() > 8 ? text + " ..." : text;
}

static std::string text_of(const AddCloth& call) {
    return "add_cloth(" + text_of(call.mesh) + "; " + text_of(call.settings) +
           (call.cooked ? "; cooked, put to " + text_of(call.place) : "") + ")";
}
static std::string text_of(const MeasureCloth& call) {
    return "measure_cloth(" + text_of(call.mesh) + "; " + text_of(call.settings) + ")";
}
static std::string text_of(const RemoveCloth&) {
    return "remove_cloth()";
}
static std::string text_of(const SetClothSettings& call) {
    return "set_cloth_settings(" + text_of(call.settings) + ")";
}
static std::string text_of(const Pin& call) {
    return "pin(" + text_of(call.vertices) + ")";
}
static std::string text_of(const MovePin& call) {
    return "move_pin(" + text_of(call.vertex) + ", " + text_of(call.target) + ")";
}
static std::string text_of(const Unpin& call) {
    return "unpin(" + text_of(call.vertices) + ")";
}
static std::string text_of(const AddCollider& call) {
    return "add_collider(" + text_of(call.collider) + ")";
}
static std::string text_of(const MoveCollider& call) {
    return "move_collider(" + text_of(call.collider) + ", " + text_of(call.target) + ")";
}
static std::string text_of(const RemoveCollider& call) {
    return "remove_collider(" + text_of(call.collider) + ")";
}
static std::string text_of(const BodySettings& b) {
    return "mass " + text_of(b.mass) + " inertia " + text_of(b.inertia) + " gravity " +
           text_of(b.gravity_scale) + " damping " + text_of(b.damping) + " " + text_of(b.angular_damping);
}
static std::string text_of(const BodyState& b) {
    return "at " + text_of(b.position) + " turned " +
           text_of(Vec3{b.rotation.x, b.rotation.y, b.rotation.z}) + " " + text_of(b.rotation.w) + " going " +
           text_of(b.velocity) + " spinning " + text_of(b.angular_velocity);
}
static std::string text_of(const AddBody& call) {
    return "add_body(" + text_of(call.settings) + "; " + text_of(call.state) + ")";
}
static std::string text_of(const SetBody& call) {
    return "set_body(" + std::to_string(call.body) + ", " + text_of(call.settings) + "; " +
           text_of(call.state) + ")";
}
static std::string text_of(const RemoveBody& call) {
    return "remove_body(" + std::to_string(call.body) + ")";
}
static std::string text_of(const AttachCollider& call) {
    return "attach_collider(" + std::to_string(call.body) + ", " + std::to_string(call.collider) + ")";
}
static std::string text_of(const DetachCollider& call) {
    return "detach_collider(" + std::to_string(call.collider) + ")";
}
static std::string text_of(const Attach& call) {
    return "attach(" + std::to_string(call.body) + ", " + text_of(call.vertices) + ")";
}
static std::string text_of(const Detach& call) {
    return "detach(" + text_of(call.vertices) + ")";
}
static std::string text_of(const Stitch& call) {
    return "stitch(" + text_of(call.vertices) + ", cloth " + text_of(call.other) + ", " +
           text_of(call.others) + ", " +
           braced("SeamSettings", {text_of(call.settings.rest_length), text_of(call.settings.break_force),
                                   text_of(call.settings.stiffness)}) +
           ")";
}
static std::string text_of(const Unstitch& call) {
    return "unstitch(seam " + text_of(call.seam) + ")";
}
static std::string text_of(const SetWorldSettings& call) {
    return "set_settings(" + text_of(call.settings) + ")";
}
static std::string text_of(const Step& call) {
    return "step(" + text_of(call.dt) + (call.apart ? ") in three" : ")");
}
static std::string text_of(const PlaceCollider& call) {
    return "place_collider(" + text_of(call.collider) + ", " + text_of(call.place) + ")";
}
static std::string text_of(const StartTrace& call) {
    return "start_trace(" + text_of(call.max_events) + ")";
}
static std::string text_of(const MoveWorld&) {
    return "the World is moved from and back";
}
static std::string text_of(const MovePins& call) {
    return "move_pins(" + text_of(call.vertices) + ")";
}
static std::string text_of(const AddShape& call) {
    return "add_shape(kind " + std::to_string(static_cast<int>(call.shape.kind)) + ", " +
           std::to_string(call.shape.vertices.size()) + " vertices, " +
           std::to_string(call.shape.triangles.size()) + " triangles)";
}
static std::string text_of(const DeformShape& call) {
    return "deform_shape(" + text_of(call.shape) + ", " + std::to_string(call.vertices.size()) + " vertices)";
}
static std::string text_of(const RemoveShape& call) {
    return "remove_shape(" + text_of(call.shape) + ")";
}
static std::string text_of(const Save&) {
    return "save()";
}
static std::string text_of(const Restore& call) {
    return "restore(save " + text_of(call.save) + (call.damaged ? ", damaged)" : ")");
}

static std::string text_of(const SaveCloth&) {
    return "save_cloth()";
}
static std::string text_of(const RestoreCloth& call) {
    return "restore_cloth(save " + text_of(call.save) + " of a cloth)";
}

static std::string text_of(const Transform& t) {
    return braced("Transform", {text_of(t.translation), text_of(t.rotation)});
}
static std::string text_of(const MoveCloth& call) {
    return "move_cloth(" + text_of(call.by) + ")";
}
static std::string text_of(const ResetCloth& call) {
    return "reset_cloth(" + text_of(call.positions.front()) + " ...)";
}
static std::string text_of(const SetFrame& call) {
    return "set_frame(" + text_of(call.pose) + ")";
}
static std::string text_of(const LeaveFrame&) {
    return "leave_frame()";
}
static std::string text_of(const Recut& call) {
    return "recut_cloth(" + std::to_string(call.cut.added_particles) + " particles more)";
}
static std::string text_of(const SetEnabled& call) {
    return call.on ? "set_enabled(true)" : "set_enabled(false)";
}
static std::string text_of(const Wake&) {
    return "wake()";
}
static std::string text_of(const SetImportance& call) {
    return "set_importance(" + text_of(call.importance) + ")";
}
static std::string text_of(const Ask&) {
    return "all that can be asked";
}
static std::string text_of(const SetMap& call) {
    return "set_map(" + text_of(call.map) + ", " + std::to_string(call.values.size()) + " values)";
}
static std::string text_of(const SetSkin& call) {
    return "set_skin(" + text_of(call.places.front()) + " ...)";
}
static std::string text_of(const ShiftOrigin& call) {
    return "shift_origin(" + text_of(call.to) + ")";
}

std::string text_of(const Operation& operation) {
    std::string text = std::visit([](const auto& call) { return text_of(call); }, operation.call);
    if (operation.cloth != Operation::no_cloth)
        text = "cloth " + std::to_string(operation.cloth) + ": " + text;
    if (operation.answer == Answer::refused) text += "  (to be refused)";
    return text;
}

std::string text_of(const Script& script) {
    std::string text = "World::create(" + text_of(script.world) + ")\n";
    for (std::size_t i = 0; i < script.operations.size(); ++i)
        text += std::to_string(i) + "  " + text_of(script.operations[i]) + '\n';
    return text;
}

}  // namespace weft::fuzz
