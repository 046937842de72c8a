// The choice of the cloths that a step takes: those that are enabled and awake. Cloth that has been still for
// a while sleeps with all that it touches, until something near it moves, or the host changes forces on it.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

#include "cloth/stages/forces/seam_step.h"
#include "cloth/stages/step_bodies.h"
#include "cloth/step/sleep.h"
#include "collision/shapes/moving_shapes.h"
#include "engine/bounds.h"

namespace weft {

namespace {

/// How long a cloth has to be still before it sleeps [s].
constexpr float time_to_sleep = 0.5f;
/// Distance, beyond the thickness, within which a collider that changes wakes a sleeping cloth [m].
constexpr float wakes_within = 1e-3f;

Bounds box_of(const Cloth& cloth) {
    return {cloth.extent.lower, cloth.extent.upper};
}

/// Where features of the cloth may meet others in a step; empty without features.
Bounds reach_of(const Cloth& cloth, const Vector3& gravity, float dt) {
    if (!cloth.has_features()) return {{1, 1, 1}, {-1, -1, -1}};
    const float way = (std::sqrt(cloth.extent.peak_speed_squared) + gravity.norm() * dt) * dt;
    return grown(box_of(cloth), cloth.as_body().radius + way);
}

/// Greatest displacement of a particle in the step [m].
float farthest_way(const ClothState& state) {
    const auto now = std::as_const(state.positions).span(),
               before = std::as_const(state.previous_positions).span();
    float squared = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
        squared = std::max(squared, (xyz(now[i]) - xyz(before[i])).squaredNorm());
    return std::sqrt(squared);
}

/// Returns the speed of the mean of all velocities [m/s], which is great where cloth slides, swings or
/// drifts, and small where it trembles.
float mean_speed(const ClothState& state) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Vec4& v : std::as_const(state.velocities).span()) sum += xyz(v).cast<double>();
    return static_cast<float>(sum.norm() / static_cast<double>(state.size()));
}

/// Particles whose speeds are taken together: one that trembles alone hardly counts.
constexpr std::size_t group_size = 16;

/// Returns the greatest speed of a group of particles that follow one another, rms [m/s].
float peak_speed_of_groups(const ClothState& state) {
    const std::span<const Vec4> velocities = std::as_const(state.velocities).span();
    float most = 0;
    for (std::size_t first = 0; first < velocities.size(); first += group_size) {
        const std::span group = velocities.subspan(first, std::min(group_size, velocities.size() - first));
        float sum = 0;
        for (const Vec4& v : group) sum += xyz(v).squaredNorm();
        most = std::max(most, sum / static_cast<float>(group.size()));
    }
    return std::sqrt(most);
}

/// Whether the collider may meet a cloth during its motion; its layers are those at the end.
bool is_near(const ColliderMotion& motion, const Cloth& cloth, float dt, float max_speed) {
    const Collider& collider = motion.end;
    if (collider.is_trigger || (collider.layers & cloth.settings.collider_mask) == 0) return false;
    return with_shapes(motion, [&](const auto& start, const auto& end) {
        return may_meet(start, end, Pace{dt, max_speed},
                        Reach{cloth.settings.thickness + collider.thickness, wakes_within},
                        BlockPaths{box_of(cloth), 0})
            .has_value();
    });
}

bool is_near(const Collider& collider, const HeldShape* held, const Cloth& cloth) {
    ColliderMotion motion{collider, collider, 0};
    motion.held = held;
    return is_near(motion, cloth, 1, 0);
}

bool have_same_shape(const Collider& a, const Collider& b) {
    const auto is_same = [&]<class Shape>(const Shape& of_b) {
        static_assert(std::is_trivially_copyable_v<Shape>);
        const auto* const of_a = std::get_if<Shape>(&a.shape);
        return of_a != nullptr && std::memcmp(&of_b, of_a, sizeof of_b) == 0;
    };
    return std::visit(is_same, b.shape);
}

/// Whether two colliders differ, for cloth at rest, in shape alone.
bool have_same_surface(const Collider& a, const Collider& b) {
    return a.friction == b.friction && a.thickness == b.thickness && a.restitution == b.restitution &&
           a.layers == b.layers && a.is_trigger == b.is_trigger;
}

/// Box around the vertices of a deforming shape's instance, as they are before they move.
Box box_before(const PlacedShape& placed, const HeldShape& held) {
    const HeldShape::Deformation deformation = held.deformation();
    Eigen::AlignedBox3f box;
    for (std::size_t v = 0; v < deformation.vertices.size(); ++v)
        box.extend(to_vector(deformation.vertices[v]) - to_vector(deformation.displacements[v]));
    const Vector3 centre = to_vector(placed.position) + unit(placed.rotation) * box.center();
    return {to_vec3(centre), placed.rotation, to_vec3(0.5f * box.diagonal())};
}

bool is_moved_by_host(const Cloth& cloth) {
    const ClothState& state = cloth.state;
    const auto moves = [&](const Pin& pin) { return pin.target != xyz(state.positions[pin.particle]); };
    if (std::ranges::any_of(state.pins, moves)) return true;
    if (state.frame && std::memcmp(&state.frame->pose, &state.frame->target, sizeof(Transform)) != 0)
        return true;
    return !state.skin.is_still();
}

/// Wakes cloths that are disturbed; where the air is gusty, all that may sleep.
void wake_disturbed(Simulation& world, bool is_gusty) {
    for (Cloth* cloth : world.present)
        if (cloth->state.rest && (is_gusty || cloth->is_disturbed)) cloth->wake();
}

/// Marks disturbed cloths among those that are still or take long steps: the host moves them in this step, or
/// they are near a body, or near a collider that changes in this step.
void find_disturbed(Simulation& world, float dt) {
    const auto for_all = [&](const auto& disturbed) {
        for (Cloth* cloth : world.present)
            if (cloth->still_for() > 0 || cloth->state.detail)
                cloth->is_disturbed = cloth->is_disturbed || disturbed(*cloth);
    };
    for (Cloth* cloth : world.present) cloth->is_disturbed = false;
    for_all(is_moved_by_host);
    if (world.body_stage) for_all([&](const Cloth& cloth) { return is_near_bodies(world, cloth, dt); });
    world.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        const HeldShape* const held = world.held_by(slot.target);
        const bool deforms = held != nullptr && held->deforms_in(world.state.steps);
        if (!deforms && have_same_shape(slot.current, slot.target) &&
            have_same_surface(slot.current, slot.target))
            return;
        // Cloth at the collider's old place loses its support, which had the old surface.
        for_all([&](const Cloth& cloth) { return is_near(slot.current, held, cloth); });
        Collider before = slot.current;
        if (deforms) {
            before.shape = box_before(*std::get_if<PlacedShape>(&slot.current.shape), *held);
            for_all([&](const Cloth& cloth) { return is_near(before, nullptr, cloth); });
        }
        ColliderMotion motion{slot.current, slot.target, world.settings.max_speed};
        motion.held = held;
        for_all([&](const Cloth& cloth) { return is_near(motion, cloth, dt, world.settings.max_speed); });
    });
}

// Cloths that may touch, or are joined, sleep together and wake together, so that none lies on what only
// seems to be still.
void sleep_and_wake(Simulation& world, float dt) {
    world.boxes.clear();
    for (const Cloth* cloth : world.present)
        world.boxes.push_back(reach_of(*cloth, world.gravity_on(*cloth), dt));
    world.group_finder.find(world.boxes, [&](std::uint32_t i, std::uint32_t j) {
        return may_meet(*world.present[i], *world.present[j]);
    });
    join_seams(world);
    const std::span<const std::uint32_t> first_of = world.group_finder.first_of();
    world.still_for.assign(world.present.size(), std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < world.present.size(); ++i) {
        float& least = world.still_for[first_of[i]];
        least = std::min(least, world.present[i]->still_for());
    }
    for (std::size_t i = 0; i < world.present.size(); ++i) {
        Cloth& cloth = *world.present[i];
        const bool is_to_sleep = world.still_for[first_of[i]] >= time_to_sleep;
        if (is_to_sleep && !cloth.is_asleep()) cloth.fall_asleep();
        if (!is_to_sleep && cloth.is_asleep()) cloth.wake();
    }
}

}  // namespace

void choose_present(Simulation& world, float dt) {
    world.present.clear();
    bool any_is_still = false;
    world.cloths.for_each([&](ClothId id, std::unique_ptr<Cloth>& cloth) {
        cloth->id = id;
        if (!cloth->settings.enabled) return;
        world.present.push_back(cloth.get());
        any_is_still |= cloth->still_for() > 0 || cloth->is_asleep();
    });
    const bool is_gusty = world.air_is_on() && world.settings.wind.gust > 0 &&
                          !to_vector(world.settings.wind.velocity).isZero(0);
    if ((any_is_still && !is_gusty) || world.settings.budget > 0) find_disturbed(world, dt);
    if (!any_is_still) return;
    wake_disturbed(world, is_gusty);
    sleep_and_wake(world, dt);
    const auto sleeping = std::erase_if(world.present, [](const Cloth* cloth) { return cloth->is_asleep(); });
    world.report.sleeping_cloths = static_cast<std::uint32_t>(sleeping);
}

void count_still_time(Cloth& cloth, float dt) {
    if (!cloth.state.rest) return;
    const float limit = cloth.settings.sleep_speed;
    float& still_for = cloth.state.rest->still_for;
    // The mean's part of the limit is small, so that cloth that begins to slide stays awake.
    constexpr float as_a_whole = 0.25f;
    // A particle faster than this puts its group above the limit by itself, and the sums are spared.
    const float most_squared = static_cast<float>(group_size) * limit * limit;
    const bool is_still =
        !cloth.restored && !cloth.meets_bodies && cloth.extent.peak_speed_squared < most_squared &&
        peak_speed_of_groups(cloth.state) < limit && mean_speed(cloth.state) < as_a_whole * limit;
    still_for = is_still ? still_for + dt : 0.0f;
    // Particles that are pushed out of a collider move without a velocity.
    if (still_for >= time_to_sleep && cloth.collider_contacts > 0 && farthest_way(cloth.state) > limit * dt)
        still_for = 0;
}

void Simulation::wake_all() noexcept {
    cloths.for_each([](ClothId, std::unique_ptr<Cloth>& cloth) { cloth->wake(); });
}

void Simulation::wake_near(const Collider& collider) noexcept {
    const HeldShape* const held = held_by(collider);
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        if (cloth->state.rest && is_near(collider, held, *cloth)) cloth->wake();
    });
}

void Simulation::wake_near(const Cloth& gone) noexcept {
    mark_near(gone);
    wake_marked();
}

void Simulation::mark_near(const Cloth& changing) noexcept {
    const Bounds bounds = reach_of(changing, Vector3::Zero(), 0);
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        cloth->is_disturbed = cloth.get() != &changing && changing.has_features() && cloth->has_features() &&
                              may_meet(changing, *cloth) &&
                              overlap(bounds, reach_of(*cloth, Vector3::Zero(), 0));
    });
}

void Simulation::wake_marked() noexcept {
    cloths.for_each([](ClothId, std::unique_ptr<Cloth>& cloth) {
        if (cloth->is_disturbed) cloth->wake();
    });
}

bool Cloth::is_asleep() const noexcept {
    return state.rest && state.rest->asleep != 0;
}

float Cloth::still_for() const noexcept {
    return state.rest ? state.rest->still_for : 0.0f;
}

void Cloth::wake() noexcept {
    if (state.rest) *state.rest = {};
}

void Cloth::set_enabled(bool on) noexcept {
    if (on == settings.enabled) return;
    settings.enabled = on;
    wake();
    if (!on) stand_still();
    // Meanwhile other cloth may have passed through it, and its frame and skin may have moved.
    if (has_features()) state.may_cross = 1;
    if (state.frame) *state.frame = {.pose = state.frame->target, .target = state.frame->target};
    state.skin.stand_still();
}

// A sleeping cloth stays where it is drawn, and wakes at rest.
void Cloth::fall_asleep() noexcept {
    state.rest->asleep = 1;
    stand_still();
}

void Cloth::stand_still() noexcept {
    std::ranges::copy(std::as_const(state.positions).span(), state.previous_positions.data());
    std::ranges::fill(state.velocities.span(), Vec4{});
    state.record.h = 0;
    land();
    extent.peak_speed_squared = 0;
}

}  // namespace weft
