// A particle's row without the fabric, lane by lane. Included as lanes-inl.h.

#if defined(WEFT_CLOTH_EQUATION_EXTERNAL_ROW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_EQUATION_EXTERNAL_ROW_INL_H
#undef WEFT_CLOTH_EQUATION_EXTERNAL_ROW_INL_H
#else
#define WEFT_CLOTH_EQUATION_EXTERNAL_ROW_INL_H
#endif

#include "cloth/equation/contacts.h"
#include "cloth/equation/filling_row.h"
#include "cloth/equation/sparse/stencil-inl.h"
#include "cloth/equation/step_equation.h"
#include "engine/simd/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

HWY_INLINE Lanes3 set(const Vector3& v) {
    return {set(v.x()), set(v.y()), set(v.z())};
}

/// G of the lanes from particle `i` on.
HWY_INLINE SymmetricLanes contact_blocks(const ContactRows& contacts, std::uint32_t i) {
    return load_symmetric(&contacts.blocks[lane_index(i, 0, 6)]);
}
/// The part of G in relaxation's diagonal. A multigrid cycle damps by 5/6, so 5/6 of G solves a row at once
/// where contact outweighs the rest. 2 D - W is positive definite with half of G or more.
HWY_INLINE SymmetricLanes contact_diagonal(const ContactRows& contacts, std::uint32_t i) {
    const SymmetricLanes of_colliders = set(5.0f / 6) * contact_blocks(contacts, i);
    if (contacts.in_relaxation.size() == 0) return of_colliders;
    return of_colliders + load_symmetric(&contacts.in_relaxation[lane_index(i, 0, 6)]);
}

/// A row from inertia, gravity, air and contact.
struct Row {
    Lanes3 impulse;  ///< gamma f - M (v - v_base) [kg m/s]
    Lanes row_sum;   ///< [kg], without contact; 0 for pinned particles
};

/// Row of the lanes from particle `i` on, which have inverse masses `w` and velocities `v`.
HWY_INLINE Row external_row(const StepEquation& equation, std::uint32_t i, Lanes w, const Lanes3& v) {
    const ExternalForces& external = equation.external;
    const Lanes gamma = set(equation.gamma), air_damping = set(external.air_damping);
    const auto free = hn::Ne(w, set(0));
    const Lanes mass = hn::IfThenElseZero(free, hn::Div(set(1), w));
    const Lanes3 acceleration = set(external.gravity) - air_damping * v;
    const Lanes3 behind = xyz(load_rows(&equation.base_velocities[i])) - v;
    Row row = {.impulse = mass * mul_add(gamma, acceleration, behind),
               .row_sum = mass * hn::MulAdd(gamma, air_damping, set(1))};
    if (!external.air.empty()) {
        const Lanes4 air = load_rows(&external.air[i]);
        const Lanes3 since = xyz(load_rows(&equation.velocities[i])) - v;
        row.impulse = mul_add(gamma, mul_add(air.w, since, xyz(air)), row.impulse);
        row.row_sum = hn::MulAdd(gamma, air.w, row.row_sum);
    }
    if (const FillingRow* const filling = external.filling; filling != nullptr)
        row.impulse =
            mul_add(gamma * set(filling->pressure()), xyz(load_rows(&filling->gradient()[i])), row.impulse);
    const ContactRows* const contacts = equation.contacts != nullptr ? &equation.contacts->rows() : nullptr;
    if (touches(contacts, i))
        row.impulse =
            row.impulse + (xyz(load_rows(&contacts->impulses[i])) - contact_blocks(*contacts, i) * v);
    row.row_sum = hn::IfThenElseZero(free, row.row_sum);
    return row;
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
