#pragma once
// Colliders as forces in the implicit step. Met only after it, they would hold up nothing but the particles
// that touch them: tension would draw these into the collider instead of holding what hangs from them.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/equation/moving_body.h"
#include "cloth/equation/pair_rows.h"
#include "cloth/equation/sparse/stencil.h"
#include "cloth/equation/step_equation.h"
#include "cloth/state/held_contacts.h"
#include "collision/colliders/collider_contacts.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/simd/symmetric3.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

static_assert(HeldContacts::group == Stencil::lanes);

/// Contact gives particle i, at the velocity v_i, the impulse c_i - G_i v_i [kg m/s].
struct ContactRows {
    AlignedBuffer<float> blocks;              ///< G [kg], >= 0: per group 16 xx, yy, zz, xy, xz, yz
    AlignedBuffer<Vec4> impulses;             ///< c, w 0
    std::span<const std::uint32_t> touching;  ///< see HeldContacts; of a group that does not touch, blocks
                                              ///< and impulses may hold anything
    /// What relaxation is to have on its diagonal besides, for what particles do to one another [kg]: laid
    /// out as blocks. Empty: nothing.
    AlignedBuffer<float> in_relaxation;

    [[nodiscard]] bool touches(std::uint32_t i) const { return touching[i / Stencil::lanes] != 0; }
    /// Of a particle in a group that touches.
    [[nodiscard]] Symmetric3 block(std::uint32_t i) const {
        const auto value = [&](std::uint32_t k) { return blocks[lane_index(i, k, 6)]; };
        return {value(0), value(1), value(2), value(3), value(4), value(5)};
    }
};

/// Null: there are no colliders.
[[nodiscard]] inline bool touches(const ContactRows* contacts, std::uint32_t i) {
    return contacts != nullptr && contacts->touches(i);
}

/// What contacts of a cloth need besides where it may meet bodies.
struct BodyBuffers {
    BodyBuffers() = default;
    explicit BodyBuffers(std::uint32_t particles) : pressed(particles) {
        pushes.reserve(particles);
        stops.reserve(particles);
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return pressed.bytes() + pushes.capacity() * sizeof(BodyPush) + stops.capacity() * sizeof(BodyStop);
    }

    static constexpr std::int32_t none = -1, squeezed = -2;
    /// The body that each particle is nearest to; none; or squeezed, where a body presses the particle onto a
    /// collider that does not give way.
    AlignedBuffer<std::int32_t> pressed;
    std::vector<BodyStop> stops;   ///< as last linearised
    std::vector<BodyPush> pushes;  ///< as last linearised, ascending, those attached last
};

/// Limits of a cloth's particles, which hold these as colliders do.
class OwnSurfaces {
  public:
    virtual ~OwnSurfaces() = default;
    /// Adds to what was found of a block's particles what is nearer; `found` says whether anything was (else
    /// only the points are there). Returns whether any is near. See find_near_surfaces().
    virtual bool adjust(const BlockRange& range, float reach, bool found, NearSurfaces& near) noexcept = 0;
    /// Whether what a particle presses on is none of the colliders, but this.
    [[nodiscard]] virtual bool holds(std::uint32_t particle) const noexcept = 0;
};

/// Which particles press on a collider, and how, is found anew at each linearisation: particles that are to
/// be nearer than the thickness at the step's end are pushed out by a stiff spring (Terzopoulos, Platt, Barr,
/// Fleischer 1987), and held in the plane of contact by a damper that has Coulomb's limit as it is known so
/// far. What the spring yields, a fiftieth of a free step's fall under a particle's own weight, collide()
/// takes back afterwards; so that what rests keeps what bears it, the load of the last step presses from the
/// start (augmented Lagrangian: Hestenes 1969, Powell 1969), and the spring bears the rest only.
class Contacts {
  public:
    /// with_pairs: of a cloth whose features meet others.
    explicit Contacts(std::uint32_t particles, bool with_pairs = false);

    /// A substep begins, in which colliders move so and meet the cloth so, with what the last one left. All
    /// must outlive it.
    void begin(std::span<const ColliderMotion> colliders, const ClothSide& side, HeldContacts& held,
               OwnSurfaces* own = nullptr) {
        colliders_ = colliders;
        side_ = side;
        own_ = own;
        held_ = &held;
        pairs_ = nullptr;
        rows_.touching = held.touching.span();
        passes_ = 0;
        body_buffers_ = nullptr;
        bodies_ = {};
        attached_ = {};
    }
    /// Then: some of the colliders are of these bodies, and these particles, ascending, are attached to them.
    /// Colliders of bodies that give way come last. `areas`: the rest area of each particle, 0 for loose
    /// ones.
    void carry(std::span<const MovingBody> bodies, std::span<const Attachment> attached,
               std::span<const float> areas, BodyBuffers& buffers);
    /// Then: its rows are to hold these pairs, too, in which the cloth's particles are numbered from `first`
    /// on, a multiple of 16. Whoever has another linearisation begin linearises the pairs before.
    void join(const PairRows& pairs, std::uint32_t first) {
        pairs_ = &pairs;
        first_ = first;
        rows_.touching = touching_.span();
    }
    /// Another linearisation begins, in which every block is to be linearised before its rows are read.
    const ContactRows* begin_pass() {
        ++passes_;
        return &rows_;
    }
    /// The rows of a block, linearised about `velocities`: in the loop that reads them, as long as they are
    /// near.
    void linearise(const StepEquation& equation, std::span<const Vec4> velocities, const BlockRange& range);
    /// The substep ends with these velocities: keeps how hard particles press, for the next one.
    void finish(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities);
    /// After that: what pressed a collider leaves it as fast as it bounces.
    void bounce(Parallel& parallel, const StepEquation& equation, std::span<Vec4> velocities);
    /// The pairs have been linearised again, the colliders not.
    void renew_pairs(Parallel& parallel);

    /// What presses on bodies, and is attached to them, in a linearisation at these velocities.
    void find_pushes(const StepEquation& equation, std::span<const Vec4> velocities);
    /// Where bodies meet particles that do not give way: pinned or squeezed ones.
    void find_stops(const StepEquation& equation, std::span<const Vec4> velocities);
    [[nodiscard]] std::span<const BodyStop> stops() const noexcept {
        return body_buffers_ != nullptr ? std::span<const BodyStop>(body_buffers_->stops)
                                        : std::span<const BodyStop>();
    }
    [[nodiscard]] std::span<BodyPush> pushes() const noexcept {
        return body_buffers_ != nullptr ? std::span<BodyPush>(body_buffers_->pushes) : std::span<BodyPush>();
    }
    /// A particle gets this at any velocity, since a body moves otherwise than it was linearised with.
    void add_impulse(std::uint32_t particle, const Vector3& impulse) {
        if (has_pairs()) set_xyz(of_colliders_[particle], xyz(of_colliders_[particle]) + impulse);
        set_xyz(rows_.impulses[particle], xyz(rows_.impulses[particle]) + impulse);
    }
    /// To a body.
    [[nodiscard]] bool is_attached(std::uint32_t particle) const noexcept {
        const auto at = std::ranges::lower_bound(attached_, particle, {}, &Attachment::particle);
        return at != attached_.end() && at->particle == particle;
    }
    /// Whether anything outside of the cloth acts on it: a collider, its leash or backstop, or a body that it
    /// is attached to.
    [[nodiscard]] bool is_held(std::uint32_t particle) const noexcept {
        return presses_surface(particle) || is_attached(particle);
    }

    [[nodiscard]] const ContactRows& rows() const noexcept { return rows_; }
    /// In the last linearisation.
    [[nodiscard]] bool presses_collider(std::uint32_t particle) const noexcept {
        return presses_surface(particle) && (own_ == nullptr || !own_->holds(particle));
    }
    /// A collider, its leash or its backstop, in the last linearisation.
    [[nodiscard]] bool presses_surface(std::uint32_t particle) const noexcept {
        return held_->touching[particle / Stencil::lanes] != 0 && !xyz(held_->normals[particle]).isZero(0);
    }
    /// How many particles press a collider, in the last linearisation.
    [[nodiscard]] std::uint32_t pressing() const noexcept;
    /// What colliders give such a particle at the velocity v [kg m/s].
    [[nodiscard]] Vector3 of_colliders(std::uint32_t particle, const Vector3& v) const {
        const AlignedBuffer<Vec4>& at_rest = has_pairs() ? of_colliders_ : rows_.impulses;
        return xyz(at_rest[particle]) - rows_.block(particle) * v;
    }
    [[nodiscard]] bool has_pairs() const noexcept { return touching_.size() > 0; }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return rows_.blocks.bytes() + rows_.impulses.bytes() + rows_.in_relaxation.bytes() +
               of_colliders_.bytes() + touching_.bytes();
    }

  private:
    void keep_loads(const StepEquation& equation, std::span<const Vec4> velocities, const BlockRange& range);
    void press(const BlockRange& range, std::span<const Vec4> velocities);
    void bounce_block(const StepEquation& equation, const BlockRange& range, std::span<Vec4> velocities);
    void add_pairs(const BlockRange& range);
    void attach_block(const StepEquation& equation, std::span<const Vec4> velocities,
                      const BlockRange& range);
    void find_squeezed(const StepEquation& equation, std::span<const Vec4> velocities,
                       const BlockRange& range, NearSurfaces& near, std::span<std::int32_t> pressed) const;
    void add_stop(const StepEquation& equation, const NearSurfaces& near, std::uint32_t k,
                  const Vector3& velocity, std::uint32_t body);
    /// Impulses of colliders alone.
    [[nodiscard]] AlignedBuffer<Vec4>& of_colliders() noexcept {
        return has_pairs() ? of_colliders_ : rows_.impulses;
    }

    ContactRows rows_;                       // in the equation
    AlignedBuffer<Vec4> of_colliders_;       // their impulses, where these are not all; else empty
    AlignedBuffer<std::uint32_t> touching_;  // likewise: of rows_
    const PairRows* pairs_ = nullptr;
    std::uint32_t first_ = 0;
    HeldContacts* held_ = nullptr;
    std::span<const ColliderMotion> colliders_;
    ClothSide side_;  // of all particles
    OwnSurfaces* own_ = nullptr;
    int passes_ = 0;                       // of this substep
    BodyBuffers* body_buffers_ = nullptr;  // null: no bodies
    std::span<const MovingBody> bodies_;
    std::span<const Attachment> attached_;
    std::span<const float> areas_;
    std::size_t firm_ = 0;  // colliders that do not give way, the first

    // Somewhat more than a free step falls: what may come into contact is nearer than this [m].
    static constexpr float reach = 4e-3f;
};

}  // namespace weft
