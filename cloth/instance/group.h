#pragma once
// A group in the solve of a substep: the cloths that may touch or share a body, mostly one alone.

#include <cstddef>
#include <cstdint>
#include <span>

#include "cloth/contact/feature_contact.h"
#include "cloth/equation/step_equation.h"
#include "cloth/solver/passes/passes.h"
#include "cloth/solver/solver.h"
#include "engine/memory/scratch.h"

namespace weft {

struct Cloth;

/// A group's cloths in the order in which a part of a substep solves them, and the data of each cloth's
/// solve. The cloths of one equation are consecutive: a set. All arrays are scratch.
struct Group {
    void lay_out(Scratch& scratch, std::size_t count);

    ScratchArray<Cloth*> cloths;        ///< set by set; equations, steps, members, residuals are parallel
    ScratchArray<Cloth*> featured;      ///< cloths that have features, in the order given, and
    ScratchArray<ContactCloth> bodies;  ///< the same cloths as bodies in contact
    ScratchArray<StepEquation> equations;
    ScratchArray<SolverStep> steps;
    ScratchArray<PassMember> members;
    ScratchArray<float> residuals;
    std::size_t featured_count = 0;
    FeatureContact contact;  ///< of the featured cloths, if there are any

    /// Lists the cloths of the group that have features, each also as a body in contact.
    void add_featured(std::span<Cloth* const> group);
    [[nodiscard]] std::span<Cloth* const> all_featured() const {
        return featured.span().first(featured_count);
    }
    [[nodiscard]] std::span<const ContactCloth> all_bodies() const {
        return bodies.span().first(featured_count);
    }
};

/// Bytes of scratch of a group of one cloth with this mesh of features, or null. A cloth adds at most as many
/// to a larger group.
[[nodiscard]] std::size_t scratch_bytes(const ContactMesh* mesh, bool by_zones) noexcept;

}  // namespace weft
