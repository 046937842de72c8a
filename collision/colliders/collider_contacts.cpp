#include "collision/colliders/collider_contacts.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>

#include "collision/colliders/collider_kernels.h"
#include "collision/shapes/moving_shapes.h"
#include "engine/vector.h"

namespace weft {

namespace {

FoundDepth found_depth(const ColliderMotion& motion) {
    return finds_depth(motion) ? FoundDepth{.least = 2e-5f} : FoundDepth{};  // above rounding
}

/// A block's properties towards one collider. Particles that do not meet it have a thickness that no depth
/// makes up for.
class MaskedSide {
  public:
    MaskedSide(const ClothSide& all, const Collider& collider) : all_(all) {
        if (all.masks.empty()) return;
        const auto size = static_cast<std::uint32_t>(all.thickness.size());
        meeting_ = 0;
        for (std::uint32_t k = 0; k < size; ++k) meeting_ += all.meets(collider, k) ? 1 : 0;
        if (meeting_ == 0 || meeting_ == size) return;
        thickness_.fill(out_of_reach);
        for (std::uint32_t k = 0; k < size; ++k)
            if (all.meets(collider, k)) thickness_[k] = all.thickness[k];
        masked_ = all;
        masked_.thickness = std::span(thickness_).first(size);
    }
    MaskedSide(const MaskedSide&) = delete;
    MaskedSide& operator=(const MaskedSide&) = delete;
    [[nodiscard]] bool meets_any() const { return meeting_ > 0; }
    [[nodiscard]] const ClothSide& side() const { return masked_.thickness.empty() ? all_ : masked_; }

  private:
    static constexpr float out_of_reach = -1e30f;  // [m]
    const ClothSide& all_;
    ClothSide masked_;
    std::uint32_t meeting_ = 1;
    alignas(64) std::array<float, block_size> thickness_;
};

/// Calls use(moving shape, Meeting, the block's ClothSide) unless the shape is farther from the paths than
/// thickness plus reach, or masks exclude it.
template <class Use>
void if_near(const ColliderMotion& motion, float h, const ClothSide& cloth, float beyond,
             const BlockPaths& paths, const Use& use) {
    if (!cloth.meets(motion.end) || !may_be_near(motion, cloth.most_thickness + beyond, paths)) return;
    const Pace pace{h, motion.fastest};
    const Reach reach{thickness_of(motion, cloth), beyond};
    with_shapes(motion, [&](const auto& start, const auto& end) {
        const auto meeting = may_meet(start, end, pace, reach, paths);
        if (!meeting) return;
        const MaskedSide masked(cloth, motion.end);
        if (masked.meets_any()) use(moving(start, end, pace), *meeting, masked.side());
    });
}

void clear(NearSurfaces& near, float reach) {
    for (BlockLanes* lanes : {&near.surfaces, &near.motions})
        for (auto* component : {&lanes->x, &lanes->y, &lanes->z, &lanes->w}) component->fill(0);
    near.surfaces.w.fill(reach);
    near.has_inside = false;
}

/// Stores this collider, the nearest to the i-th particle: its body, and the body's velocity at the particle.
void take_body(const ColliderMotion& motion, std::size_t i, NearSurfaces& near,
               std::span<std::int32_t> bodies) {
    bodies[i] = motion.body;
    if (motion.body < 0) return;
    const Vector3 arm = Vector3(near.points.x[i], near.points.y[i], near.points.z[i]) - motion.centre;
    const Vector3 v = motion.velocity + motion.spin.cross(arm);
    near.motions.x[i] = v.x();
    near.motions.y[i] = v.y();
    near.motions.z[i] = v.z();
}

Vector3 vector_of(const BlockLanes& lanes, std::size_t k) {
    return {lanes.x[k], lanes.y[k], lanes.z[k]};
}

/// Decides which surface counts for particles that are also inside a collider.
void choose_surfaces(std::uint32_t size, float reach, NearSurfaces& near, std::span<std::int32_t> bodies) {
    for (std::uint32_t k = 0; k < size; ++k) {
        if (!(near.inside.w[k] < std::numeric_limits<float>::infinity())) continue;
        const bool faces = vector_of(near.inside, k).dot(vector_of(near.surfaces, k)) < 0;
        if (near.surfaces.w[k] < reach && faces) {
            near.motions.w[k] = held_fast;
        } else if (near.inside.w[k] < near.surfaces.w[k]) {
            for (auto component : {&BlockLanes::x, &BlockLanes::y, &BlockLanes::z, &BlockLanes::w}) {
                (near.surfaces.*component)[k] = (near.inside.*component)[k];
                (near.motions.*component)[k] = (near.inside_motions.*component)[k];
            }
            if (!bodies.empty()) bodies[k] = -1;
        }
    }
}

/// Searches around the points that place() has written.
bool find_nearest_of(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h, float reach,
                     std::span<const Vec4> starts, const BlockPaths& paths, std::uint32_t size, Told told,
                     NearSurfaces& near, std::span<std::int32_t> bodies = {},
                     const ColliderMotion* skipped = nullptr) {
    std::ranges::fill(bodies, -1);
    std::array<float, block_size> before;
    bool is_clear = true, found = false;
    for (const ColliderMotion& motion : colliders) {
        if (&motion == skipped) continue;
        const auto search = [&](const auto& shape, const Meeting& meeting, const ClothSide& side) {
            if (is_clear) clear(near, reach);
            is_clear = false;
            const ContactSettings settings{.thickness = thickness_of(motion, cloth),
                                           .friction = motion.end.friction,
                                           .h = h,
                                           .restitution = restitution_of(motion, cloth),
                                           .found = found_depth(motion),
                                           .meeting = starts.empty() ? Meeting{} : meeting};
            if (!bodies.empty()) before = near.surfaces.w;
            found |= find_nearest(shape, {settings, side, reach, starts, size, told}, near);
            for (std::size_t i = 0; i < bodies.size(); ++i)
                if (near.surfaces.w[i] < before[i]) take_body(motion, i, near, bodies);
        };
        if_near(motion, h, cloth, reach, paths, search);
    }
    if (near.has_inside) choose_surfaces(size, reach, near, bodies);
    return found;
}

/// Moves particles part of the way out of colliders they were left inside of, unless that leads them deeper
/// into another collider at whose surface they are.
class Emerging {
  public:
    Emerging(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
             CollidingBlock& block)
        : colliders_(colliders), cloth_(cloth), h_(h), block_(block) {}

    void all() {
        const LeftInside& left = *block_.left;
        std::uint32_t waiting = 0;
        for (std::uint32_t k = 0; k < block_.positions.size(); ++k)
            if (left.surfaces.w[k] > 0) waiting_[waiting++] = k;
        while (waiting > 0) {
            const std::uint32_t number = left.colliders[waiting_[0]];
            std::uint32_t others = 0;
            size_ = 0;
            for (std::uint32_t m = 0; m < waiting; ++m) {
                const std::uint32_t k = waiting_[m];
                if (left.colliders[k] == number)
                    particles_[size_++] = k;
                else
                    waiting_[others++] = k;
            }
            waiting = others;
            out_of(number);
        }
    }

  private:
    static constexpr float reach = 1e-3f;
    static constexpr std::uint32_t group = 16;  // arrays extend to its end

    void out_of(std::uint32_t number) {
        std::array<Vec4, block_size> now, then;
        for (std::uint32_t m = 0; m < size_; ++m) {
            now[m] = then[m] = block_.positions[particles_[m]];
            set_xyz(then[m], xyz(now[m]) + way_of(particles_[m]));
        }
        for (std::uint32_t m = size_; m % group != 0; ++m) now[m] = then[m] = now[0];
        NearSurfaces at_now, at_then;
        find_others(number, {now.data(), size_}, at_now);
        find_others(number, {then.data(), size_}, at_then);
        for (std::uint32_t m = 0; m < size_; ++m) {
            const std::uint32_t k = particles_[m];
            const float before = at_now.surfaces.w[m], after = at_then.surfaces.w[m];
            const bool is_held = after < std::min(0.0f, before) && before > -FoundDepth::speed * h_;
            if (!is_held) block_.positions[k] = then[m];
        }
    }
    [[nodiscard]] Vector3 way_of(std::uint32_t k) const {
        const float depth = block_.left->surfaces.w[k];
        const float way = std::min(depth, h_ * std::max(FoundDepth::speed, FoundDepth::rate * depth));
        return way * vector_of(block_.left->surfaces, k);
    }
    void find_others(std::uint32_t number, std::span<const Vec4> points, NearSurfaces& near) const {
        alignas(64) std::array<float, block_size> thickness{}, friction{}, masks;
        for (std::uint32_t m = 0; m < size_; ++m) thickness[m] = cloth_.thickness[particles_[m]];
        ClothSide side = cloth_;
        side.thickness = std::span(thickness).first(size_);
        side.friction = std::span(friction).first(size_);
        side.normals = {};
        if (!cloth_.masks.empty()) {
            for (std::uint32_t m = 0; m < size_; ++m) masks[m] = cloth_.masks[particles_[m]];
            side.masks = std::span(masks).first(size_);
        }
        const BlockPaths paths = place({}, points, 0, points, near.points);
        if (!find_nearest_of(colliders_, side, h_, reach, {}, paths, size_, Told::friction, near, {},
                             &colliders_[number]))
            near.surfaces.w.fill(reach);
    }

    std::span<const ColliderMotion> colliders_;
    const ClothSide& cloth_;
    float h_;
    CollidingBlock& block_;
    std::array<std::uint32_t, block_size> waiting_, particles_;
    std::uint32_t size_ = 0;  // number of `particles_` in use
};

MetParticles collide_block(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                           const CollidingParticles& particles) {
    const std::span<const Vec4> starts = particles.starts;
    LeftInside left;
    CollidingBlock block{.positions = particles.positions,
                         .velocities = particles.velocities,
                         .held = particles.held,
                         .starts = starts,
                         .paths = paths_of(starts, particles.positions),
                         .cloth = &cloth,
                         .left = &left};
    for (std::uint32_t number = 0; number < colliders.size(); ++number) {
        const ColliderMotion& motion = colliders[number];
        block.collider = number;
        const auto meet = [&](const auto& shape, const Meeting& meeting, const ClothSide& side) {
            block.cloth = &side;
            collide(shape,
                    {.thickness = thickness_of(motion, cloth),
                     .friction = motion.end.friction,
                     .h = h,
                     .restitution = restitution_of(motion, cloth),
                     .least_bounce = cloth.least_bounce,
                     .found = found_depth(motion),
                     .meeting = starts.empty() ? Meeting{} : meeting},
                    block);
        };
        if_near(motion, h, cloth, 0, block.paths, meet);
    }
    bool left_deep = false;
    if (block.has_left) {
        Emerging(colliders, cloth, h, block).all();
        left_deep = std::ranges::any_of(left.surfaces.w, [&](float depth) { return depth > particles.deep; });
    }
    return {std::accumulate(block.met.begin(), block.met.end(), 0u), left_deep};
}

/// The particles of a block.
CollidingParticles part_of(const CollidingParticles& all, const BlockRange& range) {
    const std::uint32_t size = range.end - range.begin;
    const auto of_block = [&](auto span) { return span.empty() ? span : span.subspan(range.begin, size); };
    return {.positions = of_block(all.positions),
            .velocities = of_block(all.velocities),
            .starts = of_block(all.starts),
            .held = of_block(all.held),
            .deep = all.deep};
}

}  // namespace

MetParticles collide_particles(Parallel& parallel, std::span<const ColliderMotion> colliders,
                               const ClothSide& cloth, float h, const CollidingParticles& particles,
                               std::span<std::uint32_t> block_partials) {
    std::atomic<bool> left_deep{false};
    const auto block = [&](const BlockRange& range) {
        const MetParticles met = collide_block(colliders, cloth.part(range.begin, range.end - range.begin), h,
                                               part_of(particles, range));
        if (met.left_deep) left_deep.store(true, std::memory_order_relaxed);
        return met.count;
    };
    const std::uint32_t count = parallel.reduce(static_cast<std::uint32_t>(particles.positions.size()),
                                                block_partials, 0u, block, std::plus<>{});
    return {count, left_deep};
}

std::uint32_t parts_to_meet(Parallel& parallel, std::span<const ColliderMotion> colliders,
                            const ClothSide& cloth, float h, std::uint32_t most,
                            std::span<const Vec4> positions, std::span<const Vec4> velocities,
                            std::span<std::uint32_t> block_partials) {
    const auto sweep_of = [&](const ColliderMotion& motion) {
        return with_shapes(motion, [&](const auto& start, const auto& end) {
            return sweeping(start, end, {h, motion.fastest}, thickness_of(motion, cloth));
        });
    };
    const auto count = static_cast<std::uint32_t>(positions.size());
    const auto greater = [](std::uint32_t a, std::uint32_t b) { return std::max(a, b); };
    // The bits of floats that are not negative are in the floats' order.
    const auto fastest_bits = [&](const BlockRange& range) {
        float fastest = 0;
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            fastest = std::max(fastest, xyz(velocities[i]).squaredNorm());
        return std::bit_cast<std::uint32_t>(fastest);
    };
    const float farthest =
        h *
        std::sqrt(std::bit_cast<float>(parallel.reduce(count, block_partials, 0u, fastest_bits, greater)));
    // A collider counts that moves, or that cloth goes past by several times its width; cloth that flaps
    // round a pole is slower.
    const auto is_fast = [&](const Sweeping& sweep) {
        return sweep.way > sweep.thin_as_a_whole ||
               (sweep.way >= 0 && sweep.way + farthest > 8 * sweep.thin_as_a_whole);
    };
    if (std::ranges::none_of(colliders, is_fast, sweep_of)) return 1;
    const auto parts_for = [&](const BlockRange& range, const Sweeping& fast) {
        float longest = 0;
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            if (positions[i].w > 0)
                longest = std::max(longest, (h * xyz(velocities[i]) - fast.travel).squaredNorm());
        const float wanted = std::ceil(std::sqrt(longest) / (2 * fast.thin_as_a_whole));
        return wanted < static_cast<float>(most) ? std::max(static_cast<std::uint32_t>(wanted), 1u) : most;
    };
    const auto block = [&](const BlockRange& range) {
        const std::uint32_t size = range.end - range.begin;
        const std::span<const Vec4> starts = positions.subspan(range.begin, size);
        const ClothSide side = cloth.part(range.begin, size);
        NearSurfaces near;
        const BlockPaths paths = place(starts, starts, h, velocities.subspan(range.begin, size), near.points);
        std::uint32_t parts = 1;
        for (const ColliderMotion& motion : colliders) {
            if (!may_be_near(motion, cloth.most_thickness, paths)) continue;
            const Sweeping sweep = sweep_of(motion);
            if (is_fast(sweep) &&
                find_nearest_of({&motion, 1}, side, h, 0, starts, paths, size, Told::friction, near))
                parts = std::max(parts, parts_for(range, sweep));
        }
        return parts;
    };
    return parallel.reduce(count, block_partials, 1u, block, greater);
}

bool find_near_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                        float reach, std::span<const Vec4> starts, std::span<const Vec4> positions,
                        float gamma, std::span<const Vec4> velocities, NearSurfaces& near,
                        std::span<std::int32_t> bodies) {
    const BlockPaths paths = place(starts, positions, gamma, velocities, near.points);
    return find_nearest_of(colliders, cloth, h, reach, starts, paths,
                           static_cast<std::uint32_t>(positions.size()), Told::friction, near, bodies);
}

bool find_bouncing_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                            float reach, std::span<const Vec4> positions, float gamma,
                            std::span<const Vec4> velocities, NearSurfaces& near) {
    const BlockPaths paths = place({}, positions, gamma, velocities, near.points);
    return find_nearest_of(colliders, cloth, h, reach, {}, paths,
                           static_cast<std::uint32_t>(positions.size()), Told::restitution, near);
}

}  // namespace weft
