#pragma once
// Names of the interface's values, as hosts write them.

#include <cstddef>
#include <iterator>
#include <span>
#include <type_traits>

#include "weft/collider.h"
#include "weft/methods.h"
#include "weft/report.h"
#include "weft/self_collision.h"
#include "weft/settings.h"

namespace weft {

/// Name of an enumeration, and of each of its values, which count from 0.
struct EnumNames {
    const char* type;
    std::span<const char* const> values;
};
inline EnumNames names_of(TimeScheme) {
    static constexpr const char* values[] = {"of_method", "backward_euler", "bdf2"};
    return {"TimeScheme", values};
}
inline EnumNames names_of(Fibres::SetSolver) {
    static constexpr const char* values[] = {"gauss_seidel", "ldlt"};
    return {"SetSolver", values};
}
inline EnumNames names_of(SelfCollisionMethod) {
    static constexpr const char* values[] = {"off",
                                             "contact",
                                             "impact_zones",
                                             "avoidance",
                                             "avoidance_by_shifted_grids",
                                             "avoidance_by_sorted_sweep"};
    return {"SelfCollisionMethod", values};
}
inline EnumNames names_of(AirSourceKind) {
    static constexpr const char* values[] = {"none", "jet", "blast", "wake"};
    return {"AirSourceKind", values};
}
inline EnumNames names_of(AirShelterKind) {
    static constexpr const char* values[] = {"none", "ball", "box"};
    return {"AirShelterKind", values};
}
inline EnumNames names_of(FillingKind) {
    static constexpr const char* values[] = {"none", "pressure", "gas", "volume"};
    return {"FillingKind", values};
}
inline EnumNames names_of(ColliderResponse) {
    static constexpr const char* values[] = {"contact", "velocity_filter"};
    return {"ColliderResponse", values};
}
template <class Enum>
requires std::is_enum_v<Enum>
const char* name_of(Enum value) {
    const auto names = names_of(value).values;
    const auto number = static_cast<std::size_t>(value);
    return number < names.size() ? names[number] : "none";
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

}  // namespace weft
