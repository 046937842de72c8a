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

/// A group's cloths in the order in which a part of a substep solves them, and what it makes of each. Cloths
/// that are one equation follow one another: a set. All arrays are scratch.
struct Group {
    void lay_out(Scratch& scratch, std::size_t count);

    ScratchArray<Cloth*> cloths;        ///< set by set; what follows is in this order, too
    ScratchArray<Cloth*> featured;      ///< those that have features, in the group's order, and
    ScratchArray<ContactCloth> bodies;  ///< these as bodies in contact
    ScratchArray<StepEquation> equations;
    ScratchArray<SolverStep> steps;
    ScratchArray<PassMember> members;
    ScratchArray<float> residuals;
    std::size_t featured_count = 0;
    FeatureContact contact;  ///< of these, if there are any

    /// Lists those of the group's cloths that have features, and each as a body in contact.
    void add_featured(std::span<Cloth* const> group);
    [[nodiscard]] std::span<Cloth* const> all_featured() const {
        return featured.span().first(featured_count);
    }
    [[nodiscard]] std::span<const ContactCloth> all_bodies() const {
        return bodies.span().first(featured_count);
    }
};

/// Bytes of scratch that features take in a group of one cloth, and at most add to what a group takes. `mesh`
/// is theirs, or null.
[[nodiscard]] std::size_t scratch_bytes(const ContactMesh* mesh, bool by_zones) noexcept;

}  // namespace weft
