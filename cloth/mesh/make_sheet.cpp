#include <cmath>
#include <new>
#include <string>

#include <Eigen/Geometry>

#include "cloth/mesh/mesh_limits.h"
#include "engine/error_text.h"
#include "engine/memory/without_exceptions.h"
#include "engine/vector.h"
#include "weft/mesh.h"

namespace weft {

namespace {

/// Sine of the least angle between u and v; a flatter sheet is all but a line.
constexpr double least_sine = 1e-3;

Eigen::Vector3d vector(const Vec3& v) {
    return to_vector(v).cast<double>();
}

Vec3 rounded(const Eigen::Vector3d& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

Result<void> check(const SheetSettings& settings) {
    const double rows = settings.rows, columns = settings.columns;
    if (rows < 2) return out_of_range("SheetSettings::rows", rows, "at least 2");
    if (columns < 2) return out_of_range("SheetSettings::columns", columns, "at least 2");
    if (rows * columns > static_cast<double>(most_vertices))
        return out_of_range("SheetSettings::rows * SheetSettings::columns", rows * columns,
                            "at most 2^26 = 67108864");

    if (!is_finite(settings.origin))
        return out_of_range("SheetSettings::origin", settings.origin, "finite, in metres");
    if (!is_finite(settings.u)) return out_of_range("SheetSettings::u", settings.u, "finite, in metres");
    if (!is_finite(settings.v)) return out_of_range("SheetSettings::v", settings.v, "finite, in metres");

    const Eigen::Vector3d u = vector(settings.u), v = vector(settings.v);
    if (u.isZero(0)) return out_of_range("SheetSettings::u", settings.u, "longer than 0 m");
    if (v.isZero(0)) return out_of_range("SheetSettings::v", settings.v, "longer than 0 m");
    if (u.normalized().cross(v.normalized()).norm() < least_sine)
        return out_of_range("SheetSettings::v", settings.v,
                            "at an angle to SheetSettings::u, not parallel to it");
    const Vec3 far_corner = rounded(vector(settings.origin) + u + v);
    if (!is_finite(far_corner))
        return out_of_range("SheetSettings::origin + u + v", far_corner, "finite, in metres");
    return {};
}

/// Diagonals alternate like a chessboard's colours, so that the sheet has no direction in which it folds more
/// easily.
void append_cell(std::uint32_t row, std::uint32_t column, std::uint32_t columns,
                 std::vector<Triangle>& triangles) {
    const std::uint32_t near_left = row * columns + column, near_right = near_left + 1;
    const std::uint32_t far_left = near_left + columns, far_right = far_left + 1;
    if ((row + column) % 2 == 0) {
        triangles.push_back({near_left, far_left, far_right});
        triangles.push_back({near_left, far_right, near_right});
    } else {
        triangles.push_back({near_left, far_left, near_right});
        triangles.push_back({near_right, far_left, far_right});
    }
}

Mesh build(const SheetSettings& settings) {
    const Eigen::Vector3d origin = vector(settings.origin), u = vector(settings.u), v = vector(settings.v);
    const double width = u.norm(), height = v.norm();

    Mesh mesh;
    mesh.rows = settings.rows;
    mesh.columns = settings.columns;
    const std::size_t particles = std::size_t{settings.rows} * settings.columns;
    mesh.positions.reserve(particles);
    mesh.texcoords.reserve(particles);
    for (std::uint32_t row = 0; row < settings.rows; ++row) {
        const double t = static_cast<double>(row) / (settings.rows - 1);
        for (std::uint32_t column = 0; column < settings.columns; ++column) {
            const double s = static_cast<double>(column) / (settings.columns - 1);
            mesh.positions.push_back(rounded(origin + s * u + t * v));
            mesh.texcoords.push_back({static_cast<float>(s * width), static_cast<float>(t * height)});
        }
    }

    mesh.triangles.reserve(2 * std::size_t{settings.rows - 1} * (settings.columns - 1));
    for (std::uint32_t row = 0; row + 1 < settings.rows; ++row)
        for (std::uint32_t column = 0; column + 1 < settings.columns; ++column)
            append_cell(row, column, settings.columns, mesh.triangles);
    return mesh;
}

}  // namespace

Result<Mesh> make_sheet(const SheetSettings& settings) {
    return without_exceptions([&]() -> Result<Mesh> {
        if (Result<void> valid = check(settings); !valid) return valid.error();
        return build(settings);
    });
}

}  // namespace weft
