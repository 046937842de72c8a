#pragma once
// A group in the solve of a substep: the cloths that may touch or share a body, mostly one alone.

#include <cstddef>
#include <cstdint>
#include <span>

#include "cloth/frame/contact/feature_contact.h"
#include "cloth/solvers/multigrid/passes.h"
#include "cloth/solvers/solver.h"
#include "cloth/system/step_equation.h"
#include "engine/memory/scratch.h"

namespace weft {

struct Cloth;

/// What one part of a substep makes of a group. Cloths that are solved as one equation follow one another: a
/// set. All of it is scratch.
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

    /// Those of them that have features, as bodies in contact.
    void add_featured(std::span<Cloth* const> group);
    [[nodiscard]] std::span<Cloth* const> all_featured() const {
        return featured.span().first(featured_count);
    }
    [[nodiscard]] std::span<const ContactCloth> all_bodies() const {
        return bodies.span().first(featured_count);
    }
};

/// Scratch that a cloth adds to what its group takes; `mesh`: of its features, or null.
[[nodiscard]] std::size_t scratch_bytes(const ContactMesh* mesh, bool by_zones) noexcept;

}  // namespace weft
