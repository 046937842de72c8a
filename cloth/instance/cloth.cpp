#include "cloth/instance/cloth.h"

#include <algorithm>
#include <utility>

#include "cloth/instance/copies.h"
#include "cloth/instance/group.h"
#include "cloth/instance/make_solver.h"
#include "cloth/instance/pins.h"
#include "cloth/instance/saved_cloth.h"
#include "cloth/mesh/rest/linear_bending.h"
#include "engine/memory/without_exceptions.h"

namespace weft {

namespace {

// Least gap of features, as a fraction of the contact radius. Smaller gaps would go on shrinking until
// rounding crosses them.
constexpr float floor_per_radius = 2e-3f / 0.3f;

/// The floor of a cloth with slivers is half of their height, but no less than a fiftieth of what it would
/// be. Features that rest nearer than the floor may move apart and never return: slivers would stretch, step
/// by step, and throw the cloth about.
float floor_of(const ContactMesh& mesh, float radius) {
    const float floor = floor_per_radius * radius;
    return std::clamp(0.5f * mesh.least_height(), 0.02f * floor, floor);
}

bool has_avoidance(const SelfCollision& settings) {
    return search_of(settings.method).has_value();
}

float distance_of(const ClothModel& model, const SelfCollision& of) {
    const float part = has_avoidance(of) ? 0.75f : 0.3f;
    return of.distance > 0 ? of.distance : part * model.info.mean_edge;
}

/// The mesh of features, with the rest positions by which searches pass over calm parts: of a grid its flat
/// pattern, by its first row and column; of other meshes the positions at which the cloth started.
std::shared_ptr<const ContactMesh> mesh_of_features(const ClothModel& model) {
    if (model.rows < 2 || model.columns < 2)
        return std::make_shared<const ContactMesh>(model.positions.span(), model.triangles);
    AlignedBuffer<Vec4> flat(model.particle_count);
    const auto length = [&](std::uint32_t i, std::uint32_t j) {
        return static_cast<float>(rest_length_between(model, i, j));
    };
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const std::uint32_t row = i / model.columns, column = i % model.columns;
        flat[i].x = column == 0 ? 0 : flat[column - 1].x + length(column - 1, column);
        flat[i].z =
            row == 0 ? 0 : flat[i - model.columns].z + length((row - 1) * model.columns, row * model.columns);
    }
    return std::make_shared<const ContactMesh>(flat.span(), model.triangles);
}

/// Rest neighbours along springs. For features bending springs do not count, only edges of triangles and
/// diagonals of a grid's cells: contact lets cloth bend as far as these allow.
Result<RestNeighbours> find_rest_neighbours(const ClothModel& model, const SelfCollision& settings) {
    std::vector<std::uint32_t> offsets, neighbours;
    std::vector<float> lengths;
    RestGraph graph{model.spring_offsets.span(), model.neighbours.span(), model.rest_lengths.span()};
    if (has_features(settings)) {
        offsets.push_back(0);
        for (std::uint32_t i = 0; i < model.particle_count; ++i) {
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                if (model.kinds[e] == SpringKind::bending) continue;
                neighbours.push_back(model.neighbours[e]);
                lengths.push_back(model.rest_lengths[e]);
            }
            offsets.push_back(static_cast<std::uint32_t>(neighbours.size()));
        }
        graph = {offsets, neighbours, lengths};
    }
    std::optional<JoinsWithCopies> joins;
    if (!has_features(settings) && model.rows == 0) joins = joins_with_copies(model);
    if (joins) graph = joins->graph();
    return RestNeighbours::find(graph, distance_of(model, settings));
}

}  // namespace

Result<void> validate_neighbours(const ClothModel& model, const ClothSettings& settings) {
    if constexpr (has_exceptions) return {};
    if (settings.self_collision.method == SelfCollisionMethod::off) return {};
    if (auto found = find_rest_neighbours(model, settings.self_collision); !found) return found.error();
    return {};
}

Cloth::Cloth(ClothModel cooked, const ClothSettings& initial, const Progress& progress)
    : model(with_bending_ratio(std::move(cooked), initial.fabric.bending_ratio)),
      settings(initial),
      state(model.particle_count),
      scratch_velocities(model.particle_count),
      side_buffers(model.particle_count),
      surface(model),
      partial_counts(block_count(model.particle_count)),
      partial_sums(block_count(model.particle_count)),
      partial_surveys(block_count(model.particle_count)) {
    start_at_rest();
    solver = make_solver(model, initial, state.positions.span());
    progress.reach(Progress::solvable);
    limits = make_limits(model, initial, {});
    progress.reach(Progress::limited);
    apply(initial);
}

Cloth::Cloth(ClothModel cooked, const ClothSettings& initial, SavedCloth&& saved)
    : model(std::move(cooked)),
      settings(initial),
      state(model.particle_count, unmade),
      scratch_velocities(model.particle_count, unmade),
      side_buffers(model.particle_count),
      rest_neighbours(std::move(saved.rest_neighbours)),
      contact_mesh(std::move(saved.contact_mesh)),
      surface(std::move(saved.surface)),
      partial_counts(block_count(model.particle_count), unmade),
      partial_sums(block_count(model.particle_count), unmade),
      partial_surveys(block_count(model.particle_count), unmade) {
    start_at_rest();
    SavedLevels* const levels = saved.levels ? &*saved.levels : nullptr;
    solver = make_solver(model, initial, state.positions.span(), levels);
    limits = make_limits(model, initial, {});
    if (is_second_order(initial, *solver)) {
        history.emplace();
        state.record = StepRecord(model.particle_count, unmade);
    }
    apply(initial);
}

void Cloth::start_at_rest() {
    std::ranges::copy(model.positions.span(), state.positions.data());
    std::ranges::copy(model.positions.span(), state.previous_positions.data());
    bending_per_area = find_bending_per_area(model);
    set_inverse_masses();
}

bool Cloth::is_second_order(const ClothSettings& of, const Solver& with) const {
    return resolved(of.time_scheme, of.method) == TimeScheme::bdf2 && with.is_implicit();
}

/// A new solver; null if the present one serves.
std::unique_ptr<Solver> Cloth::solver_for(const ClothSettings& changed) const {
    if (solver->serves(changed) && changed.fabric.bending_ratio == settings.fabric.bending_ratio)
        return nullptr;
    std::unique_ptr<Solver> made = make_solver(model, changed, state.positions.span());
    made->reserve_pins(state.pins.size());
    return made;
}

void Cloth::apply(const ClothSettings& changed, const MakeRoom& make_room) {
    if (changed.fabric.bending_ratio == model.bending_ratio) return apply_to_model(changed, make_room);
    ClothModel other = with_bending_ratio(model, changed.fabric.bending_ratio);
    std::swap(model, other);
    or_undo([&] { apply_to_model(changed, make_room); }, [&] { std::swap(model, other); });
    bending_per_area = find_bending_per_area(model);
}

void Cloth::apply_to_model(const ClothSettings& changed, const MakeRoom& make_room) {
    std::unique_ptr<Solver> other_solver = solver_for(changed);
    const Solver& with = other_solver ? *other_solver : *solver;
    const bool second_order = is_second_order(changed, with);
    const bool has_limits = have_same_limits(settings, changed);
    Limits other_limits = has_limits ? Limits() : make_limits(model, changed, particles_of(state.pins));
    std::optional<History> new_history;
    StepRecord new_record;
    if (second_order && !history) {
        new_history.emplace();
        new_record = StepRecord(model.particle_count);
    }
    const SelfCollision& self_collision = changed.self_collision;
    std::optional<SelfContacts> new_self_contacts;
    const std::optional<SelfCollisionSearch> search = search_of(self_collision.method);
    if (search && !(self_contacts && self_contacts->has_memory_for(*search)))
        new_self_contacts.emplace(model.positions.span(), *search);
    std::optional<FeatureBuffers> new_features = make_features(self_collision);
    std::optional<RestNeighbours> new_rest_neighbours;
    const float distance = distance_of(self_collision);
    const bool same_method = self_collision.method == settings.self_collision.method;
    const bool same_springs = changed.fabric.bending_ratio == settings.fabric.bending_ratio;
    if (self_collision.method != SelfCollisionMethod::off &&
        (!rest_neighbours || rest_neighbours->distance() != distance || !same_method || !same_springs)) {
        Result<RestNeighbours> found = find_rest_neighbours(model, self_collision);
        if (!found) refuse(found.error());
        new_rest_neighbours = std::move(found).value();
    }
    std::optional<ContactBuffers> new_contacts = make_contacts(has_colliders_, changed, with);
    if (pairs_in_equation(self_collision) > 0) reserve_pairs(other_solver ? *other_solver : *solver);
    if (!other_solver) solver->make_own(changed);
    const bool meets_others = self_collision.layers != settings.self_collision.layers ||
                              self_collision.mask != settings.self_collision.mask;
    const bool has_new_mesh = new_features && new_features->mesh;
    const std::size_t bytes = scratch_of_steps(other_solver ? *other_solver : *solver, second_order, changed,
                                               has_new_mesh ? new_features->mesh.get() : contact_mesh.get());
    if (make_room) make_room(bytes);

    // From here on nothing can fail.
    const bool is_other_density = changed.fabric.areal_density != settings.fabric.areal_density;
    const bool was_enabled = settings.enabled;
    settings = changed;
    settings.enabled = was_enabled;
    filling = make_filling(settings.filling);
    side_buffers.write(settings);
    set_enabled(changed.enabled);
    if (changed.sleep_speed > 0)
        state.rest.emplace();
    else
        state.rest.reset();
    if (is_other_density) set_inverse_masses();
    if (other_solver) solver = std::move(other_solver);
    solver->prepare(settings);
    if (is_other_density) solver->inverse_masses_changed(state.positions.span());
    if (!has_limits) limits = std::move(other_limits);
    if (new_history) {
        history = std::move(new_history);
        state.record = std::move(new_record);
    }
    if (!second_order) {
        history.reset();
        state.record = {};
    }
    if (new_self_contacts) self_contacts = std::move(new_self_contacts);
    if (new_rest_neighbours) rest_neighbours = std::move(new_rest_neighbours);
    if (!has_avoidance(self_collision)) {
        self_contacts.reset();
        self_counts = {};
    }
    take_features(std::move(new_features), self_collision);
    scratch_bytes = bytes;
    if (has_features() && (meets_others || !same_method)) state.may_cross = 1;
    if (self_collision.method == SelfCollisionMethod::off) rest_neighbours.reset();
    take_contacts(std::move(new_contacts), has_colliders_);
}

std::optional<FeatureBuffers> Cloth::make_features(const SelfCollision& of) const {
    if (!weft::has_features(of) || has_features()) return std::nullopt;
    std::shared_ptr<const ContactMesh> made = contact_mesh ? nullptr : mesh_of_features(model);
    return std::optional<FeatureBuffers>(std::in_place, std::move(made), model.particle_count);
}

void Cloth::take_features(std::optional<FeatureBuffers>&& made, const SelfCollision& of) noexcept {
    if (made) {
        if (made->mesh) {
            contact_mesh = std::move(made->mesh);
            shares_contact_mesh = false;
        }
        state.tangles = std::move(made->tangles);
        state.may_cross = 1;
    }
    if (pairs_in_equation(of) == 0) solver->reserve_pairs(0);
    if (weft::has_features(of)) return;
    contact_mesh.reset();
    state.tangles = {};
    state.may_cross = state.halved = 0;
    feature_counts = {};
}

void Cloth::lay_out(Scratch& scratch) {
    if (history) history->lay_out(scratch, model.particle_count);
    solver->lay_out(scratch, pairs_in_equation(settings.self_collision));
    if (filling) filling->lay_out(scratch, model.particle_count);
}

void Cloth::take_solver(std::unique_ptr<Solver>&& made) {
    solver = std::move(made);
    scratch_bytes = scratch_of_steps(*solver, history.has_value(), settings, contact_mesh.get());
}

std::size_t Cloth::scratch_of_steps(Solver& with, bool second_order, const ClothSettings& of,
                                    const ContactMesh* mesh) const {
    const SelfCollision& contact = of.self_collision;
    Scratch scratch;
    if (second_order) History().lay_out(scratch, model.particle_count);
    with.lay_out(scratch, pairs_in_equation(contact));
    if (auto filled = make_filling(of.filling)) filled->lay_out(scratch, model.particle_count);
    return scratch.bytes() +
           weft::scratch_bytes(weft::has_features(contact) ? mesh : nullptr, has_zones(contact));
}

/// Reserves room for pairs. If that fails, a cloth without pairs in its equation has none reserved.
void Cloth::reserve_pairs(Solver& with) const {
    or_undo([&] { with.reserve_pairs(FeatureContact::room_for_rows(model.particle_count)); },
            [&] {
                if (pairs_in_equation(settings.self_collision) == 0) with.reserve_pairs(0);
            });
}

bool Cloth::has_pair_rows(const ClothSettings& of, const Solver& with) const noexcept {
    return with.joins() && pairs_in_equation(of.self_collision) > 0;
}

std::size_t Cloth::pairs_in_equation(const SelfCollision& of) const noexcept {
    std::size_t count =
        of.method == SelfCollisionMethod::contact ? FeatureContact::room_for_rows(model.particle_count) : 0;
    for (const SeamRows* seam : seams) count += seam->capacity();
    return count;
}

std::optional<ContactBuffers> Cloth::make_contacts(bool any_colliders, const ClothSettings& of,
                                                   const Solver& with) const {
    const bool with_pairs = has_pair_rows(of, with);
    const bool with_surfaces = (any_colliders && meets_in_equation(of)) || worn.has_limits();
    const bool needed = with.is_implicit() && (with_surfaces || with_pairs);
    if (!needed || (contacts && contacts->has_pairs() == with_pairs)) return std::nullopt;
    return std::optional<ContactBuffers>(std::in_place, model.particle_count, with_pairs);
}

void Cloth::take_contacts(std::optional<ContactBuffers>&& made, bool any_colliders) noexcept {
    has_colliders_ = any_colliders;
    if (made) {
        const bool goes_on = contacts.has_value();  // only with or without pairs: held contact stays
        contacts = std::move(made->contacts);
        if (!goes_on) state.held = std::move(made->held);
    }
    const bool with_pairs = has_pair_rows(settings, *solver);
    const bool with_surfaces = (any_colliders && meets_in_equation(settings)) || worn.has_limits();
    if (solver->is_implicit() && (with_surfaces || with_pairs)) return;
    contacts.reset();
    state.held = {};
}

SeamBuffers Cloth::make_seams(std::vector<SeamRows*>&& list) {
    std::swap(seams, list);
    SeamBuffers made;
    const auto swap_back = [&] { std::swap(seams, list); };
    or_undo(
        [&] {
            if (pairs_in_equation(settings.self_collision) > 0) reserve_pairs(*solver);
            made.contacts = make_contacts(has_colliders_);
            made.scratch_bytes = scratch_of_steps(*solver, history.has_value(), settings, contact_mesh.get());
        },
        swap_back);
    swap_back();
    made.seams = std::move(list);
    return made;
}

void Cloth::take_seams(SeamBuffers&& made) noexcept {
    seams = std::move(made.seams);
    scratch_bytes = made.scratch_bytes;
    if (pairs_in_equation(settings.self_collision) == 0) solver->reserve_pairs(0);
    take_contacts(std::move(made.contacts), has_colliders_);
}

void Cloth::drop_seam(const SeamRows* gone) noexcept {
    std::erase(seams, gone);
    take_seams({std::move(seams), std::nullopt,
                scratch_of_steps(*solver, history.has_value(), settings, contact_mesh.get())});
}

ContactCloth Cloth::as_body() const {
    const float radius = distance_of(settings.self_collision);
    return {.mesh = contact_mesh.get(),
            .near_at_rest = rest_neighbours->filter(),
            .radius = radius,
            .floor = contact_mesh ? floor_of(*contact_mesh, radius) : floor_per_radius * radius,
            .friction = settings.self_collision.friction,
            .layer = settings.self_collision.layers,
            .mask = settings.self_collision.mask,
            .by_zones = has_zones(settings.self_collision),
            .restitution = settings.self_collision.restitution};
}

void Cloth::make_contact_mesh() {
    if (contact_mesh) return;
    contact_mesh = mesh_of_features(model);
    shares_contact_mesh = false;
}

void Cloth::drop_contact_mesh() noexcept {
    if (!has_features()) contact_mesh.reset();
}

ImpulseBuffers Cloth::make_impulses(bool reported) const {
    const std::uint32_t count = reported ? model.particle_count : 0;
    return {.of_colliders = AlignedBuffer<Vec4>(count),
            .missing = AlignedBuffer<Vec4>(count),
            .in_triggers = AlignedBuffer<DeepestInTrigger>(block_count(count))};
}

ColliderBuffers Cloth::make_collider_buffers(bool any_colliders) const {
    ColliderBuffers made;
    if (!any_colliders) return made;
    made.part_start = AlignedBuffer<Vec4>(model.particle_count);
    made.whole.emplace(model.triangles, model.particle_count, model.info.mean_edge);
    return made;
}

AirBuffers Cloth::make_air(bool on, bool air_varies) const {
    const auto sized = [&](bool needed) { return AlignedBuffer<Vec4>(needed ? model.particle_count : 0); };
    return {.forces = sized(on), .velocities = sized(on && air_varies)};
}

void Cloth::erase_contact_memory() noexcept {
    std::ranges::fill(state.held.normals.span(), Vec4{});
    std::ranges::fill(state.held.rubbed.span(), 0.0f);
    std::ranges::fill(state.held.loads.span(), Vec4{});
    std::ranges::fill(state.held.touching.span(), 0u);
    std::ranges::fill(state.shares, BodyShare{});
    state.may_cross = has_features() ? 1 : 0;
}

void Cloth::restore_start_of_step() {
    std::ranges::copy(state.previous_positions.span(), state.positions.data());
    std::ranges::fill(state.velocities.span(), Vec4{});
    erase_contact_memory();
    state.record.h = 0;
}

float Cloth::distance_of(const SelfCollision& self_collision) const {
    return weft::distance_of(model, self_collision);
}

}  // namespace weft
