#include "tests/fuzz/text.h"

#include <array>
#include <cstdio>
#include <cstring>
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

static std::string text_of(const OwnedShape& shape) {
    return "kind " + text_of(shape.kind) + ", " + text_of(shape.vertices.size()) + " vertices, " +
           text_of(shape.triangles.size()) + " triangles";
}
static std::string text_of(const MeshCut& cut) {
    return text_of(cut.added_particles) + " particles more";
}
/// "3: 7 8 9", at most eight of them.
template <class T>
static std::string text_of(const std::vector<T>& all) {
    std::string text = text_of(all.size()) + ":";
    for (std::size_t i = 0; i < all.size() && i < 8; ++i) text.append(" ").append(text_of(all[i]));
    return all.size() > 8 ? text + " ..." : text;
}

/// The calls by name, in the order of Operation::call.
constexpr const char* names[] = {"add_cloth",
                                 "measure_cloth",
                                 "remove_cloth",
                                 "set_cloth_settings",
                                 "pin",
                                 "move_pin",
                                 "unpin",
                                 "add_collider",
                                 "move_collider",
                                 "place_collider",
                                 "remove_collider",
                                 "add_body",
                                 "set_body",
                                 "remove_body",
                                 "attach_collider",
                                 "attach",
                                 "detach",
                                 "set_settings",
                                 "step",
                                 "start_trace",
                                 "move the World",
                                 "move_cloth",
                                 "reset_cloth",
                                 "set_frame",
                                 "leave_frame",
                                 "set_map",
                                 "set_skin",
                                 "shift_origin",
                                 "move_pins",
                                 "add_shape",
                                 "deform_shape",
                                 "remove_shape",
                                 "save",
                                 "restore",
                                 "recut_cloth",
                                 "set_enabled",
                                 "wake",
                                 "set_importance",
                                 "detach_collider",
                                 "ask",
                                 "stitch",
                                 "unstitch",
                                 "save_cloth",
                                 "restore_cloth"};
static_assert(std::size(names) == std::variant_size_v<decltype(Operation::call)>);

template <class... Fields>
static std::string joined(const Fields&... fields) {
    std::string text;
    (text.append(text.empty() ? "" : "; ").append(text_of(fields)), ...);
    return text;
}

/// Initialises any field.
struct Anything {
    template <class T>
    operator T() const;
};
/// The call's arguments: the fields of its struct.
template <class Call>
static std::string arguments_of(const Call& call) {
    using Any = Anything;
    if constexpr (requires { Call{Any{}, Any{}, Any{}, Any{}, Any{}}; }) {
        const auto& [a, b, c, d, e] = call;
        return joined(a, b, c, d, e);
    } else if constexpr (requires { Call{Any{}, Any{}, Any{}, Any{}}; }) {
        const auto& [a, b, c, d] = call;
        return joined(a, b, c, d);
    } else if constexpr (requires { Call{Any{}, Any{}, Any{}}; }) {
        const auto& [a, b, c] = call;
        return joined(a, b, c);
    } else if constexpr (requires { Call{Any{}, Any{}}; }) {
        const auto& [a, b] = call;
        return joined(a, b);
    } else if constexpr (!std::is_empty_v<Call>) {
        const auto& [a] = call;
        return joined(a);
    } else {
        return "";
    }
}

std::string text_of(const Operation& operation) {
    std::string text = names[operation.call.index()];
    text += '(' + std::visit([](const auto& call) { return arguments_of(call); }, operation.call) + ')';
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

std::uint64_t fingerprint(std::span<const Vec4> values, std::uint64_t hash) {
    constexpr std::uint64_t prime = 0x100000001b3u;  // FNV-1a, eight bytes at a time
    for (const Vec4& value : values) {
        std::uint64_t words[2];
        std::memcpy(words, &value, sizeof words);
        for (const std::uint64_t word : words) hash = (hash ^ word) * prime;
    }
    return hash;
}

std::string snapshot(const World& world, std::span<const ClothId> cloths,
                     std::span<const ColliderId> colliders) {
    std::string text = text_of(world.settings()) + "\nhash " + std::to_string(world.state_hash()) +
                       "\nstep " + std::to_string(world.report().step) + '\n';
    for (const ClothId id : cloths) {
        const auto found = world.cloth(id);
        if (!found) continue;
        std::uint64_t hash = 0;
        for (const auto& buffer :
             {found->positions, found->previous_positions, found->velocities, found->normals})
            hash = fingerprint(buffer, hash);
        text += text_of(world.cloth_settings(id).value()) + '\n' + text_of(world.cloth_info(id).value()) +
                '\n' + std::to_string(hash) + '\n';
    }
    for (const ColliderId id : colliders)
        if (const auto found = world.collider(id)) text += text_of(*found) + '\n';
    return text;
}

}  // namespace weft::fuzz
