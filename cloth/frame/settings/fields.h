#pragma once
// The fields of what a host sets, by name: for writing down, reading back and describing. A struct that gets
// another field does not compile here until the field has its line; then raise recording_version.

#include <concepts>
#include <type_traits>
#include <variant>

#include "weft/body.h"
#include "weft/collider.h"
#include "weft/report.h"
#include "weft/settings.h"
#include "weft/shapes.h"
#include "weft/transform.h"
#include "weft/world.h"

namespace weft {

/// T is Of, const or not.
template <class T, class Of>
concept FieldsOf = std::same_as<std::remove_const_t<T>, Of>;

/// visit(name, value) for each pair.
template <class Visit>
void visit_each(const Visit& /*visit*/) {}
template <class Visit, class Value, class... Rest>
void visit_each(const Visit& visit, const char* name, Value& value, Rest&&... rest) {
    visit(name, value);
    visit_each(visit, rest...);
}

template <FieldsOf<Fabric> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [areal_density, warp, weft, shear, bending, damping, stiffening] = of;
    visit_each(visit, "areal_density", areal_density, "warp", warp, "weft", weft, "shear", shear, "bending",
               bending, "damping", damping, "stiffening", stiffening);
}

template <FieldsOf<FiniteElements> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [enabled, poisson, dihedral, consistent_mass] = of;
    visit_each(visit, "enabled", enabled, "poisson", poisson, "dihedral", dihedral, "consistent_mass",
               consistent_mass);
}

template <FieldsOf<Tethers> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [enabled, slack] = of;
    visit_each(visit, "enabled", enabled, "slack", slack);
}

template <FieldsOf<FrameInertia> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [linear, angular, centrifugal] = of;
    visit_each(visit, "linear", linear, "angular", angular, "centrifugal", centrifugal);
}

template <FieldsOf<SelfCollision> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [enabled, method, distance, friction, search, restitution, layers, mask] = of;
    visit_each(visit, "enabled", enabled, "method", method, "distance", distance, "friction", friction,
               "search", search, "restitution", restitution, "layers", layers, "mask", mask);
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
    auto& [passes, iterations, effort, tolerance] = of;
    visit_each(visit, "passes", passes, "iterations", iterations, "effort", effort, "tolerance", tolerance);
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

template <FieldsOf<ClothSettings> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [fabric, finite_elements, method, time_scheme, substeps, tethers, self_collision, air_damping,
           thickness, friction, restitution, collider_mask, collider_response, enabled, sleep_speed,
           frame_inertia, priority, view_distance] = of;
    visit_each(visit, "fabric", fabric, "finite_elements", finite_elements, "method", method, "time_scheme",
               time_scheme, "substeps", substeps, "tethers", tethers, "self_collision", self_collision,
               "air_damping", air_damping, "thickness", thickness, "friction", friction, "restitution",
               restitution, "collider_mask", collider_mask, "collider_response", collider_response, "enabled",
               enabled, "sleep_speed", sleep_speed, "frame_inertia", frame_inertia, "priority", priority,
               "view_distance", view_distance);
}

template <FieldsOf<AirSource> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [kind, position, velocity, radius] = of;
    visit_each(visit, "kind", kind, "position", position, "velocity", velocity, "radius", radius);
}

template <FieldsOf<Wind> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [velocity, gust, gust_length, air_density, drag, lift, seed, sources] = of;
    visit_each(visit, "velocity", velocity, "gust", gust, "gust_length", gust_length, "air_density",
               air_density, "drag", drag, "lift", lift, "seed", seed, "sources", sources);
}

/// But for the executor, which is the host's.
template <FieldsOf<WorldSettings> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [gravity, wind, max_speed, substeps, contact_reports, threads, budget, executor] = of;
    static_cast<void>(executor);
    visit_each(visit, "gravity", gravity, "wind", wind, "max_speed", max_speed, "substeps", substeps,
               "contact_reports", contact_reports, "threads", threads, "budget", budget);
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

template <FieldsOf<BodySettings> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [mass, inertia, gravity_scale, damping, angular_damping] = of;
    visit_each(visit, "mass", mass, "inertia", inertia, "gravity_scale", gravity_scale, "damping", damping,
               "angular_damping", angular_damping);
}
template <FieldsOf<BodyState> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [position, rotation, velocity, angular_velocity] = of;
    visit_each(visit, "position", position, "rotation", rotation, "velocity", velocity, "angular_velocity",
               angular_velocity);
}
template <FieldsOf<Transform> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [translation, rotation] = of;
    visit_each(visit, "translation", translation, "rotation", rotation);
}

template <FieldsOf<ClothReport> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [flags, enabled, asleep, particles, collider_contacts, self_contacts, peak_self_contacts,
           truncated_particles, crossings, unresolved_pairs, pin_lag, limits_exceeded, limit_lag, peak_speed,
           residual, rung, rate, milliseconds] = of;
    visit_each(visit, "flags", flags, "enabled", enabled, "asleep", asleep, "particles", particles,
               "collider_contacts", collider_contacts, "self_contacts", self_contacts, "peak_self_contacts",
               peak_self_contacts, "truncated_particles", truncated_particles, "crossings", crossings,
               "unresolved_pairs", unresolved_pairs, "pin_lag", pin_lag, "limits_exceeded", limits_exceeded,
               "limit_lag", limit_lag, "peak_speed", peak_speed, "residual", residual, "rung", rung, "rate",
               rate, "milliseconds", milliseconds);
}
template <FieldsOf<StepReport> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [flags, step, substeps, cloths, sleeping_cloths, reduced_cloths, particles, collider_contacts,
           self_contacts, contacts, peak_self_contacts, truncated_particles, pin_lag, limits_exceeded,
           limit_lag, crossings, unresolved_pairs, restored_cloths, peak_speed, residual, milliseconds] = of;
    visit_each(visit, "flags", flags, "step", step, "substeps", substeps, "cloths", cloths, "sleeping_cloths",
               sleeping_cloths, "reduced_cloths", reduced_cloths, "particles", particles, "collider_contacts",
               collider_contacts, "self_contacts", self_contacts, "contacts", contacts, "peak_self_contacts",
               peak_self_contacts, "truncated_particles", truncated_particles, "pin_lag", pin_lag,
               "limits_exceeded", limits_exceeded, "limit_lag", limit_lag, "crossings", crossings,
               "unresolved_pairs", unresolved_pairs, "restored_cloths", restored_cloths, "peak_speed",
               peak_speed, "residual", residual, "milliseconds", milliseconds);
}

template <FieldsOf<ClothInfo> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [vertices, particles, welded_vertices, triangles, components, structural_springs, shear_springs,
           bending_elements, border_edges, dropped_triangles, turned_triangles, misoriented_edges,
           loose_particles, mean_edge, mass, least_bending, bytes, shared_bytes] = of;
    visit_each(visit, "vertices", vertices, "particles", particles, "welded_vertices", welded_vertices,
               "triangles", triangles, "components", components, "structural_springs", structural_springs,
               "shear_springs", shear_springs, "bending_elements", bending_elements, "border_edges",
               border_edges, "dropped_triangles", dropped_triangles, "turned_triangles", turned_triangles,
               "misoriented_edges", misoriented_edges, "loose_particles", loose_particles, "mean_edge",
               mean_edge, "mass", mass, "least_bending", least_bending, "bytes", bytes, "shared_bytes",
               shared_bytes);
}
template <FieldsOf<ShapeInfo> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [triangles, bounds, error, bytes] = of;
    visit_each(visit, "triangles", triangles, "bounds", bounds, "error", error, "bytes", bytes);
}
template <FieldsOf<Bounds> T, class Visit>
void for_each_field(T& of, const Visit& visit) {
    auto& [lower, upper] = of;
    visit_each(visit, "lower", lower, "upper", upper);
}

struct AnyVisit {
    template <class Value>
    void operator()(const char* /*name*/, Value& /*value*/) const {}
};
/// for_each_field() knows it.
template <class T>
concept HasFields = requires(T& of) {
    for_each_field(of, AnyVisit{});
};

}  // namespace weft
