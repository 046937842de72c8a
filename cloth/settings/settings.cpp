#include <algorithm>
#include <cmath>
#include <cstdint>
#include <Eigen/Geometry>
#include <initializer_list>
#include <optional>
#include <string>

#include "cloth/mesh/coordinates.h"
#include "cloth/settings/validate.h"
#include "collision/shapes/collider_motion.h"
#include "engine/error_text.h"

namespace weft {

namespace {

std::string text(float value) {
    return number_text(static_cast<double>(value));
}

bool is_between(float value, float low, float high) {
    return value >= low && value <= high;
}

/// Checks values, and keeps the first error. Not-a-number is within no range.
class Checks {
  public:
    void between(const char* name, float value, float low, float high) {
        require(is_between(value, low, high), name, value, "from " + text(low) + " to " + text(high));
    }
    void zero_or_between(const char* name, float value, float low, float high) {
        require(value == 0 || is_between(value, low, high), name, value,
                "0, or from " + text(low) + " to " + text(high));
    }
    void below(const char* name, float value, float limit) {
        require(value < limit, name, value, "below " + text(limit));
    }
    void within(const char* name, int value, int low, int high) {
        require(value >= low && value <= high, name, value,
                "from " + std::to_string(low) + " to " + std::to_string(high));
    }
    void within(const char* name, const Vec3& value, float limit) {
        const bool good = is_between(value.x, -limit, limit) && is_between(value.y, -limit, limit) &&
                          is_between(value.z, -limit, limit);
        if (!first_ && !good)
            first_ = out_of_range(name, value,
                                  "from " + text(-limit) + " to " + text(limit) + " in every component");
    }
    /// `value` is of an enum whose values count from 0 and have these names.
    template <class Enum>
    void one_of(const char* name, Enum value, std::initializer_list<const char*> names) {
        std::string all;
        for (const char* each : names) all.append(all.empty() ? "" : " or ").append(each);
        const auto number = static_cast<std::int64_t>(value);
        require(number >= 0 && number < static_cast<std::int64_t>(names.size()), name, number, all);
    }
    void allow(bool good, const char* complaint) {
        if (!first_ && !good) first_ = Error{ErrorCode::invalid_argument, complaint};
    }
    [[nodiscard]] Result<void> result() const { return first_ ? Result<void>(*first_) : Result<void>(); }

  private:
    template <class Number>
    void require(bool good, const char* name, Number value, const std::string& requirement) {
        if (!first_ && !good) first_ = out_of_range(name, static_cast<double>(value), requirement);
    }
    std::optional<Error> first_;
};

// The ranges of settings.h. No step overflows, even with all settings at their ends: a force of 1e9 N/m on
// the lightest particle leaves squares of its acceleration within single precision.
constexpr float most_stiffness = 1e9f;  // [N/m]

constexpr int most_iterations = 100000;
constexpr int most_contact_reports = 1 << 20;

void check(Checks& checks, const Jacobi& method) {
    checks.within("Jacobi::iterations", method.iterations, 0, most_iterations);
}
void check(Checks& checks, const Chebyshev& method) {
    checks.within("Chebyshev::iterations", method.iterations, 1, most_iterations);
}
void check(Checks& checks, const ConjugateGradient& method) {
    checks.within("ConjugateGradient::iterations", method.iterations, 1, most_iterations);
}
void check(Checks& checks, const Multilevel& method) {
    checks.within("Multilevel::passes", method.passes, 1, most_iterations);
    checks.between("Multilevel::tolerance", method.tolerance, 0, 1e9f);
}
void check(Checks& checks, const Xpbd& method) {
    checks.within("Xpbd::iterations", method.iterations, 1, most_iterations);
}
void check(Checks& checks, const Fibres& method) {
    checks.within("Fibres::iterations", method.iterations, 1, most_iterations);
    const auto solver = [&](const char* name, Fibres::SetSolver value) {
        checks.one_of(name, value, {"SetSolver::gauss_seidel", "SetSolver::ldlt"});
    };
    solver("Fibres::vertical", method.vertical);
    solver("Fibres::horizontal", method.horizontal);
    solver("Fibres::shear", method.shear);
}
void check(Checks& /*checks*/, const SymplecticEuler& /*method*/) {}

void check(Checks& checks, const Method& method) {
    checks.allow(!method.valueless_by_exception(),
                 "ClothSettings::method holds no method, since an assignment to it threw; assign one");
    if (!method.valueless_by_exception())
        std::visit([&](const auto& chosen) { check(checks, chosen); }, method);
}

void check(Checks& checks, const Fabric& fabric) {
    checks.between("Fabric::areal_density", fabric.areal_density, 1e-4f, 1e4f);
    checks.between("Fabric::warp", fabric.warp, 0, most_stiffness);
    checks.between("Fabric::weft", fabric.weft, 0, most_stiffness);
    checks.between("Fabric::shear", fabric.shear, 0, most_stiffness);
    checks.between("Fabric::bending", fabric.bending, 0, 1e4f);
    checks.between("Fabric::bending_ratio", fabric.bending_ratio, least_bending_ratio,
                   greatest_bending_ratio);
    checks.between("Fabric::damping", fabric.damping, 0, 100);
    checks.between("Fabric::stiffening", fabric.stiffening, 0, 1000);
    // The stiffness is limited where the law is steepest: beyond last_stiffening_strain.
    const float stiffest = std::max(fabric.warp, fabric.weft);
    if (fabric.stiffening > 0 && stiffest > 0)
        checks.between("Fabric::stiffening", fabric.stiffening, 0,
                       std::clamp(3 * (most_stiffness / stiffest - 1), 0.0f, 1000.0f));
}

void check(Checks& checks, const FiniteElements& elements) {
    checks.between("FiniteElements::poisson", elements.poisson, 0, 0.5f);
    checks.below("FiniteElements::poisson", elements.poisson, 0.5f);
}

/// Checks settings that exclude each other.
void check_together(Checks& checks, const ClothSettings& settings) {
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
}

void check(Checks& checks, const SelfCollision& contact) {
    checks.one_of(
        "SelfCollision::method", contact.method,
        {"SelfCollisionMethod::off", "SelfCollisionMethod::contact", "SelfCollisionMethod::impact_zones",
         "SelfCollisionMethod::avoidance", "SelfCollisionMethod::avoidance_by_shifted_grids",
         "SelfCollisionMethod::avoidance_by_sorted_sweep"});
    checks.between("SelfCollision::restitution", contact.restitution, 0, 1);
    checks.allow(contact.restitution == 0 || contact.method == SelfCollisionMethod::impact_zones,
                 "SelfCollision::restitution is not 0, and only impact zones have one; it must be 0, or "
                 "SelfCollision::method SelfCollisionMethod::impact_zones");
    checks.zero_or_between("SelfCollision::distance", contact.distance, 1e-6f, 10);
    checks.between("SelfCollision::friction", contact.friction, 0, 1000);
}

void check(Checks& checks, const Filling& filling) {
    checks.one_of("Filling::kind", filling.kind,
                  {"FillingKind::none", "FillingKind::pressure", "FillingKind::gas", "FillingKind::volume"});
    checks.between("Filling::pressure", filling.pressure, -1e5f, 1e7f);
    checks.zero_or_between("Filling::volume", filling.volume, 1e-12f, 1e9f);
    checks.between("Filling::outside", filling.outside, 0, 1e7f);
}

void check_importance(Checks& checks, float importance) {
    checks.between("ClothSettings::importance", importance, 0, 1e6f);
}

void check(Checks& checks, const AirSource& source) {
    checks.one_of(
        "AirSource::kind", source.kind,
        {"AirSourceKind::none", "AirSourceKind::jet", "AirSourceKind::blast", "AirSourceKind::wake"});
    if (source.kind == AirSourceKind::none) return;
    checks.within("AirSource::position", source.position, runaway_distance);
    checks.within("AirSource::velocity", source.velocity, 1e3f);
    checks.between("AirSource::radius", source.radius, 1e-3f, 1e5f);
}

void check(Checks& checks, const AirShelter& shelter) {
    checks.one_of("AirShelter::kind", shelter.kind,
                  {"AirShelterKind::none", "AirShelterKind::ball", "AirShelterKind::box"});
    if (shelter.kind == AirShelterKind::none) return;
    checks.within("AirShelter::position", shelter.position, runaway_distance);
    checks.between("AirShelter::border", shelter.border, 1e-3f, 1e5f);
    checks.between("AirShelter::exposure", shelter.exposure, 0, 1);
    if (shelter.kind == AirShelterKind::ball)
        return checks.between("AirShelter::radius", shelter.radius, 1e-3f, 1e5f);
    const Vec3& half = shelter.half_extents;
    for (const float extent : {half.x, half.y, half.z})
        checks.between("AirShelter::half_extents", extent, 1e-3f, 1e5f);
    const Rotation& r = shelter.rotation;
    checks.between("the length of AirShelter::rotation", Eigen::Vector4f(r.x, r.y, r.z, r.w).norm(), 1e-6f,
                   1e6f);
}

void check(Checks& checks, const Wind& wind) {
    checks.within("Wind::velocity", wind.velocity, 1e3f);
    checks.between("Wind::gust", wind.gust, 0, 100);
    checks.between("Wind::gust_length", wind.gust_length, 1e-3f, 1e5f);
    checks.between("Wind::air_density", wind.air_density, 0, 1e4f);
    checks.between("Wind::drag", wind.drag, 0, 1e3f);
    checks.between("Wind::lift", wind.lift, 0, 1e3f);
    for (const AirSource& source : wind.sources) check(checks, source);
    for (const AirShelter& shelter : wind.shelters) check(checks, shelter);
}

}  // namespace

Result<void> validate(const WorldSettings& settings) {
    Checks checks;
    checks.within("WorldSettings::gravity", settings.gravity, 1e4f);
    check(checks, settings.wind);
    checks.between("WorldSettings::max_speed", settings.max_speed, 1e-3f, 1e4f);
    checks.within("WorldSettings::substeps", settings.substeps, 1, 256);
    checks.within("WorldSettings::contact_reports", settings.contact_reports, 0, most_contact_reports);
    checks.between("WorldSettings::budget", settings.budget, 0, 1e3f);
    checks.within("WorldSettings::threads", settings.threads, 0, 256);
    if (settings.executor.run != nullptr) checks.within("Executor::width", settings.executor.width, 1, 256);
    return checks.result();
}

Result<void> validate(const ClothSettings& settings) {
    Checks checks;
    check(checks, settings.fabric);
    check(checks, settings.finite_elements);
    check(checks, settings.method);
    check(checks, settings.filling);
    check_together(checks, settings);
    checks.one_of("ClothSettings::time_scheme", settings.time_scheme,
                  {"TimeScheme::of_method", "TimeScheme::backward_euler", "TimeScheme::bdf2"});
    checks.between("ClothSettings::sleep_speed", settings.sleep_speed, 0, 1e3f);
    checks.within("ClothSettings::substeps", settings.substeps, 1, 1024);
    checks.between("Tethers::slack", settings.tethers.slack, 1, 1e3f);
    check(checks, settings.self_collision);
    checks.between("ClothSettings::air_damping", settings.air_damping, 0, 1e6f);
    checks.between("ClothSettings::thickness", settings.thickness, 0, 10);
    checks.between("ClothSettings::friction", settings.friction, 0, 1e3f);
    checks.between("ClothSettings::back_friction_ratio", settings.back_friction_ratio, 0, 1e3f);
    checks.between("ClothSettings::restitution", settings.restitution, 0, 1);
    checks.one_of("ClothSettings::collider_response", settings.collider_response,
                  {"ColliderResponse::contact", "ColliderResponse::velocity_filter"});
    checks.between("FrameInertia::linear", settings.frame_inertia.linear, 0, 1);
    checks.between("FrameInertia::angular", settings.frame_inertia.angular, 0, 1);
    checks.between("FrameInertia::centrifugal", settings.frame_inertia.centrifugal, 0, 1);
    check_importance(checks, settings.importance);
    checks.between("ClothSettings::teleport_distance", settings.teleport_distance, 0, 1e6f);
    checks.between("ClothSettings::teleport_angle", settings.teleport_angle, 0, 3.2f);
    checks.between("ClothSettings::gravity_scale", settings.gravity_scale, -10, 10);
    checks.between("ClothSettings::wind_scale", settings.wind_scale, 0, 10);
    return checks.result();
}

Result<void> validate_importance(float importance) {
    Checks checks;
    check_importance(checks, importance);
    return checks.result();
}

Result<void> validate_for_maps(const ClothSettings& settings) {
    Checks checks;
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
