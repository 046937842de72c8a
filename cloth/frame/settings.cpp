#include <cmath>
#include <optional>

#include "cloth/frame/validate.h"
#include "cloth/mesh/coordinates.h"
#include "engine/error_text.h"

namespace weft {

namespace {

/// Keeps the first complaint.
class Checks {
  public:
    void at_least_zero(const char* name, float value) { require(value >= 0, name, value, "finite and >= 0"); }
    void positive(const char* name, float value) { require(value > 0, name, value, "finite and > 0"); }
    void below(const char* name, float value, float limit) {
        require(value < limit, name, value, "below " + number_text(static_cast<double>(limit)));
    }
    void at_least(const char* name, float value, float least) {
        require(value >= least, name, value, "finite and >= " + number_text(static_cast<double>(least)));
    }
    void within(const char* name, int value, int low, int high) {
        require(value >= low && value <= high, name, static_cast<float>(value),
                "from " + std::to_string(low) + " to " + std::to_string(high));
    }
    void finite(const char* name, const Vec3& value) {
        if (!first_ && !is_finite(value)) first_ = out_of_range(name, value, "finite in every component");
    }
    [[nodiscard]] Result<void> result() const { return first_ ? Result<void>(*first_) : Result<void>(); }

  private:
    void require(bool good, const char* name, float value, const std::string& requirement) {
        if (!first_ && !(good && std::isfinite(value)))
            first_ = out_of_range(name, static_cast<double>(value), requirement);
    }
    std::optional<Error> first_;
};

constexpr int most_iterations = 100000;

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
    checks.within("Multilevel::iterations", method.iterations, 1, most_iterations);
    checks.within("Multilevel::passes", method.passes, 1, most_iterations);
}
void check(Checks& checks, const Xpbd& method) {
    checks.within("Xpbd::iterations", method.iterations, 1, most_iterations);
}
void check(Checks& checks, const Fibres& method) {
    checks.within("Fibres::iterations", method.iterations, 1, most_iterations);
}
void check(Checks& /*checks*/, const SymplecticEuler& /*method*/) {}

void check(Checks& checks, const FiniteElements& elements) {
    checks.positive("FiniteElements::warp", elements.warp);
    checks.positive("FiniteElements::weft", elements.weft);
    checks.positive("FiniteElements::shear", elements.shear);
    checks.at_least("FiniteElements::poisson", elements.poisson, 0);
    checks.below("FiniteElements::poisson", elements.poisson, 0.5f);
    checks.at_least("FiniteElements::bending", elements.bending, 0);
}

}  // namespace

Result<void> validate(const WorldSettings& settings) {
    Checks checks;
    checks.finite("WorldSettings::gravity", settings.gravity);
    checks.finite("Wind::velocity", settings.wind.velocity);
    checks.at_least_zero("Wind::gust", settings.wind.gust);
    checks.positive("Wind::gust_length", settings.wind.gust_length);
    checks.at_least_zero("Wind::air_density", settings.wind.air_density);
    checks.at_least_zero("Wind::drag", settings.wind.drag);
    checks.at_least_zero("Wind::lift", settings.wind.lift);
    checks.positive("WorldSettings::max_speed", settings.max_speed);
    checks.within("WorldSettings::substeps", settings.substeps, 1, 256);
    checks.within("WorldSettings::threads", settings.threads, 0, 256);
    if (settings.executor.run != nullptr) checks.within("Executor::width", settings.executor.width, 1, 256);
    return checks.result();
}

Result<void> validate(const ClothSettings& settings) {
    Checks checks;
    checks.positive("Fabric::areal_density", settings.fabric.areal_density);
    checks.at_least_zero("Fabric::stretch", settings.fabric.stretch);
    checks.at_least_zero("Fabric::shear", settings.fabric.shear);
    checks.at_least_zero("Fabric::bend", settings.fabric.bend);
    checks.at_least_zero("Fabric::damping", settings.fabric.damping);
    check(checks, settings.finite_elements);
    std::visit([&](const auto& method) { check(checks, method); }, settings.method);
    checks.within("ClothSettings::substeps", settings.substeps, 1, 1024);
    checks.at_least("Tethers::slack", settings.tethers.slack, 1.0f);
    checks.at_least_zero("SelfCollision::distance", settings.self_collision.distance);
    checks.at_least_zero("SelfCollision::friction", settings.self_collision.friction);
    checks.at_least_zero("ClothSettings::air_damping", settings.air_damping);
    checks.at_least_zero("ClothSettings::thickness", settings.thickness);
    checks.at_least_zero("ClothSettings::friction", settings.friction);
    return checks.result();
}

Result<void> validate_point(const char* name, const Vec3& point) {
    const bool near = std::abs(point.x) <= runaway_distance && std::abs(point.y) <= runaway_distance &&
                      std::abs(point.z) <= runaway_distance;
    if (!near)
        return out_of_range(
            name, point,
            "finite and within " + number_text(static_cast<double>(runaway_distance)) + " m of the origin");
    return {};
}

}  // namespace weft
