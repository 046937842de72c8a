// Reports of contacts, for hosts that ask for them. Reports read the results of a step, and change none.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cloth/solver/passes/multilevel.h"
#include "cloth/stages/report_contacts.h"
#include "cloth/stages/worn_step.h"
#include "collision/colliders/nearest_surface.h"

namespace weft {

namespace {

Vec3 opposite(const Vec3& v) {
    return {-v.x, -v.y, -v.z};
}

/// The same contact with its two cloths exchanged.
Contact seen_from_other(const Contact& c) {
    return {.cloth = c.other_cloth,
            .other_cloth = c.cloth,
            .particle = c.other_particle,
            .other_particle = c.particle,
            .point = c.point,
            .normal = opposite(c.normal),
            .impulse = opposite(c.impulse)};
}

/// The corner of the side [begin, end) with the greatest weight.
std::uint32_t main_corner(const PairRows::Push& push, std::uint32_t begin, std::uint32_t end) {
    std::uint32_t most = begin;
    for (std::uint32_t c = begin + 1; c < end; ++c)
        if (std::abs(push.pair.weights[c]) > std::abs(push.pair.weights[most])) most = c;
    return push.pair.corners[most];
}

// A contact's order in the World is its cloth's index, then its number within the cloth.
void log_contact(ContactLog& log, Cloth& cloth, const Contact& contact) {
    const float strength = to_vector(contact.impulse).norm();
    if (!std::isfinite(strength)) return;
    const std::uint64_t order = std::uint64_t{cloth.id.index} << 32 | cloth.contact_count++;
    if (log.wants(strength)) log.add({contact, strength, order});
}

void add_impulse(Cloth& cloth, std::uint32_t particle, const Vector3& impulse) {
    Vec4& sum = cloth.collider_impulses[particle];
    set_xyz(sum, xyz(sum) + impulse);
}

// Colliders and pairs are credited in turn: each takes of the impulse what the others have left.
void share_out_impulses(FeatureContact& space, std::span<Cloth* const> cloths) {
    constexpr int sweeps = 16;
    space.rows().begin_sweeps();
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (std::size_t k = 0; k < cloths.size(); ++k) {
            Cloth& cloth = *cloths[k];
            if (!cloth.contacts || cloth.impulse_ratio == 0) continue;
            for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
                if (!cloth.contacts->presses_collider(i)) continue;
                Vec4& left = cloth.missing_impulses[i];
                const Vector3 n = xyz(cloth.state.held.normals[i]);
                const float more = std::max(n.dot(xyz(left)), -left.w);
                left = to_vec4(xyz(left) - more * n, left.w + more);
            }
        }
        space.rows().sweep([&](std::uint32_t corner) -> Vec4& {
            std::size_t k = cloths.size() - 1;
            while (space.first(k) > corner) --k;
            return cloths[k]->missing_impulses[corner - space.first(k)];
        });
    }
}

void log_colliders(Simulation& world, Cloth& cloth) {
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vec4 impulse = std::exchange(cloth.collider_impulses[i], Vec4{});
        if (impulse.w == 0) continue;
        const ColliderId id = world.collider_ids[static_cast<std::uint32_t>(impulse.w) - 1];
        const Collider& collider = world.state.colliders.find(id)->target;
        const SurfacePoint surface =
            nearest_surface(collider, xyz(cloth.state.positions[i]), world.held_by(collider));
        log_contact(world.contact_reports.of_thread(0), cloth,
                    {.cloth = cloth.id,
                     .collider = id,
                     .particle = i,
                     .point = to_vec3(surface.point),
                     .normal = to_vec3(surface.normal),
                     .impulse = to_vec3(xyz(impulse))});
    }
}

/// Reports the cloth's deepest particle in a trigger, at the end of the step.
void log_trigger(Simulation& world, Cloth& cloth, ColliderId id, const Collider& trigger) {
    const ColliderMotion there{.start = trigger, .end = trigger, .held = world.held_by(trigger)};
    const ClothSide side = cloth.side();
    const std::span<const Vec4> positions = std::as_const(cloth.state.positions).span();
    const auto deepest_of_block = [&](const BlockRange& range) {
        DeepestInTrigger deepest;
        const std::uint32_t size = range.end - range.begin;
        const std::span<const Vec4> points = positions.subspan(range.begin, size);
        NearSurfaces near;
        if (!find_near_surfaces({&there, 1}, side.part(range.begin, size), 1, 0, {}, points, 0, points, near))
            return deepest;
        for (std::uint32_t k = 0; k < size; ++k)
            if (near.surfaces.w[k] < std::min(deepest.gap, 0.0f))
                deepest = {near.surfaces.w[k], range.begin + k};
        return deepest;
    };
    const auto deeper = [](const DeepestInTrigger& a, const DeepestInTrigger& b) {
        return b.gap < a.gap ? b : a;
    };
    const DeepestInTrigger found = world.parallel.reduce(cloth.state.size(), cloth.in_triggers.span(),
                                                         DeepestInTrigger{}, deepest_of_block, deeper);
    if (!(found.gap < 0)) return;
    const SurfacePoint surface =
        nearest_surface(trigger, xyz(cloth.state.positions[found.particle]), world.held_by(trigger));
    log_contact(world.contact_reports.of_thread(0), cloth,
                {.cloth = cloth.id,
                 .collider = id,
                 .particle = found.particle,
                 .point = to_vec3(surface.point),
                 .normal = to_vec3(surface.normal)});
}

void log_triggers(Simulation& world, Cloth& cloth) {
    world.state.colliders.for_each([&](ColliderId id, const ColliderSlot& slot) {
        const Collider& trigger = slot.target;
        if (!trigger.is_trigger || (trigger.layers & cloth.settings.collider_mask) == 0) return;
        log_trigger(world, cloth, id, trigger);
    });
}

}  // namespace

// In the equation contact acts over gamma and gives J = gamma F; the base adds what it kept of the last
// step's change. Over the step h the force gives (h / gamma) J: at rest, and across the normal. Along the
// normal History's base has no last change where a collider holds, and an impact would count 3/2 times. There
// the impulse is the one that brings the momentum from v to the solved one, against all other forces over h.
void add_impulses_of_equation(Worker& worker, Cloth& cloth, const StepEquation& equation) {
    if (!cloth.contacts || colliders_of(worker, cloth).empty()) return;
    const float ratio = equation.h / equation.gamma;
    worker.parallel.ranges(cloth.state.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const float w = equation.positions[i].w;
            if (!(w > 0) || !cloth.contacts->presses_collider(i)) continue;
            const Vector3 v = xyz(cloth.scratch_velocities[i]), n = xyz(cloth.state.held.normals[i]);
            const Vector3 base = xyz(equation.base_velocities[i]);
            const Vector3 missing = base - xyz(equation.velocities[i]) - (ratio - 1) * (v - base);
            Vector3 given = cloth.contacts->of_colliders(i, v);
            if (equation.pairs != nullptr) given -= n.dot(given) * n;  // credited later
            add_impulse(cloth, i, ratio * given + n.dot(missing) / w * n);
        }
    });
}

/// Adds the impulses that changed velocities since `before`, after the equation.
void add_impulses_of_change(Worker& worker, Cloth& cloth, std::span<const Vec4> before) {
    worker.parallel.ranges(cloth.state.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vector3 change = xyz(cloth.state.velocities[i]) - xyz(before[i]);
            const float w = cloth.state.positions[i].w;
            if (w > 0 && !change.isZero(0)) add_impulse(cloth, i, change / w);
        }
    });
}

void find_missing_impulses(const SolverStep& step, Cloth& cloth) {
    const std::span<const Vec4> left = static_cast<MultilevelSolver&>(*cloth.solver).left_to_contact(step);
    step.parallel.ranges(cloth.state.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            cloth.missing_impulses[i] = to_vec4(-xyz(left[i]), 0);
    });
    const std::uint32_t first = step.equation.first, end = first + cloth.state.size();
    for (const SeamRows* seam : step.equation.seams)
        seam->for_each_particle(first, end, [&](const PairRows::AtParticle& at) {
            Vec4& missing = cloth.missing_impulses[at.particle - first];
            set_xyz(missing, xyz(missing) - at.impulse);
        });
    cloth.impulse_ratio = step.equation.h / step.equation.gamma;
}

// Called after settling, so that projection and cut are included. The rows are still those of the solve.
void log_pairs(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths) {
    float ratio = 0;
    for (Cloth* cloth : cloths) {
        if (cloth->impulse_ratio == 0) continue;
        ratio = cloth->impulse_ratio;
        for (std::uint32_t i = 0; i < cloth->state.size(); ++i) {
            const float w = cloth->state.positions[i].w;
            if (!(w > 0)) continue;
            Vec4& missing = cloth->missing_impulses[i];
            const Vector3 change = xyz(cloth->state.velocities[i]) - xyz(cloth->scratch_velocities[i]);
            set_xyz(missing, xyz(missing) + change / (w * ratio));
        }
    }
    if (ratio == 0) return;
    const auto body_of = [&](std::uint32_t corner) {
        std::size_t k = cloths.size() - 1;
        while (space.first(k) > corner) --k;
        return k;
    };
    share_out_impulses(space, cloths);
    for (Cloth* cloth : cloths) {
        if (std::exchange(cloth->impulse_ratio, 0.0f) == 0 || !cloth->contacts) continue;
        for (std::uint32_t i = 0; i < cloth->state.size(); ++i)
            if (cloth->missing_impulses[i].w > 0)
                add_impulse(*cloth, i,
                            ratio * cloth->missing_impulses[i].w * xyz(cloth->state.held.normals[i]));
    }
    space.rows().for_each_push([&](const PairRows::Push& push) {
        const std::uint32_t a = main_corner(push, 0, push.corners_of_a);
        const std::uint32_t b = main_corner(push, push.corners_of_a, 4);
        const std::size_t of_a = body_of(a), of_b = body_of(b);
        const Contact contact{.cloth = cloths[of_a]->id,
                              .other_cloth = cloths[of_b]->id,
                              .particle = a - space.first(of_a),
                              .other_particle = b - space.first(of_b),
                              .point = to_vec3(push.point),
                              .normal = to_vec3(push.pair.normal),
                              .impulse = to_vec3(Vector3(ratio * push.impulse))};
        const bool is_first = contact.cloth.index <= contact.other_cloth.index;
        log_contact(worker.contacts, *cloths[is_first ? of_a : of_b],
                    is_first ? contact : seen_from_other(contact));
    });
}

// Called before the response, of which it computes the velocity changes.
void log_avoidance(Worker& worker, Cloth& cloth, float h) {
    const ResponseSettings settings{cloth.rest_neighbours->distance(), cloth.settings.self_collision.friction,
                                    h};
    const std::span<const Vec4> positions = std::as_const(cloth.state.positions).span();
    cloth.self_contacts->for_each_stopped(settings, positions, std::as_const(cloth.state.velocities).span(),
                                          [&](std::uint32_t i, std::uint32_t j, const Vector3& change) {
                                              const Vector3 a = xyz(positions[i]), b = xyz(positions[j]);
                                              // For coincident particles the response chooses the direction.
                                              const Vector3 apart = a == b ? change : Vector3(a - b);
                                              log_contact(
                                                  worker.contacts, cloth,
                                                  {.cloth = cloth.id,
                                                   .other_cloth = cloth.id,
                                                   .particle = i,
                                                   .other_particle = j,
                                                   .point = to_vec3(Vector3(0.5f * (a + b))),
                                                   .normal = to_vec3(apart.stableNormalized()),
                                                   .impulse = to_vec3(Vector3(change / positions[i].w))});
                                          });
}

/// Finds the collider that is nearest to each particle with an impulse: w becomes its index + 1, or 0 where
/// it does not push.
void find_touched_colliders(const Simulation& world, Worker& worker, Cloth& cloth) {
    const ClothSide side = cloth.side();
    const auto touched = [&](std::uint32_t particle, const Vector3& position, const Vector3& impulse) {
        float least = std::numeric_limits<float>::infinity(), found = 0, along = 0;
        world.state.colliders.for_each([&](ColliderId id, const ColliderSlot& slot) {
            const Collider& collider = slot.target;
            if (collider.is_trigger || !side.meets(collider, particle)) return;
            const SurfacePoint surface = nearest_surface(collider, position, world.held_by(collider));
            const float gap = surface.distance - collider.thickness;
            if (!(gap < least)) return;
            least = gap;
            along = surface.normal.dot(impulse);
            found = static_cast<float>(id.index + 1);
        });
        return along > 0 ? found : 0;
    };
    worker.parallel.ranges(cloth.state.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            Vec4& impulse = cloth.collider_impulses[i];
            if (xyz(impulse).isZero(0)) continue;
            const float w = cloth.restored ? 0 : touched(i, xyz(cloth.state.positions[i]), xyz(impulse));
            impulse = w > 0 ? to_vec4(xyz(impulse), w) : Vec4{};
        }
    });
}

void report_contacts(Simulation& world) {
    world.collider_ids.clear();
    world.state.colliders.for_each([&](ColliderId id, const ColliderSlot&) {
        world.collider_ids.resize(id.index + 1);
        world.collider_ids.back() = id;
    });
    for (Cloth* cloth : world.present) {
        log_colliders(world, *cloth);
        log_triggers(world, *cloth);
    }
    world.contact_reports.gather([&](const Contact& c) { return !(*world.cloths.find(c.cloth))->restored; });
    for (const Cloth* cloth : world.present)
        world.report.contacts += cloth->restored ? 0 : cloth->contact_count;
}

}  // namespace weft
