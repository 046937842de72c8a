#pragma once
// Fields of the structs that a host sets and reads, with the ranges that their headers state
// (engine/fields.h). A struct with a new field does not compile in tests/embedding/c/fields_test.cpp until
// the field has its line here. Then raise recording_version.

#include <limits>

#include "cloth/mesh/cook.h"
#include "cloth/mesh/coordinates.h"
#include "collision/shapes/collider_fields.h"
#include "engine/fields.h"
#include "weft/body.h"
#include "weft/report.h"
#include "weft/seam.h"
#include "weft/settings.h"
#include "weft/shapes.h"
#include "weft/transform.h"
#include "weft/world.h"

namespace weft {

// No step overflows, even with all settings at their ends: a force of 1e9 N/m on the lightest particle leaves
// squares of its acceleration within single precision.
inline constexpr float most_stiffness = 1e9f;  // [N/m]
inline constexpr float most_iterations = 100000;
inline constexpr Range runaway_range{-runaway_distance, runaway_distance};
inline constexpr Range air_size_range{1e-3f, 1e5f};  // [m]

WEFT_FIELDS_OF(Fabric) {
    WEFT_FIELD(areal_density, 1e-4f, 1e4f);
    WEFT_FIELD(warp, 0, most_stiffness);
    WEFT_FIELD(weft, 0, most_stiffness);
    WEFT_FIELD(shear, 0, most_stiffness);
    WEFT_FIELD(bending, 0, 1e4f);
    WEFT_FIELD(bending_ratio, least_bending_ratio, greatest_bending_ratio);
    WEFT_FIELD(damping, 0, 100);
    WEFT_FIELD(stiffening, 0, 1000);
}

WEFT_FIELDS_OF(FiniteElements) {
    WEFT_FIELD(enabled);
    WEFT_FIELD(poisson, 0, 0.5f, Ends::open_above);
    WEFT_FIELD(dihedral);
    WEFT_FIELD(consistent_mass);
}

WEFT_FIELDS_OF(Tethers) {
    WEFT_FIELD(enabled);
    WEFT_FIELD(slack, 1, 1e3f);
}

WEFT_FIELDS_OF(FrameInertia) {
    WEFT_FIELD(linear, 0, 1);
    WEFT_FIELD(angular, 0, 1);
    WEFT_FIELD(centrifugal, 0, 1);
}

WEFT_FIELDS_OF(SelfCollision) {
    WEFT_FIELD(method);
    WEFT_FIELD(distance, 1e-6f, 10, Ends::or_zero);
    WEFT_FIELD(friction, 0, 1000);
    WEFT_FIELD(restitution, 0, 1);
    WEFT_FIELD(layers);
    WEFT_FIELD(mask);
}

WEFT_FIELDS_OF(Jacobi) {
    WEFT_FIELD(iterations, 0, most_iterations);
    WEFT_FIELD(exact_mean_motion);
}
WEFT_FIELDS_OF(Chebyshev) {
    WEFT_FIELD(iterations, 1, most_iterations);
    WEFT_FIELD(exact_mean_motion);
}
WEFT_FIELDS_OF(ConjugateGradient) {
    WEFT_FIELD(iterations, 1, most_iterations);
}
WEFT_FIELDS_OF(Multilevel) {
    WEFT_FIELD(passes, 1, most_iterations);
    WEFT_FIELD(tolerance, 0, 1e9f);
}
WEFT_FIELDS_OF(Xpbd) {
    WEFT_FIELD(iterations, 1, most_iterations);
}
WEFT_FIELDS_OF(Fibres) {
    WEFT_FIELD(iterations, 1, most_iterations);
    WEFT_FIELD(vertical);
    WEFT_FIELD(horizontal);
    WEFT_FIELD(shear);
}
WEFT_FIELDS_OF(SymplecticEuler) {}

WEFT_FIELDS_OF(Filling) {
    WEFT_FIELD(kind);
    WEFT_FIELD(pressure, -1e5f, 1e7f);
    WEFT_FIELD(volume, 1e-12f, 1e9f, Ends::or_zero);
    WEFT_FIELD(outside, 0, 1e7f);
}
WEFT_FIELDS_OF(FillingInfo) {
    WEFT_FIELD(open_edges);
    WEFT_FIELD(volume);
    WEFT_FIELD(rest_volume);
    WEFT_FIELD(pressure);
}

WEFT_FIELDS_OF(ClothSettings) {
    WEFT_FIELD(fabric);
    WEFT_FIELD(finite_elements);
    WEFT_FIELD(method);
    WEFT_FIELD(time_scheme);
    WEFT_FIELD(substeps, 1, 1024);
    WEFT_FIELD(tethers);
    WEFT_FIELD(self_collision);
    WEFT_FIELD(air_damping, 0, 1e6f);
    WEFT_FIELD(thickness, 0, 10);
    WEFT_FIELD(friction, 0, 1e3f);
    WEFT_FIELD(back_friction_ratio, 0, 1e3f);
    WEFT_FIELD(restitution, 0, 1);
    WEFT_FIELD(collider_mask);
    WEFT_FIELD(collider_response);
    WEFT_FIELD(enabled);
    WEFT_FIELD(sleep_speed, 0, 1e3f);
    WEFT_FIELD(frame_inertia);
    WEFT_FIELD(importance, 0, 1e6f);
    WEFT_FIELD(teleport_distance, 0, 1e6f);
    WEFT_FIELD(teleport_angle, 0, 3.2f);
    WEFT_FIELD(gravity_scale, -10, 10);
    WEFT_FIELD(wind_scale, 0, 10);
    WEFT_FIELD(drag_scale, 0, 1e3f);
    WEFT_FIELD(lift_scale, 0, 1e3f);
    WEFT_FIELD(max_speed_in_frame, 0, 1e4f);
    WEFT_FIELD(filling);
    WEFT_FIELD(key);
}

WEFT_FIELDS_OF(AirSource) {
    WEFT_FIELD(kind);
    WEFT_FIELD(position, runaway_range);
    WEFT_FIELD(velocity, -1e3f, 1e3f);
    WEFT_FIELD(radius, air_size_range);
}

constexpr bool counts(const AirSource& source, const void* field) {
    return source.kind != AirSourceKind::none || field == &source.kind;
}

WEFT_FIELDS_OF(AirShelter) {
    WEFT_FIELD(kind);
    WEFT_FIELD(position, runaway_range);
    WEFT_FIELD(rotation);
    WEFT_FIELD(half_extents, air_size_range);
    WEFT_FIELD(radius, air_size_range);
    WEFT_FIELD(border, air_size_range);
    WEFT_FIELD(exposure, 0, 1);
}
constexpr bool counts(const AirShelter& shelter, const void* field) {
    if (shelter.kind == AirShelterKind::ball)
        return field != &shelter.half_extents && field != &shelter.rotation;
    if (shelter.kind == AirShelterKind::box) return field != &shelter.radius;
    return field == &shelter.kind;
}

WEFT_FIELDS_OF(Wind) {
    WEFT_FIELD(velocity, -1e3f, 1e3f);
    WEFT_FIELD(gust, 0, 100);
    WEFT_FIELD(gust_length, 1e-3f, 1e5f);
    WEFT_FIELD(air_density, 0, 1e4f);
    WEFT_FIELD(drag, 0, 1e3f);
    WEFT_FIELD(lift, 0, 1e3f);
    WEFT_FIELD(seed);
    WEFT_FIELD(sources);
    WEFT_FIELD(shelters);
}

/// Leaves out the executor, which is the host's.
WEFT_FIELDS_OF(WorldSettings) {
    WEFT_FIELD(gravity, -1e4f, 1e4f);
    WEFT_FIELD(wind);
    WEFT_FIELD(max_speed, 1e-3f, 1e4f);
    WEFT_FIELD(substeps, 1, 256);
    WEFT_FIELD(contact_reports, 0, 1 << 20);
    WEFT_FIELD(threads, 0, 256);
    WEFT_FIELD(budget, 0, 1e3f);
}

WEFT_FIELDS_OF(BodySettings) {
    WEFT_FIELD(mass, 1e-6f, 1e9f, Ends::or_zero, "0, or from 1e-6 to 1e9 kg");
    WEFT_FIELD(inertia, 1e-12f, 1e12f, Ends::or_zero, "0, or from 1e-12 to 1e12 kg m^2, about each axis");
    WEFT_FIELD(gravity_scale, -1000, 1000);
    WEFT_FIELD(damping, 0, 1e6f, Ends::closed, "from 0 to 1e6 1/s");
    WEFT_FIELD(angular_damping, 0, 1e6f, Ends::closed, "from 0 to 1e6 1/s");
}
WEFT_FIELDS_OF(BodyState) {
    WEFT_FIELD(position, -runaway_distance, runaway_distance, Ends::closed,
               "finite and within 100000 m of the origin");
    WEFT_FIELD(rotation);
    WEFT_FIELD(velocity, -1e4f, 1e4f, Ends::closed, "up to 1e4 m/s on each axis");
    WEFT_FIELD(angular_velocity, -1e4f, 1e4f, Ends::closed, "up to 1e4 rad/s about each axis");
}
WEFT_FIELDS_OF(Transform) {
    WEFT_FIELD(translation);
    WEFT_FIELD(rotation);
}

WEFT_FIELDS_OF(ClothReport) {
    WEFT_FIELD(flags);
    WEFT_FIELD(enabled);
    WEFT_FIELD(asleep);
    WEFT_FIELD(particles);
    WEFT_FIELD(collider_contacts);
    WEFT_FIELD(self_contacts);
    WEFT_FIELD(peak_self_contacts);
    WEFT_FIELD(truncated_particles);
    WEFT_FIELD(crossings);
    WEFT_FIELD(unresolved_pairs);
    WEFT_FIELD(pin_lag);
    WEFT_FIELD(limits_exceeded);
    WEFT_FIELD(limit_lag);
    WEFT_FIELD(peak_speed);
    WEFT_FIELD(residual);
    WEFT_FIELD(rung);
    WEFT_FIELD(rate);
    WEFT_FIELD(milliseconds);
}
WEFT_FIELDS_OF(StepReport) {
    WEFT_FIELD(flags);
    WEFT_FIELD(step);
    WEFT_FIELD(substeps);
    WEFT_FIELD(cloths);
    WEFT_FIELD(sleeping_cloths);
    WEFT_FIELD(reduced_cloths);
    WEFT_FIELD(particles);
    WEFT_FIELD(collider_contacts);
    WEFT_FIELD(self_contacts);
    WEFT_FIELD(contacts);
    WEFT_FIELD(peak_self_contacts);
    WEFT_FIELD(truncated_particles);
    WEFT_FIELD(pin_lag);
    WEFT_FIELD(limits_exceeded);
    WEFT_FIELD(limit_lag);
    WEFT_FIELD(crossings);
    WEFT_FIELD(unresolved_pairs);
    WEFT_FIELD(restored_cloths);
    WEFT_FIELD(peak_speed);
    WEFT_FIELD(residual);
    WEFT_FIELD(milliseconds);
    WEFT_FIELD(broken_stitches);
}

WEFT_FIELDS_OF(SeamSettings) {
    WEFT_FIELD(rest_length, 0, 10, Ends::closed, "from 0 to 10 m");
    WEFT_FIELD(break_force, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::infinity(),
               Ends::closed, "above 0 N; infinity, if it never breaks");
    WEFT_FIELD(stiffness, 1e-3f, 1e7f, Ends::or_zero, "0, or from 1e-3 to 1e7 N/m");
}
WEFT_FIELDS_OF(SeamInfo) {
    WEFT_FIELD(a);
    WEFT_FIELD(b);
    WEFT_FIELD(stitches);
    WEFT_FIELD(holding);
    WEFT_FIELD(force);
    WEFT_FIELD(tightest);
}

WEFT_FIELDS_OF(ClothInfo) {
    WEFT_FIELD(vertices);
    WEFT_FIELD(particles);
    WEFT_FIELD(welded_vertices);
    WEFT_FIELD(triangles);
    WEFT_FIELD(components);
    WEFT_FIELD(structural_springs);
    WEFT_FIELD(shear_springs);
    WEFT_FIELD(bending_elements);
    WEFT_FIELD(border_edges);
    WEFT_FIELD(dropped_triangles);
    WEFT_FIELD(turned_triangles);
    WEFT_FIELD(flipped_triangles);
    WEFT_FIELD(softened_triangles);
    WEFT_FIELD(misoriented_edges);
    WEFT_FIELD(loose_particles);
    WEFT_FIELD(mean_edge);
    WEFT_FIELD(mass);
    WEFT_FIELD(least_bending);
    WEFT_FIELD(bytes);
    WEFT_FIELD(shared_bytes);
    WEFT_FIELD(scratch_bytes);
}
WEFT_FIELDS_OF(ShapeInfo) {
    WEFT_FIELD(triangles);
    WEFT_FIELD(bounds);
    WEFT_FIELD(error);
    WEFT_FIELD(bytes);
}
WEFT_FIELDS_OF(Bounds) {
    WEFT_FIELD(lower);
    WEFT_FIELD(upper);
}

}  // namespace weft
