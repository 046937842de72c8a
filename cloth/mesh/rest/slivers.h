#pragma once
// Slivers: triangles so low that springs along their sides are far stiffer than the cloth that they stand
// for.
//
// The strain across the longest side L of a triangle of height r L is computed from the extensions dl of its
// sides. Where the apex stands over the middle (a cap, as at a T-junction), a strain of 1 lengthens them by
// some r^2 L only: the springs have 1 / (2 r^3) times the membrane's modulus, 5e8 at r = 1e-3. Single
// precision resolves dl no better than to 6e-8 of the coordinates, so that such springs pull at random. Where
// the apex stands over an end (a needle), dl is r L, and the springs have 1 / (2 r).

#include <Eigen/Core>

#include "cloth/mesh/rest/rest_elements.h"

namespace weft {

/// Greatest stiffness that a sliver's springs or element may have, times the membrane's modulus: that of a
/// needle of 1 : 10. With 50 instead, needles of 1 : 1000 lag by .1 m/s where cloth starts to fall, and 20 of
/// 60 random worlds, not 10, gain kinetic energy where contact cuts the needles' motion. But sheets with fans
/// of needles then hang .6 % lower than sound ones, not 3.6 %.
constexpr double greatest_side_stiffness = 5;

/// Height over longest side from which on no triangle counts as a sliver: there needles have that stiffness.
constexpr double least_sound_height = 0.1;

/// Height over longest side below which a sliver's stiffness also falls in proportion to its height. The
/// residual of a step and the spacing of floats are large beside such a sliver, and would throw it off.
constexpr double least_resolved_height = 1e-3;

/// Strains of a triangle per extension of its sides [1/m]: along its longest side, across it, and the
/// engineering shear between them. Column k: side k, from corner k to the next.
struct SideStrains {
    Eigen::Matrix3d rows;
    Eigen::Vector2d along;  ///< unit vector of the longest side, in the axes of the rest sides
    double area;            ///< [m^2]
    double height;          ///< over the longest side
    /// Stiffness of the springs, times the membrane's modulus, that each strain needs: area |row|^2.
    [[nodiscard]] Eigen::Vector3d stiffness() const { return area * rows.rowwise().squaredNorm(); }
};
[[nodiscard]] SideStrains side_strains(const RestSides& sides);

/// Factors of the strains of side_strains(), 0 to 1, such that none of a sliver's needs more than
/// greatest_side_stiffness, or less below least_resolved_height. A cap softens across its longest side, and
/// keeps its stiffness along it.
[[nodiscard]] Eigen::Vector3d softened_strains(const SideStrains& strains);

/// The part of the membrane's stiffness that a triangle's springs keep, least over all directions: 1 for a
/// sound triangle.
[[nodiscard]] double stiffness_left(const RestSides& sides);

/// The part of its stiffness that a finite element keeps, in all directions. Its strain is measured by
/// displacements over the height, so that it is 1 / (2 r) times as stiff as the membrane, cap or needle.
[[nodiscard]] double element_stiffness_left(const RestSides& sides);

}  // namespace weft
