#include "cloth/limits/worn_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
// Leashes shorter than this let nothing slide [m].
constexpr float holds_fast = 1e-3f;
constexpr float sticks = 1e6f;      // friction of such leashes
constexpr float beyond_all = 1e6f;  // limits from here on count as none [m]
// Lags up to this may be rounding [m].
constexpr float least_lag = 1e-6f;

Vector3 across(const Vector3& n) {
    return n.unitOrthogonal();
}

}  // namespace

/// One particle's limits at the substep's end. Positions y are relative to its place.
struct WornLimits::Bounds {
    Vector3 place, velocity;                                      // [m], [m/s]
    Vector3 normal = Vector3::Zero(), turning = Vector3::Zero();  // the normal, and its rate of change [1/s]
    float leash, offset, radius;                                  // [m]

    /// Signed distance from the backstop's surface, positive outside [m].
    [[nodiscard]] float gap(const Vector3& y) const {
        if (radius == infinity) return normal.dot(y) + offset;
        const float depth = offset + radius, squared = y.squaredNorm();
        const float power = squared + 2 * depth * normal.dot(y) + offset * (offset + 2 * radius);
        return power / ((y + depth * normal).norm() + radius);
    }
    [[nodiscard]] Vector3 outwards(const Vector3& y) const {
        if (radius == infinity) return normal;
        const Vector3 from_middle = y + (offset + radius) * normal;
        const float length = from_middle.norm();
        return length > 0 ? Vector3(from_middle / length) : normal;
    }
    [[nodiscard]] bool is_beyond(const Vector3& y) const { return y.squaredNorm() > leash * leash; }
    [[nodiscard]] bool is_behind(const Vector3& y) const { return offset < infinity && gap(y) < 0; }

    /// The point where leash and backstop intersect, on the side of y.
    [[nodiscard]] Vector3 edge(const Vector3& y) const {
        const float along = radius == infinity
                                ? -offset
                                : -(offset * (offset + 2 * radius) + leash * leash) / (2 * (offset + radius));
        const float a = std::clamp(along, -leash, leash);
        const Vector3 aside = y - normal.dot(y) * normal;
        const float length = aside.norm();
        const Vector3 e = length > 0 ? Vector3(aside / length) : across(normal);
        return a * normal + std::sqrt(std::max(leash * leash - a * a, 0.0f)) * e;
    }

    struct Held {
        Vector3 y;
        bool by_leash = false, by_backstop = false;
    };
    [[nodiscard]] Held hold(const Vector3& y) const {
        const bool beyond = is_beyond(y), behind = is_behind(y);
        if (!beyond && !behind) return {y};
        if (beyond) {
            const Vector3 at_leash = y * (leash / y.norm());
            if (!is_behind(at_leash)) return {at_leash, true, false};
        }
        if (behind) {
            const Vector3 at_backstop = y - gap(y) * outwards(y);
            if (!is_beyond(at_backstop)) return {at_backstop, false, true};
        }
        return {edge(y), true, true};
    }

    /// The velocity that a held particle keeps of v: it neither leaves the leash nor enters the backstop.
    [[nodiscard]] Vector3 slide(const Held& held, const Vector3& v) const {
        const float length = held.y.norm();
        const Vector3 e = length > 0 ? Vector3(held.y / length) : Vector3::Zero();
        const Vector3 m = outwards(held.y);
        const float surface = radius == infinity
                                  ? -turning.dot(held.y)
                                  : -(offset + radius) * turning.dot(m);  // its speed along m, by turning
        Vector3 relative = v - velocity;
        if (held.by_leash && length == 0) return velocity;
        const auto leaves = [&] { return held.by_leash ? std::max(e.dot(relative), 0.0f) : 0.0f; };
        const auto enters = [&] {
            return held.by_backstop ? std::min(m.dot(relative) - surface, 0.0f) : 0.0f;
        };
        relative -= leaves() * e;
        relative -= enters() * m;
        if (leaves() > 0) {  // both limits bind: only motion along their edge is left
            const Vector3 edge = e.cross(m);
            const float squared = edge.squaredNorm();
            relative = squared > 0 ? Vector3(edge * (edge.dot(relative) / squared)) : Vector3::Zero();
        }
        return velocity + relative;
    }
};

void WornLimits::reserve(std::uint32_t particles) {
    if (!has_limits()) {
        by_limit_ = {};
        partials_ = {};
        return;
    }
    if (by_limit_.size() > 0) return;
    AlignedBuffer<std::uint8_t> by_limit(particles);
    partials_ = AlignedBuffer<LimitLag>(block_count(particles));
    by_limit_ = std::move(by_limit);
}

void WornLimits::begin(const SkinState& skin, float end, float dt) noexcept {
    is_known_ = skin.known != 0;
    places_ = skin.places.span();
    targets_ = skin.target_places.span();
    normals_ = skin.normals.span();
    target_normals_ = skin.target_normals.span();
    end_ = end;
    per_second_ = 1 / dt;
}

WornLimits::Bounds WornLimits::bounds_of(std::uint32_t i) const noexcept {
    const Vector3 from = xyz(places_[i]), to = xyz(targets_[i]);
    // Values from beyond_all on count as infinite.
    const auto far_is_none = [](const AlignedBuffer<float>& values, std::uint32_t k) {
        return values.size() > 0 && values[k] < beyond_all ? values[k] : infinity;
    };
    Bounds bounds{.place = end_ < 1 ? Vector3(from + end_ * (to - from)) : to,
                  .velocity = per_second_ * (to - from),
                  .leash = far_is_none(leash, i),
                  .offset = far_is_none(backstop, i),
                  .radius = far_is_none(backstop_radius, i)};
    if (bounds.offset == infinity) return bounds;
    const Vector3 n0 = xyz(normals_[i]), n1 = xyz(target_normals_[i]);
    bounds.normal = end_ < 1 ? Vector3((n0 + end_ * (n1 - n0)).normalized()) : n1;
    bounds.turning = per_second_ * (n1 - n0);
    return bounds;
}

bool WornLimits::adjust(const BlockRange& range, float reach, bool found, NearSurfaces& near) noexcept {
    const std::uint32_t size = range.end - range.begin;
    if (!is_known_) return found;
    if (!found) {
        for (BlockLanes* lanes : {&near.surfaces, &near.motions})
            for (auto* component : {&lanes->x, &lanes->y, &lanes->z, &lanes->w}) component->fill(0);
        near.surfaces.w.fill(reach);
    }
    const auto take = [&](std::uint32_t k, float gap, const Vector3& out, const Vector3& velocity,
                          float rubs) {
        if (!(gap < near.surfaces.w[k])) return;
        by_limit_[range.begin + k] = 1;
        found = true;
        near.surfaces.x[k] = out.x();
        near.surfaces.y[k] = out.y();
        near.surfaces.z[k] = out.z();
        near.surfaces.w[k] = gap;
        near.motions.x[k] = velocity.x();
        near.motions.y[k] = velocity.y();
        near.motions.z[k] = velocity.z();
        near.motions.w[k] = rubs;
    };
    for (std::uint32_t k = 0; k < size; ++k) {
        by_limit_[range.begin + k] = 0;
        if (!(near.points.w[k] > 0)) continue;
        const Bounds bounds = bounds_of(range.begin + k);
        const Vector3 y = Vector3(near.points.x[k], near.points.y[k], near.points.z[k]) - bounds.place;
        if (bounds.offset < infinity) take(k, bounds.gap(y), bounds.outwards(y), bounds.velocity, 0);
        if (bounds.leash == infinity) continue;
        const float length = y.norm();
        const Vector3 inwards = length > 0 ? Vector3(-y / length) : Vector3::UnitY();
        take(k, bounds.leash - length, inwards, bounds.velocity, bounds.leash < holds_fast ? sticks : 0);
    }
    return found;
}

void WornLimits::hold(Parallel& parallel, std::span<Vec4> positions, std::span<Vec4> velocities) const {
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            if (positions[i].w == 0) continue;
            const Bounds bounds = bounds_of(i);
            const Bounds::Held held = bounds.hold(xyz(positions[i]) - bounds.place);
            if (!held.by_leash && !held.by_backstop) continue;
            set_xyz(positions[i], bounds.place + held.y);
            set_xyz(velocities[i], bounds.slide(held, xyz(velocities[i])));
        }
    });
}

LimitLag WornLimits::lag(Parallel& parallel, std::span<const Vec4> positions) noexcept {
    const auto find_block = [&](const BlockRange& range) {
        LimitLag lag;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            if (positions[i].w == 0) continue;
            const Bounds bounds = bounds_of(i);
            const Vector3 y = xyz(positions[i]) - bounds.place;
            const float beyond =
                std::max(y.norm() - bounds.leash, bounds.offset < infinity ? -bounds.gap(y) : 0);
            if (!(beyond > least_lag)) continue;
            ++lag.particles;
            lag.most = std::max(lag.most, beyond);
        }
        return lag;
    };
    return parallel.reduce(static_cast<std::uint32_t>(positions.size()), partials_.span(), LimitLag{},
                           find_block, [](const LimitLag& a, const LimitLag& b) {
                               return LimitLag{a.particles + b.particles, std::max(a.most, b.most)};
                           });
}

}  // namespace weft
