#pragma once
// Fields of the structs that a host sets and reads, by name: for recording, replaying, describing, and for C.
// A struct with a new field does not compile until the field has its line: here, or in
// tests/embedding/c/fields_test.cpp, which counts the fields of for_both(). Then raise recording_version.

#include <concepts>
#include <type_traits>
#include <variant>

#include "weft/body.h"
#include "weft/collider.h"
#include "weft/report.h"
#include "weft/seam.h"
#include "weft/settings.h"
#include "weft/shapes.h"
#include "weft/transform.h"
#include "weft/world.h"

namespace weft {

/// The struct whose fields T has: itself, or another one, as for the structs for C.
template <class T>
struct StandsFor : std::type_identity<T> {};
template <class T, class Of>
concept FieldsOf = std::same_as<typename StandsFor<std::remove_const_t<T>>::type, Of>;

// for_both(a, b, way) calls way(name, a.field, b.field) for each field of two structs with the same fields.
// for_each_field(of, visit) calls visit(name, value) for each field of one.

/// Calls visit(name, value) for each pair.
template <class Visit>
void visit_each(const Visit& /*visit*/) {}
template <class Visit, class Value, class... Rest>
void visit_each(const Visit& visit, const char* name, Value& value, Rest&&... rest) {
    visit(name, value);
    visit_each(visit, rest...);
}

template <FieldsOf<Fabric> A, FieldsOf<Fabric> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("areal_density", a.areal_density, b.areal_density);
    way("warp", a.warp, b.warp);
    way("weft", a.weft, b.weft);
    way("shear", a.shear, b.shear);
    way("bending", a.bending, b.bending);
    way("bending_ratio", a.bending_ratio, b.bending_ratio);
    way("damping", a.damping, b.damping);
    way("stiffening", a.stiffening, b.stiffening);
}

template <FieldsOf<FiniteElements> A, FieldsOf<FiniteElements> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("enabled", a.enabled, b.enabled);
    way("poisson", a.poisson, b.poisson);
    way("dihedral", a.dihedral, b.dihedral);
    way("consistent_mass", a.consistent_mass, b.consistent_mass);
}

template <FieldsOf<Tethers> A, FieldsOf<Tethers> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("enabled", a.enabled, b.enabled);
    way("slack", a.slack, b.slack);
}

template <FieldsOf<FrameInertia> A, FieldsOf<FrameInertia> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("linear", a.linear, b.linear);
    way("angular", a.angular, b.angular);
    way("centrifugal", a.centrifugal, b.centrifugal);
}

template <FieldsOf<SelfCollision> A, FieldsOf<SelfCollision> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("method", a.method, b.method);
    way("distance", a.distance, b.distance);
    way("friction", a.friction, b.friction);
    way("restitution", a.restitution, b.restitution);
    way("layers", a.layers, b.layers);
    way("mask", a.mask, b.mask);
}

template <FieldsOf<Jacobi> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [iterations, exact_mean_motion] = of;
    visit_each(visit, "iterations", iterations, "exact_mean_motion", exact_mean_motion);
}
template <FieldsOf<Chebyshev> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [iterations, exact_mean_motion] = of;
    visit_each(visit, "iterations", iterations, "exact_mean_motion", exact_mean_motion);
}
template <FieldsOf<ConjugateGradient> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [iterations] = of;
    visit_each(visit, "iterations", iterations);
}
template <FieldsOf<Multilevel> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [passes, tolerance] = of;
    visit_each(visit, "passes", passes, "tolerance", tolerance);
}
template <FieldsOf<Xpbd> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [iterations] = of;
    visit_each(visit, "iterations", iterations);
}
template <FieldsOf<Fibres> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [iterations, vertical, horizontal, shear] = of;
    visit_each(visit, "iterations", iterations, "vertical", vertical, "horizontal", horizontal, "shear",
               shear);
}
template <FieldsOf<SymplecticEuler> T, class Visit>
void for_each_field(T& /*of*/, const Visit& /*visit*/) {}

template <FieldsOf<Filling> A, FieldsOf<Filling> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("kind", a.kind, b.kind);
    way("pressure", a.pressure, b.pressure);
    way("volume", a.volume, b.volume);
    way("outside", a.outside, b.outside);
}
template <FieldsOf<FillingInfo> A, FieldsOf<FillingInfo> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("open_edges", a.open_edges, b.open_edges);
    way("volume", a.volume, b.volume);
    way("rest_volume", a.rest_volume, b.rest_volume);
    way("pressure", a.pressure, b.pressure);
}

template <FieldsOf<ClothSettings> A, FieldsOf<ClothSettings> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("fabric", a.fabric, b.fabric);
    way("finite_elements", a.finite_elements, b.finite_elements);
    way("method", a.method, b.method);
    way("time_scheme", a.time_scheme, b.time_scheme);
    way("substeps", a.substeps, b.substeps);
    way("tethers", a.tethers, b.tethers);
    way("self_collision", a.self_collision, b.self_collision);
    way("air_damping", a.air_damping, b.air_damping);
    way("thickness", a.thickness, b.thickness);
    way("friction", a.friction, b.friction);
    way("back_friction_ratio", a.back_friction_ratio, b.back_friction_ratio);
    way("restitution", a.restitution, b.restitution);
    way("collider_mask", a.collider_mask, b.collider_mask);
    way("collider_response", a.collider_response, b.collider_response);
    way("enabled", a.enabled, b.enabled);
    way("sleep_speed", a.sleep_speed, b.sleep_speed);
    way("frame_inertia", a.frame_inertia, b.frame_inertia);
    way("importance", a.importance, b.importance);
    way("teleport_distance", a.teleport_distance, b.teleport_distance);
    way("teleport_angle", a.teleport_angle, b.teleport_angle);
    way("gravity_scale", a.gravity_scale, b.gravity_scale);
    way("wind_scale", a.wind_scale, b.wind_scale);
    way("filling", a.filling, b.filling);
    way("key", a.key, b.key);
}

template <FieldsOf<AirSource> A, FieldsOf<AirSource> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("kind", a.kind, b.kind);
    way("position", a.position, b.position);
    way("velocity", a.velocity, b.velocity);
    way("radius", a.radius, b.radius);
}

template <FieldsOf<AirShelter> A, FieldsOf<AirShelter> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("kind", a.kind, b.kind);
    way("position", a.position, b.position);
    way("rotation", a.rotation, b.rotation);
    way("half_extents", a.half_extents, b.half_extents);
    way("radius", a.radius, b.radius);
    way("border", a.border, b.border);
    way("exposure", a.exposure, b.exposure);
}

template <FieldsOf<Wind> A, FieldsOf<Wind> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("velocity", a.velocity, b.velocity);
    way("gust", a.gust, b.gust);
    way("gust_length", a.gust_length, b.gust_length);
    way("air_density", a.air_density, b.air_density);
    way("drag", a.drag, b.drag);
    way("lift", a.lift, b.lift);
    way("seed", a.seed, b.seed);
    way("sources", a.sources, b.sources);
    way("shelters", a.shelters, b.shelters);
}

/// Leaves out the executor, which is the host's.
template <FieldsOf<WorldSettings> A, FieldsOf<WorldSettings> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("gravity", a.gravity, b.gravity);
    way("wind", a.wind, b.wind);
    way("max_speed", a.max_speed, b.max_speed);
    way("substeps", a.substeps, b.substeps);
    way("contact_reports", a.contact_reports, b.contact_reports);
    way("threads", a.threads, b.threads);
    way("budget", a.budget, b.budget);
}

template <FieldsOf<Sphere> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [center, radius] = of;
    visit_each(visit, "center", center, "radius", radius);
}
template <FieldsOf<Capsule> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [a, b, radius] = of;
    visit_each(visit, "a", a, "b", b, "radius", radius);
}
template <FieldsOf<TaperedCapsule> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [a, b, radius_a, radius_b] = of;
    visit_each(visit, "a", a, "b", b, "radius_a", radius_a, "radius_b", radius_b);
}
template <FieldsOf<Box> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [center, rotation, half_extents] = of;
    visit_each(visit, "center", center, "rotation", rotation, "half_extents", half_extents);
}
template <FieldsOf<Plane> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [normal, offset] = of;
    visit_each(visit, "normal", normal, "offset", offset);
}
template <FieldsOf<PlacedShape> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [shape, position, rotation] = of;
    visit_each(visit, "shape", shape, "position", position, "rotation", rotation);
}

template <FieldsOf<Collider> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [shape, friction, thickness, restitution, layers, is_trigger] = of;
    visit_each(visit, "shape", shape, "friction", friction, "thickness", thickness, "restitution",
               restitution, "layers", layers, "is_trigger", is_trigger);
}

template <FieldsOf<BodySettings> A, FieldsOf<BodySettings> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("mass", a.mass, b.mass);
    way("inertia", a.inertia, b.inertia);
    way("gravity_scale", a.gravity_scale, b.gravity_scale);
    way("damping", a.damping, b.damping);
    way("angular_damping", a.angular_damping, b.angular_damping);
}
template <FieldsOf<BodyState> A, FieldsOf<BodyState> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("position", a.position, b.position);
    way("rotation", a.rotation, b.rotation);
    way("velocity", a.velocity, b.velocity);
    way("angular_velocity", a.angular_velocity, b.angular_velocity);
}
template <FieldsOf<Transform> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [translation, rotation] = of;
    visit_each(visit, "translation", translation, "rotation", rotation);
}

template <FieldsOf<ClothReport> A, FieldsOf<ClothReport> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("flags", a.flags, b.flags);
    way("enabled", a.enabled, b.enabled);
    way("asleep", a.asleep, b.asleep);
    way("particles", a.particles, b.particles);
    way("collider_contacts", a.collider_contacts, b.collider_contacts);
    way("self_contacts", a.self_contacts, b.self_contacts);
    way("peak_self_contacts", a.peak_self_contacts, b.peak_self_contacts);
    way("truncated_particles", a.truncated_particles, b.truncated_particles);
    way("crossings", a.crossings, b.crossings);
    way("unresolved_pairs", a.unresolved_pairs, b.unresolved_pairs);
    way("pin_lag", a.pin_lag, b.pin_lag);
    way("limits_exceeded", a.limits_exceeded, b.limits_exceeded);
    way("limit_lag", a.limit_lag, b.limit_lag);
    way("peak_speed", a.peak_speed, b.peak_speed);
    way("residual", a.residual, b.residual);
    way("rung", a.rung, b.rung);
    way("rate", a.rate, b.rate);
    way("milliseconds", a.milliseconds, b.milliseconds);
}
template <FieldsOf<StepReport> A, FieldsOf<StepReport> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("flags", a.flags, b.flags);
    way("step", a.step, b.step);
    way("substeps", a.substeps, b.substeps);
    way("cloths", a.cloths, b.cloths);
    way("sleeping_cloths", a.sleeping_cloths, b.sleeping_cloths);
    way("reduced_cloths", a.reduced_cloths, b.reduced_cloths);
    way("particles", a.particles, b.particles);
    way("collider_contacts", a.collider_contacts, b.collider_contacts);
    way("self_contacts", a.self_contacts, b.self_contacts);
    way("contacts", a.contacts, b.contacts);
    way("peak_self_contacts", a.peak_self_contacts, b.peak_self_contacts);
    way("truncated_particles", a.truncated_particles, b.truncated_particles);
    way("pin_lag", a.pin_lag, b.pin_lag);
    way("limits_exceeded", a.limits_exceeded, b.limits_exceeded);
    way("limit_lag", a.limit_lag, b.limit_lag);
    way("crossings", a.crossings, b.crossings);
    way("unresolved_pairs", a.unresolved_pairs, b.unresolved_pairs);
    way("restored_cloths", a.restored_cloths, b.restored_cloths);
    way("peak_speed", a.peak_speed, b.peak_speed);
    way("residual", a.residual, b.residual);
    way("milliseconds", a.milliseconds, b.milliseconds);
    way("broken_stitches", a.broken_stitches, b.broken_stitches);
}

template <FieldsOf<SeamSettings> A, FieldsOf<SeamSettings> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("rest_length", a.rest_length, b.rest_length);
    way("break_force", a.break_force, b.break_force);
    way("stiffness", a.stiffness, b.stiffness);
}
template <FieldsOf<SeamInfo> A, FieldsOf<SeamInfo> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("a", a.a, b.a);
    way("b", a.b, b.b);
    way("stitches", a.stitches, b.stitches);
    way("holding", a.holding, b.holding);
    way("force", a.force, b.force);
    way("tightest", a.tightest, b.tightest);
}

template <FieldsOf<ClothInfo> A, FieldsOf<ClothInfo> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("vertices", a.vertices, b.vertices);
    way("particles", a.particles, b.particles);
    way("welded_vertices", a.welded_vertices, b.welded_vertices);
    way("triangles", a.triangles, b.triangles);
    way("components", a.components, b.components);
    way("structural_springs", a.structural_springs, b.structural_springs);
    way("shear_springs", a.shear_springs, b.shear_springs);
    way("bending_elements", a.bending_elements, b.bending_elements);
    way("border_edges", a.border_edges, b.border_edges);
    way("dropped_triangles", a.dropped_triangles, b.dropped_triangles);
    way("turned_triangles", a.turned_triangles, b.turned_triangles);
    way("flipped_triangles", a.flipped_triangles, b.flipped_triangles);
    way("softened_triangles", a.softened_triangles, b.softened_triangles);
    way("misoriented_edges", a.misoriented_edges, b.misoriented_edges);
    way("loose_particles", a.loose_particles, b.loose_particles);
    way("mean_edge", a.mean_edge, b.mean_edge);
    way("mass", a.mass, b.mass);
    way("least_bending", a.least_bending, b.least_bending);
    way("bytes", a.bytes, b.bytes);
    way("shared_bytes", a.shared_bytes, b.shared_bytes);
    way("scratch_bytes", a.scratch_bytes, b.scratch_bytes);
}
template <FieldsOf<ShapeInfo> A, FieldsOf<ShapeInfo> B, class Way>
constexpr void for_both(A& a, B& b, const Way& way) {
    way("triangles", a.triangles, b.triangles);
    way("bounds", a.bounds, b.bounds);
    way("error", a.error, b.error);
    way("bytes", a.bytes, b.bytes);
}
template <FieldsOf<Bounds> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [lower, upper] = of;
    visit_each(visit, "lower", lower, "upper", upper);
}

struct AnyVisit {
    template <class... Values>
    void operator()(const char* /*name*/, Values&... /*values*/) const {}
};
template <class A, class B>
concept HaveFields = requires(A& a, B& b) {
    for_both(a, b, AnyVisit{});
};
template <class T, class Visit>
requires HaveFields<T, T>
void for_each_field(T& of, const Visit& visit) {
    for_both(of, of, [&](const char* name, auto& value, auto& /*same*/) { visit(name, value); });
}
/// Structs that for_each_field() supports.
template <class T>
concept HasFields = requires(T& of) {
    for_each_field(of, AnyVisit{});
};

}  // namespace weft
