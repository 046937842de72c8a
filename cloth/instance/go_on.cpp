// A cloth that continues from the state of another one: see World::recut_cloth.

#include <algorithm>
#include <utility>

#include "cloth/instance/cloth.h"

namespace weft {

namespace {

using Sources = std::span<const std::uint32_t>;

/// Copies each source's element; does nothing if either cloth has no such list.
template <class T>
void gather(const AlignedBuffer<T>& from, Sources sources, AlignedBuffer<T>& to) {
    if (from.size() == 0 || to.size() != sources.size()) return;
    for (std::size_t i = 0; i < sources.size(); ++i) to[i] = from[sources[i]];
}

template <class T>
AlignedBuffer<T> gathered(std::span<const T> from, Sources sources) {
    AlignedBuffer<T> to(from.empty() ? 0 : sources.size());
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[sources[i]];
    return to;
}

/// Whether both are the same cloth, particle by particle.
bool are_the_same(const ClothModel& a, const ClothModel& b, Sources sources) {
    if (a.fingerprint != b.fingerprint || a.particle_count != b.particle_count) return false;
    for (std::uint32_t i = 0; i < sources.size(); ++i)
        if (sources[i] != i) return false;
    return true;
}

void gather_skin(const SkinState& from, Sources sources, SkinState& to) {
    gather(from.places, sources, to.places);
    gather(from.target_places, sources, to.target_places);
    gather(from.normals, sources, to.normals);
    gather(from.target_normals, sources, to.target_normals);
    to.known = from.known;
}

}  // namespace

// A particle whose area without map is unchanged keeps its area with map, to the last bit.
void Cloth::take_areas(const Cloth& before, Sources sources) {
    if (before.areas_without_map.size() == 0) return;
    SharedBuffer<float> areas(std::as_const(model.rest_area).span());
    AlignedBuffer<float> without_map(model.particle_count);
    std::ranges::copy(std::as_const(model.rest_area).span(), without_map.data());
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const float with = before.model.rest_area[sources[i]], without = before.areas_without_map[sources[i]];
        if (areas[i] == without)
            areas[i] = with;
        else if (without > 0)
            areas[i] *= with / without;
    }
    set_areas(std::move(areas), std::move(without_map), {});
}

void Cloth::take_maps(const Cloth& before, Sources sources) {
    take_areas(before, sources);
    if (before.model.stiffness.size() > 0)
        set_stiffness(gathered(before.model.stiffness.span(), sources), {});
    const std::pair<Map, const AlignedBuffer<float>*> maps[] = {
        {Map::leash, &before.worn.leash},
        {Map::backstop, &before.worn.backstop},
        {Map::backstop_radius, &before.worn.backstop_radius},
        {Map::friction, &before.side_buffers.friction_map},
        {Map::thickness, &before.side_buffers.thickness_map},
        {Map::collider_mask, &before.side_buffers.masks}};
    for (const auto& [map, values] : maps)
        if (values->size() > 0) set_worn_map(map, gathered(values->span(), sources));
}

void Cloth::take_pins(const Cloth& before, Sources sources) {
    std::vector<Pin> pins;
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        const auto at = std::ranges::lower_bound(before.state.pins, sources[i], {}, &Pin::particle);
        if (at != before.state.pins.end() && at->particle == sources[i]) pins.push_back({i, at->target});
    }
    prepare_restore(pins);
    state.pins = std::move(pins);
}

void Cloth::take_contact(const ClothState& before, Sources sources) {
    if (before.held.normals.size() > 0 && state.held.normals.size() > 0) {
        gather(before.held.normals, sources, state.held.normals);
        gather(before.held.rubbed, sources, state.held.rubbed);
        gather(before.held.loads, sources, state.held.loads);
        for (std::uint32_t i = 0; i < sources.size(); ++i)
            state.held.touching[i / Stencil::lanes] |= before.held.touching[sources[i] / Stencil::lanes];
    }
    gather(before.tangles, sources, state.tangles);
    state.halved = before.halved;
}

void Cloth::take_rest(const Cloth& before, bool is_split) {
    if (state.rest && before.state.rest && !is_split) state.rest = before.state.rest;
    if (!budgeted || !before.budgeted) return;
    *budgeted = *before.budgeted;
    state.detail = before.state.detail;
    if (is_split) land();
}

void Cloth::go_on_from(const Cloth& before, Sources sources, std::size_t colliders) {
    if (before.state.frame) seen_colliders.reserve(colliders);
    attached.reserve(before.attached.size());
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        const auto at = std::ranges::lower_bound(before.attached, sources[i], {}, &Attachment::particle);
        if (at == before.attached.end() || at->particle != sources[i]) continue;
        attached.push_back(*at);
        attached.back().particle = i;
    }
    take_pins(before, sources);

    const bool is_same = are_the_same(model, before.model, sources);
    gather(before.state.positions, sources, state.positions);
    gather(before.state.previous_positions, sources, state.previous_positions);
    gather(before.state.velocities, sources, state.velocities);
    set_inverse_masses();
    state.record.h = before.state.record.h;
    gather(before.state.record.displacements, sources, state.record.displacements);
    gather(before.state.record.velocity_changes, sources, state.record.velocity_changes);
    gather(before.state.record.arrivals, sources, state.record.arrivals);
    state.shares = before.state.shares;
    state.frame = before.state.frame;
    gather_skin(before.state.skin, sources, state.skin);
    gather(before.state.ahead, sources, state.ahead);
    take_contact(before.state, sources);
    take_rest(before, !is_same);
    if (!has_features()) return;
    state.may_cross = is_same ? before.state.may_cross : 1;
    if (!is_same) part_copies(sources);
}

// Moves copies of a particle apart, into their triangles: contact cannot tell on which side coincident
// features belong, and would hold them still.
void Cloth::part_copies(Sources sources) {
    const float way = 2 * as_body().floor;
    std::vector<std::uint32_t> counts(sources.empty() ? 0 : std::ranges::max(sources) + 1);
    for (const std::uint32_t source : sources) ++counts[source];
    std::vector<std::pair<std::uint32_t, Vector3>> moves;
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        if (counts[sources[i]] < 2) continue;
        Vector3 inwards = Vector3::Zero();
        for (std::uint32_t k = model.corner_offsets[i]; k < model.corner_offsets[i + 1]; ++k)
            for (const std::uint32_t corner : model.triangles[model.corner_triangles[k]])
                inwards += xyz(state.positions[corner]) - xyz(state.positions[i]);
        if (const float length = inwards.norm(); length > 0) moves.emplace_back(i, way / length * inwards);
    }
    for (const auto& [i, move] : moves) {
        const Vector3 there = xyz(state.positions[i]) + move;
        if (state.record.arrivals.size() > 0 && xyz(state.record.arrivals[i]) == xyz(state.positions[i]))
            set_xyz(state.record.arrivals[i], there);
        set_xyz(state.positions[i], there);
        set_xyz(state.previous_positions[i], xyz(state.previous_positions[i]) + move);
        if (Pin* const pin = find_pin(i)) pin->target += move;
    }
}

}  // namespace weft
