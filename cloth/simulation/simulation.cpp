#include "cloth/simulation/simulation.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>

#include "cloth/air/air_sources.h"
#include "cloth/air/shelters.h"
#include "cloth/simulation/sewn.h"
#include "engine/memory/without_exceptions.h"
#include "engine/platform.h"

namespace weft {

namespace {

/// Whether the wind varies from place to place.
bool varies(const Wind& wind) {
    return wind.gust > 0 || has_sources(wind) || has_shelters(wind);
}

Parallel make_parallel(const WorldSettings& settings) {
    if (settings.executor.run != nullptr) return Parallel(settings.executor);
    const int cores = hardware_threads();
    return Parallel(settings.threads > 0 ? settings.threads : std::clamp(cores, 1, 256));
}

ContactReports make_reports(const WorldSettings& settings, const Parallel& threads) {
    return {static_cast<std::size_t>(settings.contact_reports), threads.width()};
}

bool have_same_threads(const WorldSettings& a, const WorldSettings& b) {
    return a.threads == b.threads && a.executor.run == b.executor.run && a.executor.user == b.executor.user &&
           a.executor.width == b.executor.width;
}

/// Whether both settings exert the same forces on cloth at rest.
bool have_same_forces(const WorldSettings& a, const WorldSettings& b) {
    static_assert(std::is_trivially_copyable_v<Wind> && sizeof(AirSource) == 8 * sizeof(float) &&
                  sizeof(AirShelter) == 14 * sizeof(float) &&
                  sizeof(Wind) == 9 * sizeof(float) + sizeof(Wind::sources) + sizeof(Wind::shelters));
    return std::memcmp(&a.wind, &b.wind, sizeof a.wind) == 0 && to_vector(a.gravity) == to_vector(b.gravity);
}

using Motions = std::vector<std::vector<ColliderMotion>>;

Motions make_motions(int threads, std::size_t colliders) {
    Motions motions(static_cast<std::size_t>(threads));
    for (std::vector<ColliderMotion>& of_thread : motions) of_thread.reserve(colliders);
    return motions;
}

void reserve_collider_ids(Simulation& world) {
    std::size_t count = 0;
    world.state.colliders.for_each([&](ColliderId id, const ColliderSlot&) { count = id.index + 1; });
    world.collider_ids.reserve(count);
}

void reserve_budget(Simulation& world, std::size_t cloths) {
    world.allotment.reserve(cloths);
    world.choices.reserve(cloths);
}

/// Makes room for one cloth more, so that no step needs to.
void reserve_cloth(Simulation& world) {
    while (world.views.size() <= world.cloths.slots()) world.views.push_back(std::make_unique<ClothView>());
    const std::size_t count = world.cloths.size() + 1;
    world.present.reserve(count);
    world.still_for.reserve(count);
    world.boxes.reserve(count);
    world.each_cloth.reserve(count);
    world.groups.reserve(count);
    world.group_finder.reserve(count);
    if (world.body_stage) world.body_stage->reserve(count, world.state.colliders.size());
    if (world.settings.budget > 0) reserve_budget(world, count);
}

/// Buffers made for each cloth, which they replace once all have been made.
template <class Made>
using ForCloths = std::vector<std::pair<Cloth*, Made>>;

}  // namespace

Simulation::Simulation(const WorldSettings& initial)
    : settings(initial),
      parallel(make_parallel(initial)),
      profiler(stage_names),
      motions(make_motions(parallel.width(), 0)),
      contact_reports(make_reports(initial, parallel)) {
    parallel.trace_to(&profiler.trace());
}

void Simulation::apply(const WorldSettings& changed) {
    std::optional<Parallel> threads;
    Motions motions_of_threads;
    Room room;
    if (!have_same_threads(changed, settings)) {
        threads.emplace(make_parallel(changed));
        room = make_room({}, threads->width());
        motions_of_threads = make_motions(threads->width(), state.colliders.size());
    }
    std::optional<ContactReports> reports;
    if (threads || changed.contact_reports != settings.contact_reports)
        reports = make_reports(changed, threads ? *threads : parallel);
    const bool reported = changed.contact_reports > 0;
    ForCloths<ImpulseBuffers> impulses;
    if (reported != reports_contacts()) {
        impulses.reserve(cloths.size());
        cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
            impulses.emplace_back(cloth.get(), cloth->make_impulses(reported));
        });
        if (reported) reserve_collider_ids(*this);
    }
    const bool on = changed.wind.air_density > 0, air_varies = varies(changed.wind);
    ForCloths<AirBuffers> air;
    if (on != air_is_on() || air_varies != varies(settings.wind)) {
        air.reserve(cloths.size());
        cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
            air.emplace_back(cloth.get(), cloth->make_air(on, air_varies));
        });
    }

    const bool has_budget = changed.budget > 0;
    ForCloths<BudgetBuffers> budgets;
    if (has_budget != (settings.budget > 0)) {
        budgets.reserve(cloths.size());
        cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
            budgets.emplace_back(cloth.get(), cloth->make_budget(has_budget));
        });
        if (has_budget) reserve_budget(*this, cloths.size());
    }

    // From here on nothing can fail.
    take(std::move(room));
    if (threads) {
        parallel = *std::move(threads);
        parallel.trace_to(&profiler.trace());
        motions = std::move(motions_of_threads);
    }
    if (reports) contact_reports = *std::move(reports);
    for (auto& [cloth, made] : impulses) cloth->take_impulses(std::move(made));
    for (auto& [cloth, made] : air) cloth->take_air(std::move(made));
    for (auto& [cloth, made] : budgets) cloth->take_budget(std::move(made));
    if (!has_budget) choices.clear();
    if (!have_same_forces(settings, changed)) wake_all();
    settings = changed;
}

ClothId Simulation::add(std::unique_ptr<Cloth>&& cloth) {
    reserve_cloth(*this);
    const Newcomer newcomer{nullptr, cloth->scratch_bytes, cloth->settings.self_collision,
                            cloth->contact_mesh.get()};
    Room room = make_room({&newcomer, 1}, parallel.width());
    const ClothId id = cloths.insert(std::move(cloth));
    take(std::move(room));
    return id;
}

void Simulation::apply(Cloth& cloth, const ClothSettings& changed) {
    const SelfCollision& of = changed.self_collision;
    const bool has_other_levels = cloth.sewn.levels && cloth.has_other_levels(changed);
    Room room;
    Sewn sewn;
    or_undo(
        [&] {
            if (has_features(of)) cloth.make_contact_mesh();
            cloth.apply(changed, [&](std::size_t bytes) {
                if (has_other_levels) sewn = sew_again(*this, cloth, {.other = {&cloth, &changed}});
                const Newcomer newcomer{&cloth, bytes, of, cloth.contact_mesh.get(), !cloth.seams.empty()};
                room = make_room({&newcomer, 1}, parallel.width());
            });
        },
        [&] { cloth.drop_contact_mesh(); });
    take(std::move(room));
    sewn.give_to(*this);
}

void Simulation::set_map(Cloth& cloth, Map map, AlignedBuffer<float>&& values) {
    Room room;
    Sewn sewn;
    cloth.set_map(map, std::move(values), [&](std::size_t bytes) {
        if (cloth.sewn.levels) sewn = sew_again(*this, cloth);
        const Newcomer newcomer{&cloth, bytes, cloth.settings.self_collision, cloth.contact_mesh.get(),
                                !cloth.seams.empty()};
        room = make_room({&newcomer, 1}, parallel.width());
    });
    take(std::move(room));
    sewn.give_to(*this);
}

// Cloths that may touch, are joined or share a body may all be one group. Of the others each thread has one
// at a time.
Simulation::RoomTaken Simulation::room_taken(Newcomers newcomers, int threads) const {
    RoomTaken taken;
    std::vector<std::size_t> alone;
    alone.reserve(cloths.size() + 1);
    const auto add = [&](std::size_t bytes, const SelfCollision& of, const ContactMesh* mesh,
                         bool is_joined) {
        if (has_zones(of)) taken.by_zones += FeatureContact::particles_of(*mesh);
        if (!has_features(of) && !is_joined && state.bodies.size() == 0) return alone.push_back(bytes);
        taken.in_groups += bytes;
        ++taken.grouped;
    };
    for (const Newcomer& one : newcomers) add(one.scratch_bytes, one.of, one.mesh, one.is_joined);
    cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) {
        if (std::ranges::find(newcomers, cloth.get(), &Newcomer::in_place_of) != newcomers.end()) return;
        add(cloth->scratch_bytes, cloth->settings.self_collision, cloth->contact_mesh.get(),
            !cloth->seams.empty());
    });
    const auto most = alone.begin() + std::min<std::ptrdiff_t>(threads, std::ssize(alone));
    std::ranges::nth_element(alone, most, std::ranges::greater());
    taken.alone = std::accumulate(alone.begin(), most, std::size_t{0});
    return taken;
}

// Scratch of groups grows by 1/8, counted in cloths, so that n additions reallocate O(log n) times.
Simulation::Room Simulation::make_room(Newcomers newcomers, int threads) const {
    const RoomTaken taken = room_taken(newcomers, threads);
    Room room;
    if (taken.in_groups + taken.alone > scratch.bytes()) {
        const std::size_t one = taken.in_groups / std::max<std::size_t>(taken.grouped, 1);
        room.scratch = ScratchMemory(taken.in_groups + one * (taken.grouped / 8) + taken.alone);
    }
    if (taken.by_zones > zone_particles) {
        room.zones = std::make_unique<ImpactZones>();
        room.zones->reserve(taken.by_zones, FeatureContact::room_for_pairs(taken.by_zones));
        room.zone_particles = taken.by_zones;
    }
    return room;
}

void Simulation::take(Room&& room) noexcept {
    if (room.scratch.bytes() > 0) scratch = std::move(room.scratch);
    if (!room.zones) return;
    zones = std::move(room.zones);
    zone_particles = room.zone_particles;
}

std::size_t Simulation::bytes_to_spare() const {
    const RoomTaken taken = room_taken({}, parallel.width());
    std::size_t used = taken.in_groups + taken.alone;
    cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) { used += cloth->zone_bytes(); });
    // Clamped at 0: each cloth by zones counts the least number of pairs, which few cloths share.
    return common_bytes() - std::min(common_bytes(), used);
}

void Simulation::cloth_has_gone() noexcept {
    if (cloths.size() > 0) return;
    scratch = {};
    zones.reset();
    zone_particles = 0;
}

const HeldShape* Simulation::held_by(const Collider& collider) const noexcept {
    const auto* const placed = std::get_if<PlacedShape>(&collider.shape);
    const std::unique_ptr<HeldShape>* const held = placed != nullptr ? shapes.find(placed->shape) : nullptr;
    return held != nullptr ? held->get() : nullptr;
}

void Simulation::expect_colliders(std::size_t count) {
    for (std::vector<ColliderMotion>& of_thread : motions) of_thread.reserve(count);
    if (body_stage) body_stage->reserve(cloths.size(), count);
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        if (cloth->state.frame) cloth->seen_colliders.reserve(count);
    });
    if (reports_contacts()) reserve_collider_ids(*this);
    ForCloths<std::optional<ContactBuffers>> contacts;
    ForCloths<ColliderBuffers> buffers;
    const bool any = count > 0 || state.bodies.size() > 0;
    if (any) {
        contacts.reserve(cloths.size());
        buffers.reserve(cloths.size());
        cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
            contacts.emplace_back(cloth.get(), cloth->make_contacts(true));
            if (!cloth->whole) buffers.emplace_back(cloth.get(), cloth->make_collider_buffers(true));
        });
    }

    // From here on nothing can fail.
    for (auto& [cloth, made] : contacts) cloth->take_contacts(std::move(made), true);
    for (auto& [cloth, made] : buffers) cloth->take_collider_buffers(std::move(made));
    if (!any)
        cloths.for_each([](ClothId, std::unique_ptr<Cloth>& cloth) {
            cloth->take_contacts(std::nullopt, false);
            cloth->take_collider_buffers({});
        });
}

void Simulation::prepare(Cloth& cloth) {
    const bool any_colliders = state.colliders.size() > 0 || state.bodies.size() > 0;
    prepare_for_bodies(cloth);
    cloth.take_budget(cloth.make_budget(settings.budget > 0));
    cloth.take_air(cloth.make_air(air_is_on(), varies(settings.wind)));
    cloth.take_impulses(cloth.make_impulses(reports_contacts()));
    cloth.take_contacts(cloth.make_contacts(any_colliders), any_colliders);
    cloth.take_collider_buffers(cloth.make_collider_buffers(any_colliders));
    cloth.extent = survey(parallel, cloth.state, cloth.partial_surveys.span());
    update_normals(parallel, cloth);
}

void Simulation::state_has_changed(Cloth& cloth) {
    cloth.commit_restore();
    cloth.extent = survey(parallel, cloth.state, cloth.partial_surveys.span());
}

void Simulation::update_normals(Parallel& loops, Cloth& cloth) {
    cloth.surface.compute_normals(loops, cloth.state.positions.span(), cloth.state.normals.span());
}

}  // namespace weft
