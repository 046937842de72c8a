#include "cloth/frame/cloth.h"

#include <algorithm>
#include <utility>

#include "cloth/frame/make_solver.h"

namespace weft {

namespace {

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
      next_velocities(model.particle_count),
      surface(model),
      partial_counts(block_count(model.particle_count)),
      partial_surveys(block_count(model.particle_count)) {
    std::ranges::copy(model.positions.span(), state.positions.data());
    std::ranges::copy(model.positions.span(), state.previous_positions.data());
    apply(initial);
}

void Cloth::apply(const ClothSettings& changed) {
    // Memory first: if there is none, nothing has changed yet.
    if (!solver || !solver->serves(changed)) solver = make_solver(model, changed, state.positions.span());
    if (changed.tethers.enabled && !tethers) tethers.emplace(model);
    if (changed.self_collision.enabled && !self_contacts) self_contacts.emplace(model.positions.span());
    const bool second_order = changed.time_scheme == TimeScheme::bdf2 && solver->is_implicit();
    if (second_order && !history) history.emplace(model.particle_count);
    set_colliders(has_colliders_);
    if (!second_order) history.reset();
    if (!changed.tethers.enabled) {
        tethers.reset();
        tethers_are_attached = false;
    }
    if (!changed.self_collision.enabled) {
        self_contacts.reset();
        self_counts = {};
    }
    settings = changed;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        set_inverse_mass(i, find_pin(i) == nullptr ? inverse_mass_when_free(i) : 0.0f);
    }
    solver->inverse_masses_changed(state.positions.span());
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
}

Pin* Cloth::find_pin(std::uint32_t particle) {
    const auto at = std::ranges::lower_bound(pins, particle, {}, &Pin::particle);
    return at != pins.end() && at->particle == particle ? &*at : nullptr;
}

void Cloth::pin(std::uint32_t particle) {
    if (find_pin(particle) != nullptr) return;
    solver->reserve_pins(pins.size() + 1);
    const auto at = std::ranges::lower_bound(pins, particle, {}, &Pin::particle);
    pins.insert(at, {particle, xyz(state.positions[particle])});
    tethers_are_attached = false;
    state.velocities[particle] = {};
    set_inverse_mass(particle, 0);
    solver->inverse_mass_changed(particle, state.positions.span());
}

void Cloth::unpin(std::uint32_t particle) {
    std::erase_if(pins, [&](const Pin& pin) { return pin.particle == particle; });
    tethers_are_attached = false;
    set_inverse_mass(particle, inverse_mass_when_free(particle));
    solver->inverse_mass_changed(particle, state.positions.span());
    // What it did as a pin says nothing about how it goes on: BDF2 would give it a part of its weight only.
    if (history) history->forget();
}

void Cloth::restore_start_of_step() {
    std::ranges::copy(state.previous_positions.span(), state.positions.data());
    std::ranges::fill(state.velocities.span(), Vec4{});
    if (history) history->forget();
}

float Cloth::self_collision_distance() const {
    const float set = settings.self_collision.distance;
    return set > 0 ? set : 0.75f * model.info.mean_edge;
}

ClothInfo Cloth::info() const {
    ClothInfo info = model.info;
    double mass_sum = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) mass_sum += static_cast<double>(mass(i));
    info.mass = static_cast<float>(mass_sum);
    info.bytes = bytes_of(model) + state.bytes() + solver->bytes() + next_velocities.bytes() +
                 (history ? history->bytes() : 0) + (tethers ? tethers->bytes() : 0) +
                 (self_contacts ? self_contacts->bytes() : 0) + (contacts ? contacts->bytes() : 0) +
                 surface.bytes() + air_velocities.bytes() + air_forces.bytes() + partial_counts.bytes() +
                 partial_surveys.bytes();
    return info;
}

}  // namespace weft
