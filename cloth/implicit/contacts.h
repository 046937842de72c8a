#pragma once
// Colliders as forces in the implicit step. Met only after it, they would hold up nothing but the particles
// that touch them: tension would draw these into the collider instead of holding what hangs from them.

#include <cstdint>
#include <span>

#include "cloth/implicit/stencil.h"
#include "cloth/implicit/step_equation.h"
#include "cloth/implicit/symmetric3.h"
#include "collision/collider_contacts.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// Contact gives particle i, at the velocity v_i, the impulse c_i - G_i v_i [kg m/s].
struct ContactRows {
    AlignedBuffer<float> blocks;            ///< G [kg], >= 0: per group 16 xx, yy, zz, xy, xz, yz
    AlignedBuffer<Vec4> impulses;           ///< c; w what the damper took when last looked at [kg m/s]
    AlignedBuffer<std::uint32_t> touching;  ///< per group: whether a particle of it is in contact; else the
                                            ///< group's blocks and impulses may hold anything

    [[nodiscard]] bool touches(std::uint32_t i) const { return touching[i / Stencil::lanes] != 0; }
    /// Of a particle in a group that touches.
    [[nodiscard]] Symmetric3 block(std::uint32_t i) const {
        const auto value = [&](std::uint32_t k) { return blocks[lane_index(i, k, 6)]; };
        return {value(0), value(1), value(2), value(3), value(4), value(5)};
    }
};

/// Null: nothing is in contact.
[[nodiscard]] inline bool touches(const ContactRows* contacts, std::uint32_t i) {
    return contacts != nullptr && contacts->touches(i);
}

/// Which particles press on a collider, and how, is found anew at each linearisation: particles that are to
/// be nearer than the thickness at the step's end are pushed out by a stiff spring (Terzopoulos, Platt, Barr,
/// Fleischer 1987), and held in the plane of contact by a damper that has Coulomb's limit as it is known so
/// far. What the spring yields, a fiftieth of a free step's fall under a particle's own weight, collide()
/// takes back afterwards.
class Contacts {
  public:
    explicit Contacts(std::uint32_t particles);

    /// A substep begins, in which colliders move so. They must outlive it.
    void begin(std::span<const ColliderMotion> colliders) {
        colliders_ = colliders;
        is_first_ = true;
    }
    /// The rows, linearised about `velocities`. Null if nothing is in contact.
    const ContactRows* linearise(Parallel& parallel, const StepEquation& equation,
                                 std::span<const Vec4> velocities);
    /// The substep ends with the equation's velocities + changes: keeps how hard particles press, for the
    /// next one's friction.
    void finish(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> changes) {
        press(parallel, equation.velocities, changes);
    }
    /// Normals of contact, 0 without it; w the impulse along it [kg m/s].
    [[nodiscard]] std::span<const Vec4> normals() const noexcept { return normals_.span(); }

    [[nodiscard]] const ContactRows* rows() const noexcept { return touching_groups_ > 0 ? &rows_ : nullptr; }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return rows_.blocks.bytes() + rows_.impulses.bytes() + rows_.touching.bytes() + normals_.bytes() +
               partials_.bytes();
    }

  private:
    /// Returns how many groups of the block are in contact.
    std::uint32_t linearise_block(const StepEquation& equation, std::span<const Vec4> velocities,
                                  const BlockRange& range);
    void press(Parallel& parallel, std::span<const Vec4> velocities, std::span<const Vec4> changes = {});

    ContactRows rows_;
    AlignedBuffer<Vec4> normals_;
    AlignedBuffer<std::uint32_t> partials_;
    std::span<const ColliderMotion> colliders_;
    std::uint32_t touching_groups_ = 0;
    bool is_first_ = true;
};

}  // namespace weft
