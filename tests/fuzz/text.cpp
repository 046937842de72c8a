#include "tests/fuzz/text.h"

#include <array>
#include <cstdio>
#include <type_traits>
#include <variant>

#include "cloth/settings/fields.h"
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

static std::string text_of(ShapeId id) {
    return text_of(id.index);
}
std::string text_of(const Vec3& v) {
    return std::string("(") + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + ")";
}
static std::string text_of(const Rotation& r) {
    return "{" + text_of(r.x) + ", " + text_of(r.y) + ", " + text_of(r.z) + ", " + text_of(r.w) + "}";
}

/// "Tethers{enabled 0, slack 1}".
template <HasFields T>
std::string text_of(const T& of);
template <class... Kinds>
static std::string text_of(const std::variant<Kinds...>& of) {
    return std::visit([](const auto& one) { return text_of(one); }, of);
}
/// Leaves out sources and shelters that are none.
template <class T, std::size_t count>
static std::string text_of(const std::array<T, count>& all) {
    std::string text;
    for (const T& each : all)
        if (static_cast<int>(each.kind) != 0) text += text_of(each);
    return '{' + text + '}';
}
template <HasFields T>
std::string text_of(const T& of) {
    std::string text;
    for_each_field(of, [&](const char* name, const auto& value) {
        text.append(text.empty() ? "" : ", ").append(name).append(" ").append(text_of(value));
    });
    return std::string(struct_name(of)) + '{' + text + '}';
}

std::string text_of(const Collider& collider) {
    return text_of<Collider>(collider);
}
std::string text_of(const ClothSettings& settings) {
    return text_of<ClothSettings>(settings);
}
std::string text_of(const WorldSettings& settings) {
    return text_of<WorldSettings>(settings) + ", executor " + text_of(settings.executor.run != nullptr) +
           " of width " + text_of(settings.executor.width);
}
std::string text_of(const ClothInfo& info) {
    return text_of<ClothInfo>(info);
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
           text_of(call.others) + ", " + text_of(call.settings) + ")";
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

static std::string text_of(const MoveCloth& call) {
    return "move_cloth(" + text_of(call.by) + ")";
}
static std::string text_of(const ResetCloth& call) {
    if (call.velocities.empty()) return "reset_cloth(" + text_of(call.positions.front()) + " ...)";
    return "resume_cloth(" + text_of(call.positions.front()) + " ..., at " +
           text_of(call.velocities.front()) + " m/s)";
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
