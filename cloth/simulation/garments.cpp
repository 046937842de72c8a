// Garments of several meshes: which of them is stepped, and how one takes over from another.

#include <algorithm>
#include <utility>

#include "cloth/simulation/simulation.h"

namespace weft {

namespace {

Cloth& cloth_of(Simulation& world, ClothId id) {
    return **world.cloths.find(id);
}

ClothView surface_of(const Cloth& cloth) {
    const ClothState& now = cloth.state;
    return {.positions = now.positions.span(),
            .previous_positions = now.previous_positions.span(),
            .velocities = now.velocities.span(),
            .normals = now.normals.span(),
            .triangles = cloth.model.triangles.span()};
}

/// Binds the vertices of `cloth` to the surface of another.
Result<DrawnMesh> bind(const Cloth& to, const Cloth& cloth, float reach) {
    const std::span<const std::uint32_t> particles = cloth.model.vertex_to_particle;
    std::vector<Vec3> vertices, normals;
    vertices.reserve(particles.size());
    normals.reserve(particles.size());
    for (const std::uint32_t i : particles) {
        vertices.push_back(to_vec3(xyz(cloth.state.positions[i])));
        normals.push_back(to_vec3(xyz(cloth.state.normals[i])));
    }
    return DrawnMesh::bind(surface_of(to), {.vertices = vertices, .normals = normals}, {.reach = reach});
}

/// Carries BDF2's record, so that the step after is second order, too. Backward Euler in its place would take
/// a fiftieth of a swing's energy.
void carry_record(const ClothState& from, const DrawnMesh& bonds, Cloth& to) {
    StepRecord& record = to.state.record;
    if (from.record.h == 0 || record.displacements.size() == 0) return;
    record.h = from.record.h;
    for (std::size_t v = 0; v < bonds.size(); ++v) {
        const DrawnBond& bond = bonds.bonds()[v];
        const std::uint32_t i = to.model.vertex_to_particle[v];
        set_xyz(record.displacements[i], interpolated(bond, from.record.displacements));
        set_xyz(record.velocity_changes[i], interpolated(bond, from.record.velocity_changes));
        record.arrivals[i] = to.state.positions[i];
    }
}

/// The host moves pins, skin and frame of all levels alike, so that `to` has its own already.
void take_over(Simulation& world, Garment& garment, Cloth& from, Cloth& to, const DrawnMesh& bonds,
               std::uint32_t rung) {
    garment.carried.carry(surface_of(from), bonds);
    to.set_enabled(from.settings.enabled);
    world.resume(to, garment.carried.positions, garment.carried.previous_positions,
                 garment.carried.velocities, StillPins::stay);
    if (from.state.frame && to.state.frame) {
        to.state.frame->velocity = from.state.frame->velocity;
        to.state.frame->velocity_change = from.state.frame->velocity_change;
    }
    from.land();  // amid a long step there is no record to go on from
    carry_record(from.state, bonds, to);
    from.set_enabled(false);
    if (!to.state.detail) return;
    *to.state.detail = {};
    to.state.detail->go_to(rung, static_cast<std::uint32_t>(world.state.steps));
}

}  // namespace

Result<void> Simulation::add_level(ClothId finest, ClothId coarser, float reach) {
    Cloth &first = cloth_of(*this, finest), &added = cloth_of(*this, coarser);
    const bool is_new = first.garment == no_garment;
    const ClothId before = is_new ? finest : garments[first.garment].levels.back();
    auto to_added = bind(cloth_of(*this, before), added, reach);
    if (!to_added) return to_added.error();
    auto from_added = bind(added, cloth_of(*this, before), reach);
    if (!from_added) return from_added.error();
    garments.reserve(garments.size() + 1);
    state.levels.reserve(garments.size() + 1);
    Garment made;
    Garment& garment = is_new ? made : garments[first.garment];
    garment.levels.reserve(most_garment_levels);
    garment.coarser.reserve(most_garment_levels);
    garment.finer.reserve(most_garment_levels);
    garment.carried.reserve(
        std::max(first.model.vertex_to_particle.size(), added.model.vertex_to_particle.size()));

    // From here on nothing can fail.
    if (is_new) garment.levels.push_back(finest);
    garment.levels.push_back(coarser);
    garment.coarser.push_back(*std::move(to_added));
    garment.finer.push_back(*std::move(from_added));
    if (is_new) {
        first.garment = static_cast<std::uint32_t>(garments.size());
        garments.push_back(std::move(made));
        state.levels.push_back(0);
    }
    added.garment = first.garment;
    added.level = static_cast<std::uint32_t>(garments[first.garment].levels.size() - 1);
    added.set_enabled(false);
    return {};
}

void Simulation::drop_level(Cloth& cloth) noexcept {
    const std::uint32_t g = cloth.garment;
    if (g == no_garment) return;
    Garment& garment = garments[g];
    const std::size_t left = cloth.level < 2 ? 0 : cloth.level;
    for (std::size_t k = left; k < garment.levels.size(); ++k) {
        Cloth& gone = cloth_of(*this, garment.levels[k]);
        gone.garment = no_garment;
        gone.level = 0;
    }
    const auto from = static_cast<std::ptrdiff_t>(left);
    if (left > 0) {
        garment.levels.erase(garment.levels.begin() + from, garment.levels.end());
        garment.coarser.erase(garment.coarser.begin() + from - 1, garment.coarser.end());
        garment.finer.erase(garment.finer.begin() + from - 1, garment.finer.end());
        const auto last = static_cast<std::uint32_t>(left - 1);
        state.levels[g] = std::min(state.levels[g], last);
        garment.least = std::min(garment.least, last);
        return;
    }
    garments.erase(garments.begin() + g);
    state.levels.erase(state.levels.begin() + g);
    for (std::uint32_t later = g; later < garments.size(); ++later)
        for (const ClothId id : garments[later].levels) cloth_of(*this, id).garment = later;
}

void Simulation::set_level(Garment& garment, std::uint32_t level, std::uint32_t rung) {
    const Cloth& finest = cloth_of(*this, garment.levels.front());
    for (std::uint32_t& now = state.levels[finest.garment]; now != level;) {
        const std::uint32_t next = level > now ? now + 1 : now - 1;
        const DrawnMesh& bonds = level > now ? garment.coarser[now] : garment.finer[next];
        take_over(*this, garment, cloth_of(*this, garment.levels[now]), cloth_of(*this, garment.levels[next]),
                  bonds, rung);
        now = next;
    }
}

void Simulation::refine_from(const Cloth& cloth) {
    if (cloth.level > 0 && state.levels[cloth.garment] == cloth.level)
        parallel.lend([&] { set_level(garments[cloth.garment], cloth.level - 1, 0); });
}

void Simulation::take_chosen_levels() {
    for (Garment& garment : garments)
        if (const auto next = std::exchange(garment.next, std::nullopt))
            parallel.lend([&] { set_level(garment, next->level, next->rung); });
}

void Simulation::enable_restored_levels() noexcept {
    for (std::size_t g = 0; g < garments.size(); ++g) {
        const std::vector<ClothId>& levels = garments[g].levels;
        const bool on =
            std::ranges::any_of(levels, [&](ClothId id) { return cloth_of(*this, id).settings.enabled; });
        for (std::size_t k = 0; k < levels.size(); ++k)
            cloth_of(*this, levels[k]).settings.enabled = on && k == state.levels[g];
    }
}

}  // namespace weft
