#include "cloth/mesh/rest/slivers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace weft {

namespace {

std::array<Eigen::Vector2d, 3> sides_around(const RestSides& rest) {
    const Eigen::Vector2d to1 = rest.to1.cast<double>(), to2 = rest.to2.cast<double>();
    return {to1, to2 - to1, -to2};
}

double area_of(const std::array<Eigen::Vector2d, 3>& sides) {
    return std::abs(sides[0].x() * sides[2].y() - sides[0].y() * sides[2].x()) / 2;
}

double greatest_stiffness(double height) {
    return greatest_side_stiffness * std::min(1.0, height / least_resolved_height);
}

}  // namespace

SideStrains side_strains(const RestSides& rest) {
    const std::array<Eigen::Vector2d, 3> sides = sides_around(rest);
    const Eigen::Vector2d& longest =
        *std::ranges::max_element(sides, {}, [](const Eigen::Vector2d& side) { return side.squaredNorm(); });
    SideStrains result;
    result.area = area_of(sides);
    result.height = 2 * result.area / longest.squaredNorm();
    result.along = longest.normalized();
    const Eigen::Vector2d across(-result.along.y(), result.along.x());
    Eigen::Matrix3d extensions;
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = sides[k].dot(result.along), y = sides[k].dot(across), length = sides[k].norm();
        extensions.row(static_cast<Eigen::Index>(k)) << x * x / length, y * y / length, x * y / length;
    }
    result.rows = extensions.inverse();
    return result;
}

Eigen::Vector3d softened_strains(const SideStrains& strains) {
    if (strains.height >= least_sound_height) return Eigen::Vector3d::Ones();
    return (greatest_stiffness(strains.height) / strains.stiffness().array()).min(1).sqrt();
}

double stiffness_left(const RestSides& sides) {
    const double least = softened_strains(side_strains(sides)).minCoeff();
    return least * least;
}

double element_stiffness_left(const RestSides& rest) {
    const std::array<Eigen::Vector2d, 3> sides = sides_around(rest);
    double longest = 0;
    for (const Eigen::Vector2d& side : sides) longest = std::max(longest, side.squaredNorm());
    const double height = 2 * area_of(sides) / longest;
    return std::min(1.0, 2 * height * greatest_stiffness(height));
}

}  // namespace weft
