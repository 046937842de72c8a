#include "cloth/methods/finite_elements/triangle_elements.h"

#include <cmath>

#include <Eigen/LU>

#include "cloth/mesh/rest/rest_elements.h"
#include "cloth/mesh/rest/slivers.h"
#include "cloth/mesh/rest/stiffness_map.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/methods/finite_elements/triangle_elements.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/methods/finite_elements/triangle_fem-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

HWY_INLINE Point<Lanes> gathered(const Vec4* rows, const SharedBuffer<std::uint32_t>& nodes,
                                 std::uint32_t t) {
    const Lanes3 v = gather_rows(rows, &nodes[t]);
    return {v.x, v.y, v.z};
}

HWY_INLINE void store(const Point<Lanes>& v, Vec4* rows, Lanes w = hn::Zero(Tag())) {
    store_rows({v.x, v.y, v.z}, w, rows);
}

HWY_INLINE void store(const Block<Lanes>& block, Lanes tension, Vec4* rows) {
    store(block.x, rows, tension);
    store(block.y, rows + Stencil::lanes);
    store(block.z, rows + 2 * Stencil::lanes);
}

void compute(TriangleElements& elements, const BlockRange& range, const TrianglePass& pass) {
    const Tag d;
    const MembraneModuli& moduli = pass.moduli;
    const Elasticity<Lanes> c{hn::Set(d, moduli.warp), hn::Set(d, moduli.weft), hn::Set(d, moduli.coupling),
                              hn::Set(d, moduli.shear)};
    const Lanes viscosity = hn::Set(d, pass.viscosity);
    for (std::uint32_t t = range.begin; t < range.end; t += part_lanes) {
        const auto gradient_of = [&](const RestTriangle<Lanes>& rest, const Vec4* rows) HWY_ATTR {
            return gradient(rest, gathered(rows, elements.corners[0], t),
                            gathered(rows, elements.corners[1], t), gathered(rows, elements.corners[2], t));
        };
        const RestTriangle<Lanes> rest{load_lanes(&elements.rest[0][t]), load_lanes(&elements.rest[1][t]),
                                       load_lanes(&elements.rest[2][t]), load_lanes(&elements.rest[3][t]),
                                       load_lanes(&elements.rest[4][t])};
        const Polar<Lanes> p = polar(gradient_of(rest, pass.positions));
        const Planar<Lanes> elastic = stress(c, strain(p));
        Planar<Lanes> sigma = elastic;
        if (pass.velocities != nullptr) {
            const Planar<Lanes> viscous = stress(c, strain_rate(p, gradient_of(rest, pass.velocities)));
            sigma = {sigma.xx + viscosity * viscous.xx, sigma.yy + viscosity * viscous.yy,
                     sigma.xy + viscosity * viscous.xy};
        }
        const CornerForces<Lanes> f = forces(rest, p, sigma);
        const Lanes zero = hn::Zero(d);
        const Point<Lanes> on0{zero - f.on1.x - f.on2.x, zero - f.on1.y - f.on2.y, zero - f.on1.z - f.on2.z};
        const auto side = [&](std::uint32_t k) { return &elements.results[TriangleElements::side(t, k)]; };
        constexpr std::uint32_t force_row = 3 * Stencil::lanes;
        store(on0, side(0) + force_row);
        store(f.on1, side(1) + force_row);
        store(f.on2, side(2) + force_row);
        if (!pass.stiffness) continue;
        const Stiffness<Lanes> k = stiffness(
            rest, p, second_derivative(c, p, elastic, hn::Set(d, pass.elastic), hn::Set(d, pass.viscous)));
        store(k.from0to1, k.tension01, side(0));
        store(k.from1to2, k.tension12, side(1));
        store(k.from2to0, k.tension20, side(2));
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // code that does not depend on the machine
namespace weft {

HWY_EXPORT(compute);

TriangleElements::TriangleElements(const ClothModel& model)
    : count(static_cast<std::uint32_t>(model.triangles.size())) {
    for (SharedBuffer<std::uint32_t>& corner : corners) corner = SharedBuffer<std::uint32_t>(count);
    for (SharedBuffer<float>& values : rest) values = SharedBuffer<float>(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        for (std::size_t k = 0; k < 3; ++k) corners[k][t] = model.triangles[t][k];
        const RestSides sides = rest_sides(model, t);
        Eigen::Matrix2f shape;
        shape << sides.to1, sides.to2;
        const Eigen::Matrix2f gradients = shape.inverse();  // its rows are dphi_1/dX and dphi_2/dX
        const float values[] = {
            gradients(0, 0), gradients(0, 1), gradients(1, 0), gradients(1, 1),
            0.5f * std::abs(shape.determinant()) *
                static_cast<float>(stiffness_at(model, model.triangles[t]) * element_stiffness_left(sides))};
        for (std::size_t k = 0; k < 5; ++k) rest[k][t] = values[k];
    }
}

void TriangleElements::lay_out(Scratch& scratch) {
    constexpr std::size_t of_group = std::size_t{rows} * Stencil::lanes;
    scratch.take(results, zero_side() + of_group);
    if (scratch.has_memory()) std::ranges::fill(results.span().last(of_group), Vec4{});
}

std::size_t TriangleElements::bytes() const noexcept {
    std::size_t sum = 0;
    for (const SharedBuffer<std::uint32_t>& corner : corners) sum += corner.bytes();
    for (const SharedBuffer<float>& values : rest) sum += values.bytes();
    return sum;
}

MembraneModuli membrane_moduli(const Fabric& fabric, float poisson) {
    const float part = 1.0f / (1.0f - poisson * poisson);
    constexpr float least = 1e-4f;  // [N/m]; elements divide by these
    const float warp = std::max(fabric.warp, least), weft = std::max(fabric.weft, least);
    return {.warp = part * warp,
            .weft = part * weft,
            .coupling = part * poisson * std::sqrt(warp * weft),
            .shear = std::max(fabric.shear, least)};
}

void compute_triangles(TriangleElements& elements, const BlockRange& range, const TrianglePass& pass) {
    HWY_DYNAMIC_DISPATCH(compute)(elements, range, pass);
}

}  // namespace weft
#endif
