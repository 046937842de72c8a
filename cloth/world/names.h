#pragma once
// Names of the interface's values, as hosts write them.

#include <cstddef>
#include <iterator>

#include "weft/collider.h"
#include "weft/methods.h"
#include "weft/report.h"
#include "weft/self_collision.h"
#include "weft/settings.h"

namespace weft {

namespace detail {
template <class Enum, std::size_t count>
constexpr const char* name_among(const char* const (&names)[count], Enum value) {
    const auto number = static_cast<std::size_t>(value);
    return number < count ? names[number] : "none";
}
}  // namespace detail

constexpr const char* name_of(TimeScheme value) {
    constexpr const char* names[] = {"of_method", "backward_euler", "bdf2"};
    return detail::name_among(names, value);
}
constexpr const char* name_of(Fibres::SetSolver value) {
    constexpr const char* names[] = {"gauss_seidel", "ldlt"};
    return detail::name_among(names, value);
}
constexpr const char* name_of(SelfCollisionMethod value) {
    constexpr const char* names[] = {"off",
                                     "contact",
                                     "impact_zones",
                                     "avoidance",
                                     "avoidance_by_shifted_grids",
                                     "avoidance_by_sorted_sweep"};
    return detail::name_among(names, value);
}
constexpr const char* name_of(AirSourceKind value) {
    constexpr const char* names[] = {"none", "jet", "blast", "wake"};
    return detail::name_among(names, value);
}
constexpr const char* name_of(AirShelterKind value) {
    constexpr const char* names[] = {"none", "ball", "box"};
    return detail::name_among(names, value);
}
constexpr const char* name_of(FillingKind value) {
    constexpr const char* names[] = {"none", "pressure", "gas", "volume"};
    return detail::name_among(names, value);
}
constexpr const char* name_of(ColliderResponse value) {
    constexpr const char* names[] = {"contact", "velocity_filter"};
    return detail::name_among(names, value);
}

/// Calls use(name) for each flag that is raised.
template <class Use>
void for_each_flag(StepFlags flags, const Use& use) {
    constexpr const char* names[] = {"invalid_dt", "state_restored", "contacts_dropped", "speed_limited",
                                     "unsolved",   "pins_stopped",   "crossed",          "step_under_way"};
    static_assert(1u << (std::size(names) - 1) == static_cast<std::uint32_t>(StepFlags::step_under_way));
    for (std::size_t k = 0; k < std::size(names); ++k)
        if (has(flags, static_cast<StepFlags>(1u << k))) use(names[k]);
}

constexpr const char* name_of_kind(const Multilevel&) {
    return "Multilevel";
}
constexpr const char* name_of_kind(const Jacobi&) {
    return "Jacobi";
}
constexpr const char* name_of_kind(const Chebyshev&) {
    return "Chebyshev";
}
constexpr const char* name_of_kind(const ConjugateGradient&) {
    return "ConjugateGradient";
}
constexpr const char* name_of_kind(const Xpbd&) {
    return "Xpbd";
}
constexpr const char* name_of_kind(const Fibres&) {
    return "Fibres";
}
constexpr const char* name_of_kind(const SymplecticEuler&) {
    return "SymplecticEuler";
}
constexpr const char* name_of_kind(const Sphere&) {
    return "Sphere";
}
constexpr const char* name_of_kind(const Capsule&) {
    return "Capsule";
}
constexpr const char* name_of_kind(const Plane&) {
    return "Plane";
}
constexpr const char* name_of_kind(const TaperedCapsule&) {
    return "TaperedCapsule";
}
constexpr const char* name_of_kind(const Box&) {
    return "Box";
}
constexpr const char* name_of_kind(const PlacedShape&) {
    return "PlacedShape";
}

}  // namespace weft
