#include <algorithm>
#include <cmath>
#include <string>

#include "cloth/settings/fields.h"
#include "cloth/settings/names.h"
#include "cloth/settings/validate.h"
#include "collision/shapes/field_checks.h"

namespace weft {

namespace {

/// Checks settings that exclude each other.
void check_together(FieldChecks& checks, const ClothSettings& settings) {
    const Fabric& fabric = settings.fabric;
    // The stiffness is limited where the law is steepest: beyond last_stiffening_strain.
    const float stiffest = std::max(fabric.warp, fabric.weft);
    if (fabric.stiffening > 0 && stiffest > 0)
        checks.number("Fabric", "stiffening", static_cast<double>(fabric.stiffening),
                      {0, std::clamp(3 * (most_stiffness / stiffest - 1), 0.0f, 1000.0f)});
    const FiniteElements& elements = settings.finite_elements;
    const bool positional =
        std::holds_alternative<Xpbd>(settings.method) || std::holds_alternative<Fibres>(settings.method);
    checks.allow(
        !(elements.enabled && positional),
        "FiniteElements::enabled is true, and Xpbd and Fibres know springs only; it must be false with "
        "them, or ClothSettings::method an implicit one or SymplecticEuler");
    checks.allow(!(settings.fabric.stiffening > 0 && (positional || elements.enabled)),
                 "Fabric::stiffening is more than 0, and Xpbd, Fibres and FiniteElements know constant "
                 "stiffness only; it must be 0 with them, or ClothSettings::method an implicit one or "
                 "SymplecticEuler without FiniteElements");
    checks.allow(
        !(elements.enabled && elements.consistent_mass &&
          std::holds_alternative<SymplecticEuler>(settings.method)),
        "FiniteElements::consistent_mass is true, and SymplecticEuler divides by lumped masses; it must "
        "be false with it, or ClothSettings::method an implicit one");
    const Filling& filling = settings.filling;
    const bool has_slope = filling.kind == FillingKind::gas || filling.kind == FillingKind::volume;
    checks.allow(
        !(has_slope && !std::holds_alternative<Multilevel>(settings.method)),
        "Filling::kind is FillingKind::gas or volume, which only Multilevel has in its equation; it must "
        "be FillingKind::pressure or none with other methods, or ClothSettings::method Multilevel");
    checks.allow(
        !(filling.kind == FillingKind::gas && !(filling.pressure + filling.outside > 0)),
        "Filling::pressure is the opposite of Filling::outside or less, which leaves no gas; their sum "
        "must be above 0");
    const SelfCollision& contact = settings.self_collision;
    checks.allow(contact.restitution == 0 || contact.method == SelfCollisionMethod::impact_zones,
                 "SelfCollision::restitution is not 0, and only impact zones have one; it must be 0, or "
                 "SelfCollision::method SelfCollisionMethod::impact_zones");
}

}  // namespace

Result<void> validate(const WorldSettings& settings) {
    FieldChecks checks;
    checks.fields(settings);
    if (settings.executor.run != nullptr)
        checks.number("Executor", "width", settings.executor.width, {1, 256});
    return checks.result();
}

Result<void> validate(const ClothSettings& settings) {
    FieldChecks checks;
    checks.allow(!settings.method.valueless_by_exception(),
                 "ClothSettings::method holds no method, since an assignment to it threw; assign one");
    checks.fields(settings);
    check_together(checks, settings);
    return checks.result();
}

Result<void> validate(const BodySettings& settings) {
    return validate_fields(settings);
}
Result<void> validate(const BodyState& state) {
    return validate_fields(state);
}
Result<void> validate(const SeamSettings& settings) {
    return validate_fields(settings);
}

Result<void> validate_importance(float importance) {
    return validate_fields(ClothSettings{.importance = importance});
}

Result<void> validate_for_maps(const ClothSettings& settings) {
    FieldChecks checks;
    checks.allow(
        !(settings.finite_elements.enabled && settings.finite_elements.consistent_mass),
        "FiniteElements::consistent_mass is true, and Map::mass and Map::stiffness know lumped masses "
        "only; it must be false with them");
    return checks.result();
}

bool is_within_reach(const Vec3& point) noexcept {
    const auto is_near = [](float x) { return std::abs(x) <= runaway_distance; };  // false for not-a-number
    return is_near(point.x) && is_near(point.y) && is_near(point.z);
}

Result<void> validate_point(const char* name, const Vec3& point) {
    if (!is_within_reach(point))
        return out_of_range(
            name, point,
            "finite and within " + number_text(static_cast<double>(runaway_distance)) + " m of the origin");
    return {};
}

Result<void> validate_transform(const char* name, const Transform& pose) {
    if (auto valid = validate_rotation(std::string(name) + ".rotation", pose.rotation); !valid) return valid;
    if (!is_finite(pose.translation))
        return out_of_range(std::string(name) + ".translation", pose.translation, "finite");
    return {};
}

}  // namespace weft
