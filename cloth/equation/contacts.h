#pragma once
// Colliders as forces in the implicit step. Contact after the step would bear only the particles that touch:
// tension would draw these into the collider, and the cloth that hangs from them would fall.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/equation/moving_body.h"
#include "cloth/equation/pairs/pair_rows.h"
#include "cloth/equation/seam_rows.h"
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
    std::span<const std::uint32_t> touching;  ///< see HeldContacts; rows of other groups are undefined
    /// Relaxation adds this to its diagonal for contact between particles [kg]; laid out as blocks. Empty:
    /// nothing.
    AlignedBuffer<float> in_relaxation;

    [[nodiscard]] bool touches(std::uint32_t i) const { return touching[i / Stencil::lanes] != 0; }
    /// Precondition: the particle's group touches.
    [[nodiscard]] Symmetric3 block(std::uint32_t i) const {
        const auto value = [&](std::uint32_t k) { return blocks[lane_index(i, k, 6)]; };
        return {value(0), value(1), value(2), value(3), value(4), value(5)};
    }
};

/// Whether contact acts on the particle's group; `contacts` is null without colliders.
[[nodiscard]] inline bool touches(const ContactRows* contacts, std::uint32_t i) {
    return contacts != nullptr && contacts->touches(i);
}

/// Buffers for a cloth's contacts with bodies.
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
    std::vector<BodyPush> pushes;  ///< as last linearised, by particle; attached ones last
};

/// A cloth's limits, which hold its particles as colliders do.
class OwnSurfaces {
  public:
    virtual ~OwnSurfaces() = default;
    /// Overwrites the surfaces in `near` where a limit is nearer. `found`: whether any collider is near; if
    /// not, only the points are set. Returns whether any surface is near. See find_near_surfaces().
    virtual bool adjust(const BlockRange& range, float reach, bool found, NearSurfaces& near) noexcept = 0;
    /// Whether the particle presses on a limit, not on a collider.
    [[nodiscard]] virtual bool holds(std::uint32_t particle) const noexcept = 0;
};

/// Contact of a cloth's particles with colliders, found anew at each linearisation. A particle that would end
/// the step nearer than the thickness is pushed out by a stiff spring (Terzopoulos, Platt, Barr, Fleischer
/// 1987). A damper in the plane of contact holds it up to Coulomb's limit, as far as that is known. The
/// spring yields by a fiftieth of a free step's fall under a particle's own weight; collide() corrects that
/// afterwards. The load of the last step, along the normal and across it, acts from the start, and spring and
/// damper bear only the rest, so that resting cloth keeps its support and does not creep (augmented
/// Lagrangian: Hestenes 1969, Powell 1969).
class Contacts {
  public:
    /// `with_pairs`: the cloth's features meet others, or it has seams.
    explicit Contacts(std::uint32_t particles, bool with_pairs = false);

    /// Begins a substep with these motions of colliders, the cloth's side of contact, and what the last
    /// substep left in `held`. The arguments must outlive it.
    void begin(std::span<const ColliderMotion> colliders, const ClothSide& side, HeldContacts& held,
               OwnSurfaces* own = nullptr) {
        colliders_ = colliders;
        side_ = side;
        own_ = own;
        held_ = &held;
        pairs_ = nullptr;
        seams_ = {};
        rows_.touching = held.touching.span();
        passes_ = 0;
        body_buffers_ = nullptr;
        bodies_ = {};
        attached_ = {};
    }
    /// After begin(): `bodies` carry some of the colliders, and the `attached` particles, ascending, are
    /// attached to them. Colliders of bodies that give way come last. `areas`: rest area of each particle, 0
    /// for loose ones.
    void carry(std::span<const MovingBody> bodies, std::span<const Attachment> attached,
               std::span<const float> areas, BodyBuffers& buffers);
    /// After begin(): the rows include these pairs, or none if null, and these seams. Both number the cloth's
    /// particles from `first` on, a multiple of 16. The caller linearises them before each begin_pass().
    void join(const PairRows* pairs, std::span<SeamRows* const> seams, std::uint32_t first) {
        pairs_ = pairs;
        seams_ = seams;
        first_ = first;
        rows_.touching = touching_.span();
    }
    /// Begins another linearisation. Every block must be linearised before its rows are read.
    const ContactRows* begin_pass() {
        ++passes_;
        return &rows_;
    }
    /// Linearises a block's rows about `velocities`. The loop that reads the rows calls it, while they are in
    /// the cache.
    void linearise(const StepEquation& equation, std::span<const Vec4> velocities, const BlockRange& range);
    /// Ends the substep at these velocities: stores how hard particles press, for the next one.
    void finish(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities);
    /// After finish(): particles that pressed a collider rebound by the restitution.
    void bounce(Parallel& parallel, const StepEquation& equation, std::span<Vec4> velocities);

    /// Finds the particles that press on bodies or are attached to them, as linearised at these velocities.
    void find_pushes(const StepEquation& equation, std::span<const Vec4> velocities);
    /// Finds where bodies meet particles that do not give way: pinned or squeezed ones.
    void find_stops(const StepEquation& equation, std::span<const Vec4> velocities);
    [[nodiscard]] std::span<const BodyStop> stops() const noexcept {
        return body_buffers_ != nullptr ? std::span<const BodyStop>(body_buffers_->stops)
                                        : std::span<const BodyStop>();
    }
    [[nodiscard]] std::span<BodyPush> pushes() const noexcept {
        return body_buffers_ != nullptr ? std::span<BodyPush>(body_buffers_->pushes) : std::span<BodyPush>();
    }
    /// Adds an impulse that no velocity changes: the body moves otherwise than it was linearised with.
    void add_impulse(std::uint32_t particle, const Vector3& impulse) {
        if (has_pairs()) set_xyz(of_colliders_[particle], xyz(of_colliders_[particle]) + impulse);
        set_xyz(rows_.impulses[particle], xyz(rows_.impulses[particle]) + impulse);
    }
    /// Whether the particle is attached to a body.
    [[nodiscard]] bool is_attached(std::uint32_t particle) const noexcept {
        const auto at = std::ranges::lower_bound(attached_, particle, {}, &Attachment::particle);
        return at != attached_.end() && at->particle == particle;
    }
    /// Whether anything outside of the cloth acts on the particle: a collider, its leash or backstop, or a
    /// body that it is attached to.
    [[nodiscard]] bool is_held(std::uint32_t particle) const noexcept {
        return presses_surface(particle) || is_attached(particle);
    }

    [[nodiscard]] const ContactRows& rows() const noexcept { return rows_; }
    /// Whether the particle presses a collider, in the last linearisation.
    [[nodiscard]] bool presses_collider(std::uint32_t particle) const noexcept {
        return presses_surface(particle) && (own_ == nullptr || !own_->holds(particle));
    }
    /// Whether the particle presses a collider, its leash or its backstop, in the last linearisation.
    [[nodiscard]] bool presses_surface(std::uint32_t particle) const noexcept {
        return held_->touching[particle / Stencil::lanes] != 0 && !xyz(held_->normals[particle]).isZero(0);
    }
    /// Number of particles that press a collider, in the last linearisation.
    [[nodiscard]] std::uint32_t pressing() const noexcept;
    /// Impulse of colliders on a particle whose group touches, at the velocity v [kg m/s].
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

    ContactRows rows_;                       // rows of the equation
    AlignedBuffer<Vec4> of_colliders_;       // impulses of colliders alone, with pairs; else empty
    AlignedBuffer<std::uint32_t> touching_;  // rows_.touching, with pairs; else empty
    const PairRows* pairs_ = nullptr;
    std::span<SeamRows* const> seams_;
    std::uint32_t first_ = 0;
    HeldContacts* held_ = nullptr;
    std::span<const ColliderMotion> colliders_;
    ClothSide side_;  // of all particles
    OwnSurfaces* own_ = nullptr;
    int passes_ = 0;                       // linearisations in this substep
    BodyBuffers* body_buffers_ = nullptr;  // null: no bodies
    std::span<const MovingBody> bodies_;
    std::span<const Attachment> attached_;
    std::span<const float> areas_;
    std::size_t firm_ = 0;  // number of colliders that do not give way; they come first

    // Search radius for particles that may come into contact [m]: somewhat more than a free step's fall.
    static constexpr float reach = 4e-3f;
};

}  // namespace weft
