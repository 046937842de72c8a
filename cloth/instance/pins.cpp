#include "cloth/instance/pins.h"

#include <algorithm>
#include <utility>

#include "cloth/instance/cloth.h"

namespace weft {

std::vector<std::uint32_t> particles_of(std::span<const Pin> pins) {
    std::vector<std::uint32_t> particles;
    particles.reserve(pins.size());
    for (const Pin& pin : pins) particles.push_back(pin.particle);
    return particles;
}

float Cloth::inverse_mass_when_free(std::uint32_t particle) const {
    const float m = mass(particle);
    return m > 0 ? 1.0f / m : 0.0f;
}

void Cloth::set_inverse_masses() {
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        state.positions[i].w = state.previous_positions[i].w = inverse_mass_when_free(i);
    for (const Pin& pin : state.pins)
        state.positions[pin.particle].w = state.previous_positions[pin.particle].w = 0;
}

Pin* Cloth::find_pin(std::uint32_t particle) {
    const auto at = std::ranges::lower_bound(state.pins, particle, {}, &Pin::particle);
    return at != state.pins.end() && at->particle == particle ? &*at : nullptr;
}

void Cloth::pin(std::span<const std::uint32_t> particles) {
    std::vector<Pin> pins = state.pins;
    pins.reserve(pins.size() + particles.size());
    for (const std::uint32_t i : particles) pins.push_back({i, xyz(state.positions[i])});
    // If a particle is pinned twice, the earlier pin stays.
    std::ranges::stable_sort(pins, {}, &Pin::particle);
    const auto again = std::ranges::unique(pins, {}, &Pin::particle);
    pins.erase(again.begin(), again.end());
    change_pins(std::move(pins));
}

void Cloth::unpin(std::span<const std::uint32_t> particles) {
    std::vector<std::uint32_t> ascending(particles.begin(), particles.end());
    std::ranges::sort(ascending);
    std::vector<Pin> pins = state.pins;
    std::erase_if(pins, [&](const Pin& pin) { return std::ranges::binary_search(ascending, pin.particle); });
    change_pins(std::move(pins));
}

void Cloth::pin_only(std::span<const std::uint32_t> particles) {
    std::vector<Pin> pins;
    pins.reserve(particles.size());
    for (const std::uint32_t i : particles) {
        const Pin* const pinned = find_pin(i);
        pins.push_back(pinned != nullptr ? *pinned : Pin{i, xyz(state.positions[i])});
    }
    change_pins(std::move(pins));
}

void Cloth::change_pins(std::vector<Pin>&& pins) {
    const std::vector<std::uint32_t> now = particles_of(pins), before = particles_of(state.pins);
    if (now == before) return;
    for (const std::unique_ptr<Limit>& limit : limits) limit->prepare(model, now);
    solver->reserve_pins(pins.size());

    // From here on nothing can fail.
    for (const std::unique_ptr<Limit>& limit : limits) limit->commit();
    const auto set_inverse_mass = [&](std::uint32_t particle, float inverse_mass) {
        state.positions[particle].w = state.previous_positions[particle].w = inverse_mass;
        solver->inverse_mass_changed(particle, state.positions.span());
    };
    bool any_released = false;
    // Releases come first, so that never more particles are pinned than memory was reserved for.
    for (const std::uint32_t i : before) {
        if (std::ranges::binary_search(now, i)) continue;
        set_inverse_mass(i, inverse_mass_when_free(i));
        any_released = true;
    }
    for (const std::uint32_t i : now) {
        if (std::ranges::binary_search(before, i)) continue;
        state.velocities[i] = {};
        set_inverse_mass(i, 0);
    }
    state.pins = std::move(pins);
    wake();
    land();
    // A pin's motion says nothing about the free particle's: BDF2 would give it only a part of its weight.
    if (any_released) state.record.h = 0;
}

float Cloth::farthest_pin() const noexcept {
    float farthest = 0;
    for (const Pin& pin : state.pins)
        farthest = std::max(farthest, (pin.target - xyz(state.positions[pin.particle])).norm());
    return farthest;
}

void Cloth::prepare_restore(std::span<const Pin> pins) {
    const std::vector<std::uint32_t> particles = particles_of(pins);
    for (const std::unique_ptr<Limit>& limit : limits) limit->prepare(model, particles);
    solver->reserve_pins(pins.size());
}

void Cloth::commit_restore() {
    set_inverse_masses();
    for (const std::unique_ptr<Limit>& limit : limits) limit->commit();
    solver->inverse_masses_changed(state.positions.span());
    surface.forget();
}

}  // namespace weft
