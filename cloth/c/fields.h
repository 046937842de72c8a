#pragma once
// Which field of a struct for C is which of C++: each pair once, for both ways. fields(way, c, of): a way
// assigns one of the two to the other. tests/embedding/c/fields_test.cpp fails where a field of fields.h has
// none here.

#include <concepts>
#include <type_traits>

#include "weft/c/reports.h"
#include "weft/c/settings.h"
#include "weft/weft.h"

namespace weft::c {

template <class T, class Of>
concept Is = std::same_as<std::remove_const_t<T>, Of>;

template <class Way>
void fields(const Way& way, Is<WeftFabric> auto& c, Is<Fabric> auto& of) {
    way(c.areal_density, of.areal_density);
    way(c.warp, of.warp);
    way(c.weft, of.weft);
    way(c.shear, of.shear);
    way(c.bending, of.bending);
    way(c.damping, of.damping);
    way(c.stiffening, of.stiffening);
}
template <class Way>
void fields(const Way& way, Is<WeftFiniteElements> auto& c, Is<FiniteElements> auto& of) {
    way(c.enabled, of.enabled);
    way(c.poisson, of.poisson);
    way(c.dihedral, of.dihedral);
    way(c.consistent_mass, of.consistent_mass);
}
template <class Way>
void fields(const Way& way, Is<WeftTethers> auto& c, Is<Tethers> auto& of) {
    way(c.enabled, of.enabled);
    way(c.slack, of.slack);
}
template <class Way>
void fields(const Way& way, Is<WeftFrameInertia> auto& c, Is<FrameInertia> auto& of) {
    way(c.linear, of.linear);
    way(c.angular, of.angular);
    way(c.centrifugal, of.centrifugal);
}
template <class Way>
void fields(const Way& way, Is<WeftSelfCollision> auto& c, Is<SelfCollision> auto& of) {
    way(c.enabled, of.enabled);
    way(c.method, of.method);
    way(c.distance, of.distance);
    way(c.friction, of.friction);
    way(c.search, of.search);
    way(c.restitution, of.restitution);
    way(c.layers, of.layers);
    way(c.mask, of.mask);
}

template <class Way>
void fields(const Way& way, Is<WeftMethod> auto& c, Is<Multilevel> auto& of) {
    way(c.passes, of.passes);
    way(c.iterations, of.iterations);
    way(c.effort, of.effort);
    way(c.tolerance, of.tolerance);
}
template <class Way, class Of>
requires Is<Of, Jacobi> || Is<Of, Chebyshev>
void fields(const Way& way, Is<WeftMethod> auto& c, Of& of) {
    way(c.iterations, of.iterations);
    way(c.exact_mean_motion, of.exact_mean_motion);
}
template <class Way, class Of>
requires Is<Of, ConjugateGradient> || Is<Of, Xpbd>
void fields(const Way& way, Is<WeftMethod> auto& c, Of& of) {
    way(c.iterations, of.iterations);
}
template <class Way>
void fields(const Way& way, Is<WeftMethod> auto& c, Is<Fibres> auto& of) {
    way(c.iterations, of.iterations);
    way(c.vertical, of.vertical);
    way(c.horizontal, of.horizontal);
    way(c.shear, of.shear);
}
template <class Way>
void fields(const Way& /*way*/, Is<WeftMethod> auto& /*c*/, Is<SymplecticEuler> auto& /*of*/) {}

template <class Way>
void fields(const Way& way, Is<WeftClothSettings> auto& c, Is<ClothSettings> auto& of) {
    way(c.fabric, of.fabric);
    way(c.finite_elements, of.finite_elements);
    way.variant(c.method, c.method.kind, of.method);
    way(c.time_scheme, of.time_scheme);
    way(c.substeps, of.substeps);
    way(c.tethers, of.tethers);
    way(c.self_collision, of.self_collision);
    way(c.air_damping, of.air_damping);
    way(c.thickness, of.thickness);
    way(c.friction, of.friction);
    way(c.restitution, of.restitution);
    way(c.collider_mask, of.collider_mask);
    way(c.collider_response, of.collider_response);
    way(c.enabled, of.enabled);
    way(c.sleep_speed, of.sleep_speed);
    way(c.frame_inertia, of.frame_inertia);
    way(c.priority, of.priority);
    way(c.view_distance, of.view_distance);
}

template <class Way>
void fields(const Way& way, Is<WeftAirSource> auto& c, Is<AirSource> auto& of) {
    way(c.kind, of.kind);
    way(c.position, of.position);
    way(c.velocity, of.velocity);
    way(c.radius, of.radius);
}
template <class Way>
void fields(const Way& way, Is<WeftWind> auto& c, Is<Wind> auto& of) {
    way(c.velocity, of.velocity);
    way(c.gust, of.gust);
    way(c.gust_length, of.gust_length);
    way(c.air_density, of.air_density);
    way(c.drag, of.drag);
    way(c.lift, of.lift);
    way(c.seed, of.seed);
    static_assert(std::size(decltype(c.sources){}) == std::size(decltype(of.sources){}));
    for (std::size_t k = 0; k < of.sources.size(); ++k) way(c.sources[k], of.sources[k]);
}
/// But for the executor, which the World's handle keeps.
template <class Way>
void fields(const Way& way, Is<WeftWorldSettings> auto& c, Is<WorldSettings> auto& of) {
    way(c.gravity, of.gravity);
    way(c.wind, of.wind);
    way(c.max_speed, of.max_speed);
    way(c.substeps, of.substeps);
    way(c.contact_reports, of.contact_reports);
    way(c.threads, of.threads);
    way(c.budget, of.budget);
}

template <class Way>
void fields(const Way& way, Is<WeftCollider> auto& c, Is<Sphere> auto& of) {
    way(c.center, of.center);
    way(c.radius, of.radius);
}
template <class Way>
void fields(const Way& way, Is<WeftCollider> auto& c, Is<Capsule> auto& of) {
    way(c.a, of.a);
    way(c.b, of.b);
    way(c.radius, of.radius);
}
template <class Way>
void fields(const Way& way, Is<WeftCollider> auto& c, Is<Plane> auto& of) {
    way(c.normal, of.normal);
    way(c.offset, of.offset);
}
template <class Way>
void fields(const Way& way, Is<WeftCollider> auto& c, Is<TaperedCapsule> auto& of) {
    way(c.a, of.a);
    way(c.b, of.b);
    way(c.radius, of.radius_a);
    way(c.radius_b, of.radius_b);
}
template <class Way>
void fields(const Way& way, Is<WeftCollider> auto& c, Is<Box> auto& of) {
    way(c.center, of.center);
    way(c.rotation, of.rotation);
    way(c.half_extents, of.half_extents);
}
template <class Way>
void fields(const Way& way, Is<WeftCollider> auto& c, Is<PlacedShape> auto& of) {
    way(c.shape, of.shape);
    way(c.center, of.position);
    way(c.rotation, of.rotation);
}
template <class Way>
void fields(const Way& way, Is<WeftCollider> auto& c, Is<Collider> auto& of) {
    way.variant(c, c.kind, of.shape);
    way(c.friction, of.friction);
    way(c.thickness, of.thickness);
    way(c.restitution, of.restitution);
    way(c.layers, of.layers);
    way(c.is_trigger, of.is_trigger);
}

template <class Way>
void fields(const Way& way, Is<WeftBodySettings> auto& c, Is<BodySettings> auto& of) {
    way(c.mass, of.mass);
    way(c.inertia, of.inertia);
    way(c.gravity_scale, of.gravity_scale);
    way(c.damping, of.damping);
    way(c.angular_damping, of.angular_damping);
}
template <class Way>
void fields(const Way& way, Is<WeftBodyState> auto& c, Is<BodyState> auto& of) {
    way(c.position, of.position);
    way(c.rotation, of.rotation);
    way(c.velocity, of.velocity);
    way(c.angular_velocity, of.angular_velocity);
}
template <class Way>
void fields(const Way& way, Is<WeftSheetSettings> auto& c, Is<SheetSettings> auto& of) {
    way(c.rows, of.rows);
    way(c.columns, of.columns);
    way(c.origin, of.origin);
    way(c.u, of.u);
    way(c.v, of.v);
}
template <class Way>
void fields(const Way& way, Is<WeftDrawnMeshSettings> auto& c, Is<DrawnMeshSettings> auto& of) {
    way(c.rounding, of.rounding);
    way(c.reach, of.reach);
}
template <class Way>
void fields(const Way& way, Is<WeftFixedStepSettings> auto& c, Is<FixedStepSettings> auto& of) {
    way(c.step, of.step);
    way(c.max_steps_per_frame, of.max_steps_per_frame);
}

template <class Way>
void fields(const Way& way, Is<WeftClothReport> auto& c, Is<ClothReport> auto& of) {
    way(c.flags, of.flags);
    way(c.enabled, of.enabled);
    way(c.asleep, of.asleep);
    way(c.particles, of.particles);
    way(c.collider_contacts, of.collider_contacts);
    way(c.self_contacts, of.self_contacts);
    way(c.peak_self_contacts, of.peak_self_contacts);
    way(c.truncated_particles, of.truncated_particles);
    way(c.crossings, of.crossings);
    way(c.unresolved_pairs, of.unresolved_pairs);
    way(c.pin_lag, of.pin_lag);
    way(c.limits_exceeded, of.limits_exceeded);
    way(c.limit_lag, of.limit_lag);
    way(c.peak_speed, of.peak_speed);
    way(c.residual, of.residual);
    way(c.rung, of.rung);
    way(c.rate, of.rate);
    way(c.milliseconds, of.milliseconds);
}
template <class Way>
void fields(const Way& way, Is<WeftStepReport> auto& c, Is<StepReport> auto& of) {
    way(c.flags, of.flags);
    way(c.step, of.step);
    way(c.substeps, of.substeps);
    way(c.cloths, of.cloths);
    way(c.sleeping_cloths, of.sleeping_cloths);
    way(c.reduced_cloths, of.reduced_cloths);
    way(c.particles, of.particles);
    way(c.collider_contacts, of.collider_contacts);
    way(c.self_contacts, of.self_contacts);
    way(c.contacts, of.contacts);
    way(c.peak_self_contacts, of.peak_self_contacts);
    way(c.truncated_particles, of.truncated_particles);
    way(c.pin_lag, of.pin_lag);
    way(c.limits_exceeded, of.limits_exceeded);
    way(c.limit_lag, of.limit_lag);
    way(c.crossings, of.crossings);
    way(c.unresolved_pairs, of.unresolved_pairs);
    way(c.restored_cloths, of.restored_cloths);
    way(c.peak_speed, of.peak_speed);
    way(c.residual, of.residual);
    way(c.milliseconds, of.milliseconds);
}
template <class Way>
void fields(const Way& way, Is<WeftClothInfo> auto& c, Is<ClothInfo> auto& of) {
    way(c.vertices, of.vertices);
    way(c.particles, of.particles);
    way(c.welded_vertices, of.welded_vertices);
    way(c.triangles, of.triangles);
    way(c.components, of.components);
    way(c.structural_springs, of.structural_springs);
    way(c.shear_springs, of.shear_springs);
    way(c.bending_elements, of.bending_elements);
    way(c.border_edges, of.border_edges);
    way(c.dropped_triangles, of.dropped_triangles);
    way(c.turned_triangles, of.turned_triangles);
    way(c.misoriented_edges, of.misoriented_edges);
    way(c.loose_particles, of.loose_particles);
    way(c.mean_edge, of.mean_edge);
    way(c.mass, of.mass);
    way(c.least_bending, of.least_bending);
    way(c.bytes, of.bytes);
    way(c.shared_bytes, of.shared_bytes);
}
template <class Way>
void fields(const Way& way, Is<WeftShapeInfo> auto& c, Is<ShapeInfo> auto& of) {
    way(c.triangles, of.triangles);
    way(c.bounds, of.bounds);
    way(c.error, of.error);
    way(c.bytes, of.bytes);
}

}  // namespace weft::c
