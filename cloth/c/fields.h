#pragma once
// Pairs of structs for C and for C++. Pairs with the same fields have one list for both in settings/fields.h;
// the others' lists are here. fields(way, c, of) lets a way assign one of the two to the other.
// tests/embedding/c/fields_test.cpp fails where a field has no counterpart.

#include <concepts>
#include <type_traits>

#include "cloth/settings/fields.h"
#include "weft/c/reports.h"
#include "weft/c/settings.h"
#include "weft/weft.h"

namespace weft {

template <>
struct StandsFor<WeftFabric> : std::type_identity<Fabric> {};
template <>
struct StandsFor<WeftFiniteElements> : std::type_identity<FiniteElements> {};
template <>
struct StandsFor<WeftTethers> : std::type_identity<Tethers> {};
template <>
struct StandsFor<WeftFrameInertia> : std::type_identity<FrameInertia> {};
template <>
struct StandsFor<WeftSelfCollision> : std::type_identity<SelfCollision> {};
template <>
struct StandsFor<WeftFilling> : std::type_identity<Filling> {};
template <>
struct StandsFor<WeftFillingInfo> : std::type_identity<FillingInfo> {};
template <>
struct StandsFor<WeftClothSettings> : std::type_identity<ClothSettings> {};
template <>
struct StandsFor<WeftAirSource> : std::type_identity<AirSource> {};
template <>
struct StandsFor<WeftAirShelter> : std::type_identity<AirShelter> {};
template <>
struct StandsFor<WeftWind> : std::type_identity<Wind> {};
template <>
struct StandsFor<WeftWorldSettings> : std::type_identity<WorldSettings> {};
template <>
struct StandsFor<WeftBodySettings> : std::type_identity<BodySettings> {};
template <>
struct StandsFor<WeftBodyState> : std::type_identity<BodyState> {};
template <>
struct StandsFor<WeftSeamSettings> : std::type_identity<SeamSettings> {};
template <>
struct StandsFor<WeftSeamInfo> : std::type_identity<SeamInfo> {};
template <>
struct StandsFor<WeftClothReport> : std::type_identity<ClothReport> {};
template <>
struct StandsFor<WeftStepReport> : std::type_identity<StepReport> {};
template <>
struct StandsFor<WeftClothInfo> : std::type_identity<ClothInfo> {};
template <>
struct StandsFor<WeftShapeInfo> : std::type_identity<ShapeInfo> {};

}  // namespace weft

namespace weft::c {

template <class T, class Of>
concept Is = std::same_as<std::remove_const_t<T>, Of>;

template <class Way, class C, class Of>
requires(!Is<C, Of>) && HaveFields<C, Of> void fields(const Way& way, C& c, Of& of) {
    for_both(c, of, [&](const char* /*name*/, auto& field, auto& of_weft) { way(field, of_weft); });
}

template <class Way>
void fields(const Way& way, Is<WeftMethod> auto& c, Is<Multilevel> auto& of) {
    way(c.passes, of.passes);
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

}  // namespace weft::c
