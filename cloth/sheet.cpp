#include <cmath>
#include <new>
#include <string>

#include <Eigen/Geometry>

#include "engine/error_text.h"
#include "weft/mesh.h"

namespace weft {

namespace {

constexpr std::uint64_t most_particles = std::uint64_t{1} << 26;

/// Sine of the least angle between u and v; flatter sheets are lines to a float.
constexpr double least_sine = 1e-3;

Eigen::Vector3d vector(const Vec3& v) {
    return {double{v.x}, double{v.y}, double{v.z}};
}

Result<void> check(const SheetSettings& settings) {
    if (settings.rows < 2)
        return out_of_range("SheetSettings::rows", double{static_cast<double>(settings.rows)}, "at least 2");
    if (settings.columns < 2)
        return out_of_range("SheetSettings::columns", double{static_cast<double>(settings.columns)},
                            "at least 2");
    const std::uint64_t particles = std::uint64_t{settings.rows} * settings.columns;
    if (particles > most_particles)
        return out_of_range("SheetSettings::rows * SheetSettings::columns", static_cast<double>(particles),
                            "at most 67108864");
    if (!is_finite(settings.origin)) return out_of_range("SheetSettings::origin", settings.origin, "finite");
    if (!is_finite(settings.u)) return out_of_range("SheetSettings::u", settings.u, "finite");
    if (!is_finite(settings.v)) return out_of_range("SheetSettings::v", settings.v, "finite");
    return {};
}
}  // namespace
}  // namespace weft
