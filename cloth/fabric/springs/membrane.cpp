#include "cloth/fabric/springs/membrane.h"

#include <Eigen/Dense>

#include "cloth/mesh/rest/rest_elements.h"
#include "cloth/mesh/rest/slivers.h"

namespace weft {

namespace {

/// The least f with C' <= f D, D the diagonal: the largest eigenvalue of D^-1/2 C' D^-1/2, from 1 to 3.
double bound_of(const Eigen::Matrix3d& c) {
    Eigen::Vector3d scale;
    for (Eigen::Index k = 0; k < 3; ++k) scale[k] = c(k, k) > 0 ? 1 / std::sqrt(c(k, k)) : 0;
    const Eigen::Matrix3d scaled = scale.asDiagonal() * c * scale.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>()
        .computeDirect(scaled, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

struct RestStrains {
    std::array<double, 3> lengths;  // of the sides [m]
    double area;                    // [m^2]
    Eigen::Matrix3d strains;        // M^-1: xx, yy and xy (engineering shear) per extension of the sides
};

/// The matrix that turns strains xx, yy and xy (engineering shear) into axes whose first is a unit vector.
Eigen::Matrix3d strains_along(const Eigen::Vector2d& axis) {
    const double c = axis.x(), s = axis.y();
    Eigen::Matrix3d turn;
    turn << c * c, s * s, c * s,  //
        s * s, c * c, -c * s,     //
        -2 * c * s, 2 * c * s, c * c - s * s;
    return turn;
}

/// The matrix that applies softened_strains() to a sliver's strains in the pattern's axes.
Eigen::Matrix3d softening(const SideStrains& strains) {
    const Eigen::Vector2d back(strains.along.x(), -strains.along.y());
    return strains_along(back) * softened_strains(strains).asDiagonal() * strains_along(strains.along);
}

RestStrains rest_strains(const ClothModel& model, std::uint32_t triangle) {
    const RestSides rest = rest_sides(model, triangle);
    const Eigen::Vector2d to1 = rest.to1.cast<double>(), to2 = rest.to2.cast<double>();
    const std::array<Eigen::Vector2d, 3> sides{to1, to2 - to1, -to2};
    RestStrains result;
    result.area = std::abs(to1.x() * to2.y() - to1.y() * to2.x()) / 2;
    Eigen::Matrix3d extensions;
    for (std::size_t k = 0; k < 3; ++k) {
        const double length = result.lengths[k] = sides[k].norm();
        const Eigen::Vector2d e = sides[k] / length;
        extensions.row(static_cast<Eigen::Index>(k)) << length * e.x() * e.x(), length * e.y() * e.y(),
            length * e.x() * e.y();
    }
    result.strains = extensions.inverse();
    const SideStrains strains = side_strains(rest);
    if (softened_strains(strains).minCoeff() < 1) result.strains = softening(strains) * result.strains;
    return result;
}

}  // namespace

TriangleMembrane triangle_membrane(const ClothModel& model, std::uint32_t triangle, const Fabric& fabric) {
    const RestStrains rest = rest_strains(model, triangle);
    TriangleMembrane result;
    result.rest_lengths = rest.lengths;
    const Eigen::Vector3d moduli =
        stiffness_at(model, model.triangles[triangle]) * Eigen::Vector3d(static_cast<double>(fabric.warp),
                                                                         static_cast<double>(fabric.weft),
                                                                         static_cast<double>(fabric.shear));
    const Eigen::Matrix3d c = rest.area * rest.strains.transpose() * moduli.asDiagonal() * rest.strains;
    const double scale = std::max(1.0, least_bound * bound_of(c));
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t m = 0; m < 3; ++m)
            result.shared[k][m] = c(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(m));
        result.own[k] = scale * result.shared[k][k];
        result.shared[k][k] -= result.own[k];
    }
    return result;
}

TriangleStiffening triangle_stiffening(const ClothModel& model, std::uint32_t triangle,
                                       const Fabric& fabric) {
    const RestStrains rest = rest_strains(model, triangle);
    const double stiffening =
        static_cast<double>(fabric.stiffening) * stiffness_at(model, model.triangles[triangle]);
    TriangleStiffening result;
    result.moduli = {rest.area * stiffening * static_cast<double>(fabric.warp),
                     rest.area * stiffening * static_cast<double>(fabric.weft)};
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t k = 0; k < 3; ++k)
            result.strains[axis][k] =
                rest.strains(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(k));
    return result;
}

// The slope along an axis is v v^T, bounded by |v_k| sum_m |v_m| on the diagonal.
TriangleStiffening::Extra TriangleStiffening::at(const std::array<double, 3>& extensions) const {
    Extra extra{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::array<double, 3>& v = strains[axis];
        double strain = 0, sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            strain += v[k] * extensions[k];
            sum += std::abs(v[k]);
        }
        const Stiffened g = stiffened(strain);
        for (std::size_t k = 0; k < 3; ++k) {
            extra.tension[k] += moduli[axis] * g.tension * v[k];
            extra.own[k] +=
                moduli[axis] * g.slope * std::max(v[k] * v[k], least_bound * sum * std::abs(v[k]));
        }
    }
    return extra;
}

SheetModuli sheet_moduli(const Fabric& fabric) {
    const double warp = static_cast<double>(fabric.warp), weft = static_cast<double>(fabric.weft),
                 shear = static_cast<double>(fabric.shear);
    if (warp * weft == 0) return {std::max(warp, shear), std::max(weft, shear), shear};
    const double t = (1 + std::sqrt(1 + 4 * shear * shear / (warp * weft))) / 2;
    return {t * warp, t * weft, shear};
}

void spring_stiffness(const ClothModel& model, const Fabric& fabric, std::span<float> stiffness) noexcept {
    std::ranges::fill(stiffness, 0.0f);
    for_each_spring_part(model, fabric, [&](std::uint32_t forth, std::uint32_t back, double part) {
        stiffness[forth] += static_cast<float>(part);
        stiffness[back] += static_cast<float>(part);
    });
    for (float& k : stiffness) k = std::max(k, 0.0f);
}

}  // namespace weft
