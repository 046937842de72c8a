#include "cloth/frame/cloth.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cloth/frame/make_solver.h"

namespace weft {

namespace {

/// Whether what a solver is made from differs; all else it reads at each step.
bool needs_another_solver(const ClothSettings& a, const ClothSettings& b) {
    const FiniteElements &from = a.finite_elements, &to = b.finite_elements;
    return a.method.index() != b.method.index() || from.enabled != to.enabled ||
           from.dihedral != to.dihedral || from.consistent_mass != to.consistent_mass ||
           (from.bending > 0) != (to.bending > 0);
}

/// Throws what is wrong, for the World to tell.
RestNeighbours find_rest_neighbours(const CookedCloth& model, float distance) {
    auto found = RestNeighbours::find(
        {model.spring_offsets.span(), model.neighbours.span(), model.rest_lengths.span()}, distance);
    if (!found) throw std::length_error(found.error().message);
    return std::move(found).value();
}

std::size_t bytes_of(const CookedCloth& model) {
    return model.positions.bytes() + model.rest_area.bytes() + model.spring_offsets.bytes() +
           model.neighbours.bytes() + model.rest_lengths.bytes() + model.kinds.bytes() +
           model.corner_offsets.bytes() + model.corner_triangles.bytes() +
           model.triangles.size() * sizeof(Triangle) +
           model.panel_sides.size() * sizeof(model.panel_sides[0]) +
           (model.component_offsets.size() + model.component_particles.size() +
            model.vertex_to_particle.size()) *
               sizeof(std::uint32_t);
}

}  // namespace

Cloth::Cloth(CookedCloth cooked, const ClothSettings& initial)
    : model(std::move(cooked)),
      state(model.particle_count),
      velocity_change(model.particle_count),
      surface(model),
      partial_counts(block_count(model.particle_count)),
      partial_surveys(block_count(model.particle_count)) {
    std::ranges::copy(model.positions.span(), state.positions.data());
    std::ranges::copy(model.positions.span(), state.previous_positions.data());
    apply(initial);
}

void Cloth::apply(const ClothSettings& changed) {
    // Memory first: if there is none, nothing has changed yet.
    if (!solver || needs_another_solver(settings, changed)) solver = make_solver(model, changed);
    if (changed.tethers.enabled && !tethers) tethers.emplace(model);
    if (changed.self_collision.enabled && !self_contacts) self_contacts.emplace(model.positions.span());
    const bool second_order = changed.time_scheme == TimeScheme::bdf2 && solver->is_implicit();
    if (second_order && !history) history.emplace(model.particle_count);
    set_colliders(has_colliders_);
    const float distance = distance_of(changed.self_collision);
    if (changed.self_collision.enabled && (!rest_neighbours || rest_neighbours->distance() != distance))
        rest_neighbours = find_rest_neighbours(model, distance);
    if (!second_order) history.reset();
    if (!changed.tethers.enabled) {
        tethers.reset();
        tethers_are_attached = false;
    }
    if (!changed.self_collision.enabled) {
        self_contacts.reset();
        rest_neighbours.reset();
        self_counts = {};
    }
    settings = changed;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        set_inverse_mass(i, find_pin(i) == nullptr ? inverse_mass_when_free(i) : 0.0f);
    }
}

void Cloth::set_colliders(bool any) {
    has_colliders_ = any;
    const bool needed = any && solver->is_implicit();
    if (needed && !contacts) contacts.emplace(model.particle_count);
    if (!needed) contacts.reset();
}

void Cloth::set_air(bool on, bool gusts) {
    const auto provide = [&](AlignedBuffer<Vec4>& buffer, bool needed) {
        const std::size_t size = needed ? model.particle_count : 0;
        if (buffer.size() != size) buffer = AlignedBuffer<Vec4>(size);
    };
    provide(air_forces, on);
    provide(air_velocities, on && gusts);
}

float Cloth::inverse_mass_when_free(std::uint32_t particle) const {
    const float m = mass(particle);
    return m > 0 ? 1.0f / m : 0.0f;
}

void Cloth::set_inverse_mass(std::uint32_t particle, float inverse_mass) {
    state.positions[particle].w = inverse_mass;
    state.previous_positions[particle].w = inverse_mass;
    solver_is_prepared = false;
}

Pin* Cloth::find_pin(std::uint32_t particle) {
    const auto at = std::ranges::lower_bound(pins, particle, {}, &Pin::particle);
    return at != pins.end() && at->particle == particle ? &*at : nullptr;
}

void Cloth::pin(std::uint32_t particle) {
    if (find_pin(particle) != nullptr) return;
    const auto at = std::ranges::lower_bound(pins, particle, {}, &Pin::particle);
    pins.insert(at, {particle, xyz(state.positions[particle])});
    tethers_are_attached = false;
    state.velocities[particle] = {};
    set_inverse_mass(particle, 0);
}

void Cloth::unpin(std::uint32_t particle) {
    std::erase_if(pins, [&](const Pin& pin) { return pin.particle == particle; });
    tethers_are_attached = false;
    set_inverse_mass(particle, inverse_mass_when_free(particle));
    // What it did as a pin says nothing about how it goes on: BDF2 would give it a part of its weight only.
    if (history) history->forget();
}

void Cloth::restore_start_of_step() {
    std::ranges::copy(state.previous_positions.span(), state.positions.data());
    std::ranges::fill(state.velocities.span(), Vec4{});
    if (history) history->forget();
}

float Cloth::distance_of(const SelfCollision& self_collision) const {
    return self_collision.distance > 0 ? self_collision.distance : 0.75f * model.info.mean_edge;
}

ClothInfo Cloth::info() const {
    ClothInfo info = model.info;
    double mass_sum = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) mass_sum += static_cast<double>(mass(i));
    info.mass = static_cast<float>(mass_sum);
    info.bytes = bytes_of(model) + state.bytes() + solver->bytes() + velocity_change.bytes() +
                 (history ? history->bytes() : 0) + (tethers ? tethers->bytes() : 0) +
                 (self_contacts ? self_contacts->bytes() : 0) + (contacts ? contacts->bytes() : 0) +
                 (rest_neighbours ? rest_neighbours->bytes() : 0) + surface.bytes() + air_velocities.bytes() +
                 air_forces.bytes() + partial_counts.bytes() + partial_surveys.bytes();
    return info;
}

}  // namespace weft
