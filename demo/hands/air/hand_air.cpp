#include "demo/hands/air/hand_air.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "demo/hands/held_collider.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float fan_radius = 0.22f;                         // [m]
constexpr float blast_radius = 0.45f, blast_lasts = 0.12f;  // [m]; time of decay to 1/e [s]
constexpr float weakest_blast = 0.3f;                       // [m/s]
constexpr float slowest_wake = 0.7f;                        // slower things leave none [m/s]
constexpr float fastest_wake = 100;                         // faster motion is a jump [m/s]

struct Round {
    Vec3 middle;
    float radius;
};

/// The ball that stands for a collider in its wake; none for other shapes.
std::optional<Round> round_of(const Collider& collider) {
    if (const auto* sphere = std::get_if<Sphere>(&collider.shape))
        return Round{sphere->center, sphere->radius};
    if (const auto* box = std::get_if<Box>(&collider.shape))
        return Round{box->center, std::max({box->half_extents.x, box->half_extents.y, box->half_extents.z})};
    const auto middle_of = [](const auto& rod) {
        return to_vec3(0.5f * (to_vector(rod.a) + to_vector(rod.b)));
    };
    if (const auto* capsule = std::get_if<Capsule>(&collider.shape))
        return Round{middle_of(*capsule), capsule->radius};
    if (const auto* limb = std::get_if<TaperedCapsule>(&collider.shape))
        return Round{middle_of(*limb), 0.5f * (limb->radius_a + limb->radius_b)};
    return std::nullopt;
}

bool is_wake(const Vector3& velocity) {
    const float speed = velocity.norm();
    return speed > slowest_wake && speed < fastest_wake;
}

}  // namespace

void HandAir::hold_fan(const render::Ray& ray) {
    fan_ = {.kind = AirSourceKind::jet,
            .position = ray.origin,
            .velocity = to_vec3(fan_speed * to_vector(ray.direction)),
            .radius = fan_radius};
}

void HandAir::blast_at(const Vec3& place) {
    blast_ = {.kind = AirSourceKind::blast,
              .position = place,
              .velocity = {blast_speed, 0, 0},
              .radius = blast_radius};
}

void HandAir::add_wakes(const World& world, std::span<const ColliderId> moving, std::span<const BodyId> balls,
                        float dt, std::vector<AirSource>& air) {
    const std::vector<Seen> before = std::exchange(seen_, {});
    const auto leave = [&](const Round& round, const Vector3& velocity) {
        if (is_wake(velocity))
            air.push_back({AirSourceKind::wake, round.middle, to_vec3(velocity), round.radius});
    };
    for (const ColliderId id : moving) {
        const auto collider = world.collider(id);
        const auto round = collider ? round_of(*collider) : std::nullopt;
        if (!round) continue;
        seen_.push_back({id, round->middle});
        const auto last = std::ranges::find(before, id, &Seen::id);
        if (last != before.end()) leave(*round, (to_vector(round->middle) - to_vector(last->middle)) / dt);
    }
    for (const BodyId body : balls) {
        const auto state = world.body_state(body);
        if (state && state->position.y > -1)
            leave({state->position, Balls::radius}, to_vector(state->velocity));
    }
}

void HandAir::before_step(World& world, std::span<const ColliderId> moving, std::span<const BodyId> balls,
                          float dt) {
    std::vector<AirSource> air;
    if (fan_.kind != AirSourceKind::none) air.push_back(fan_);
    if (blast_.kind != AirSourceKind::none) air.push_back(blast_);
    if (wakes) add_wakes(world, moving, balls, dt, air);
    blast_.velocity.x *= std::exp(-dt / blast_lasts);
    if (blast_.velocity.x < weakest_blast) blast_ = {};

    if (air.empty() && !blew_) return;
    blew_ = !air.empty();
    WorldSettings settings = world.settings();
    settings.wind.sources.fill({});
    const std::size_t most = std::min(air.size(), settings.wind.sources.size());
    std::copy_n(air.begin(), most, settings.wind.sources.begin());
    (void)world.set_settings(settings);  // a source's values are in their ranges
}

void HandAir::forget() {
    fan_ = blast_ = {};
    seen_.clear();
    blew_ = true;  // the next step clears the World's sources
}

}  // namespace weft::demo
