#pragma once
// The membrane as springs: how stiff each is, so that together they have a fabric's warp, weft and shear
// stiffness.
//
// A sheet's cells have sides of lengths a along u and b along v, and two diagonals. With
// t = (1 + sqrt(1 + 4 G^2 / (K_u K_v))) / 2, P = t K_u and Q = t K_v, cells have Young's moduli K_u and K_v
// and the shear modulus G if diagonals have the stiffness k_d = G (a^2 + b^2) / (2 a b), sides along u
// P b/a - G a/b and those along v Q a/b - G b/a. Each of the cells beside a side contributes half of this.
//
// A general mesh has edges only, and springs alone model only one kind of membrane (Cauchy: Poisson's ratio
// 1/3). So each triangle is the constant-strain element, written in its sides' extensions dl = l - L
// (Delingette 2008, for the form): with rows L_k (e_x^2, e_y^2, e_x e_y) of M for unit sides e at rest,
// C' = A M^-T C M^-1 has the energy 1/2 dl^T C' dl. Side k has the tension sum_m C'_km dl_m along itself. A
// spring holds the term of its own length. The other sides of its triangles shift its rest length: see Rings.
//
// A membrane that stiffens has the tension K (e + s g(e)) per width. g(e) is e^2 from 0 to a strain of 1/6,
// linear beyond, 0 in compression: with c = clamp(e, 0, 1/6), g = c (2 e - c) and g' = 2 c. A sheet's sides
// take all of s K g, so that the diagonals' share of the linear part and the contraction are the same as
// without it. A triangle stiffens by its strains along warp and weft, which are linear in dl.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "cloth/mesh/cook.h"
#include "cloth/mesh/rest/stiffness_map.h"
#include "weft/settings.h"

namespace weft {

constexpr double least_bound = 0.55;

/// A triangle's membrane as a function of its sides' lengths. Side k runs from corner k to the next.
struct TriangleMembrane {
    std::array<double, 3> rest_lengths;  ///< L [m]
    /// C'_kk, or more, so that diag(own) >= `least_bound` C' [N/m]. Iterations whose matrix holds these
    /// alone then converge on the whole.
    std::array<double, 3> own;
    std::array<std::array<double, 3>, 3> shared;  ///< C' less `own` on the diagonal [N/m]
};
[[nodiscard]] TriangleMembrane triangle_membrane(const ClothModel& model, std::uint32_t triangle,
                                                 const Fabric& fabric);

/// A triangle's stiffening terms, as functions of its strains along warp and weft.
struct TriangleStiffening {
    std::array<std::array<double, 3>, 2> strains;  ///< of warp and weft, per extension of each side [1/m]
    std::array<double, 2> moduli;                  ///< s K times the area [N m]

    struct Extra {
        std::array<double, 3> tension;  ///< of each side [N]
        std::array<double, 3> own;      ///< bounds the tension's slope, as TriangleMembrane::own [N/m]
    };
    [[nodiscard]] Extra at(const std::array<double, 3>& extensions) const;
};
[[nodiscard]] TriangleStiffening triangle_stiffening(const ClothModel& model, std::uint32_t triangle,
                                                     const Fabric& fabric);

constexpr double last_stiffening_strain = 1.0 / 6;
/// The stiffening law g and its slope g' at a strain.
struct Stiffened {
    double tension, slope;
};
[[nodiscard]] inline Stiffened stiffened(double strain) {
    const double c = std::clamp(strain, 0.0, last_stiffening_strain);
    return {c * (2 * strain - c), 2 * c};
}

/// The linear spring that has the tension and the slope of k x + q L g(x / L) at a length L + x.
struct LinearSpring {
    double rest_length, stiffness;
};
[[nodiscard]] inline LinearSpring spring_at(double length, double rest_length, double k, double q) {
    const Stiffened g = stiffened(length / rest_length - 1);
    const double slope = k + q * g.slope;
    if (slope <= 0) return {rest_length, 0};
    return {length - (k * (length - rest_length) + q * rest_length * g.tension) / slope, slope};
}

/// A sheet's moduli P, Q and G; see the head of this file.
struct SheetModuli {
    double warp, weft, shear;
};
[[nodiscard]] SheetModuli sheet_moduli(const Fabric& fabric);

/// Mean lengths of a cell's sides along u and along v [m]. The cell's near left corner is `near`.
struct CellSides {
    double a, b;
};
[[nodiscard]] inline CellSides sides_of_cell(const ClothModel& model, std::uint32_t near) {
    const std::uint32_t far = near + model.columns;
    const auto rest = [&](std::uint32_t i, std::uint32_t j) { return rest_length_between(model, i, j); };
    const double near_side = rest(near, near + 1), far_side = rest(far, far + 1), left = rest(near, far),
                 right = rest(near + 1, far + 1);
    return {(near_side + far_side) / 2, (left + right) / 2};
}

/// Calls add(i, j, q [N/m]) for the sides of that cell, with its share of the stiffening of their springs.
template <class Add>
void for_each_stiffening_of_cell(const ClothModel& model, const Fabric& fabric, std::uint32_t near,
                                 const Add& add) {
    const std::uint32_t far = near + model.columns;
    const auto [a, b] = sides_of_cell(model, near);
    const double s = static_cast<double>(fabric.stiffening) * stiffness_of_cell(model, near);
    const double along_a = s * static_cast<double>(fabric.warp) * b / a / 2,
                 along_b = s * static_cast<double>(fabric.weft) * a / b / 2;
    add(near, near + 1, along_a);
    add(far, far + 1, along_a);
    add(near, far, along_b);
    add(near + 1, far + 1, along_b);
}

/// Calls add(i, j, stiffness [N/m]) for the sides and diagonals of the cell whose near left corner is `near`,
/// with its share of their springs.
template <class Add>
void for_each_part_of_cell(const ClothModel& model, const SheetModuli& moduli, std::uint32_t near,
                           const Add& add) {
    const std::uint32_t far = near + model.columns;
    const auto [a, b] = sides_of_cell(model, near);
    const double factor = stiffness_of_cell(model, near);
    const double along_a = factor * ((moduli.warp * b / a - moduli.shear * a / b) / 2);
    const double along_b = factor * ((moduli.weft * a / b - moduli.shear * b / a) / 2);
    const double diagonal = factor * (moduli.shear * (a * a + b * b) / (2 * a * b));
    add(near, near + 1, along_a);
    add(far, far + 1, along_a);
    add(near, far, along_b);
    add(near + 1, far + 1, along_b);
    add(near, far + 1, diagonal);
    add(near + 1, far, diagonal);
}

/// Calls body(half-edge from i, half-edge from j, stiffness [N/m]) for each share of each spring (i, j): one
/// for each cell or triangle that the spring is a side of. The stiffness of a spring is the sum of its
/// shares, but no less than 0.
template <class Body>
void for_each_spring_part(const ClothModel& model, const Fabric& fabric, const Body& body) {
    const auto add = [&](std::uint32_t i, std::uint32_t j, double stiffness) {
        body(half_edge_between(model, i, j), half_edge_between(model, j, i), stiffness);
    };
    for (std::uint32_t t = 0; model.rows == 0 && t < model.triangles.size(); ++t) {
        const TriangleMembrane membrane = triangle_membrane(model, t, fabric);
        for (std::size_t k = 0; k < 3; ++k)
            add(model.triangles[t][k], model.triangles[t][(k + 1) % 3], membrane.own[k]);
    }
    const SheetModuli moduli = sheet_moduli(fabric);
    for (std::uint32_t row = 0; row + 1 < model.rows; ++row)
        for (std::uint32_t column = 0; column + 1 < model.columns; ++column)
            for_each_part_of_cell(model, moduli, row * model.columns + column, add);
}

/// Computes the stiffness of each half-edge's spring [N/m].
void spring_stiffness(const ClothModel& model, const Fabric& fabric, std::span<float> stiffness) noexcept;

}  // namespace weft
