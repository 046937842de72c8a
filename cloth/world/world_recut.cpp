// The World's calls for cloth that is cut.

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "cloth/mesh/cooking/log_repairs.h"
#include "cloth/mesh/model_totals.h"
#include "cloth/record/world_calls.h"
#include "cloth/simulation/sewn.h"
#include "engine/error_text.h"
#include "engine/memory/hooks.h"

namespace weft {

namespace {

/// For each particle of `next`, the cloth's particle that it comes from.
Result<std::vector<std::uint32_t>> sources_of(const Cloth& cloth, const ClothModel& next,
                                              std::span<const std::uint32_t> from) {
    const std::span<const std::uint32_t> particles = next.vertex_to_particle.span();
    if (from.size() != particles.size())
        return Error{ErrorCode::invalid_argument,
                     "`from` has " + std::to_string(from.size()) + " vertices, the mesh " +
                         std::to_string(particles.size()) + "; give one for each"};
    std::vector<std::uint32_t> sources(next.particle_count), firsts(next.particle_count, ~0u);
    for (std::uint32_t v = 0; v < from.size(); ++v) {
        const auto source = particle_of(cloth, from[v]);
        if (!source)
            return Error{ErrorCode::invalid_argument,
                         "from[" + std::to_string(v) + "]: " + source.error().message};
        const std::uint32_t particle = particles[v];
        if (firsts[particle] == ~0u) {
            firsts[particle] = v;
            sources[particle] = *source;
        } else if (sources[particle] != *source) {
            return Error{ErrorCode::invalid_argument, "vertices " + std::to_string(firsts[particle]) +
                                                          " and " + std::to_string(v) +
                                                          " are one particle, but come from vertices " +
                                                          std::to_string(from[firsts[particle]]) + " and " +
                                                          std::to_string(from[v]) + ", which are two"};
        }
    }
    return sources;
}

/// The seam of a cloth that is cut; sources: by new particle, its old one. Each stitch stays at the first
/// particle that comes from its own, and ends where none does.
SeamState after_cut(const SeamState& seam, ClothId cut, std::span<const std::uint32_t> sources) {
    SeamState next{.settings = seam.settings, .cloths = seam.cloths, .stitches = {}, .holds = {}};
    for (std::size_t k = 0; k < seam.stitches.size(); ++k) {
        Stitch stitch = seam.stitches[k];
        bool is_there = true;
        for (std::size_t side = 0; side < 2; ++side) {
            if (seam.cloths[side] != cut) continue;
            const auto at = std::ranges::find(sources, stitch.particles[side]);
            is_there = is_there && at != sources.end();
            stitch.particles[side] = static_cast<std::uint32_t>(at - sources.begin());
        }
        if (!is_there) continue;
        next.stitches.push_back(stitch);
        next.holds.push_back(seam.holds[k]);
    }
    return next;
}

/// Edges with more than this strain, by particles, each once.
std::vector<StrainedEdge> edges_beyond(const Cloth& cloth, float strain) {
    std::vector<StrainedEdge> edges;
    const ClothModel& model = cloth.model;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            if (j < i || model.kinds[e] != SpringKind::structural) continue;
            const float length = (xyz(cloth.state.positions[j]) - xyz(cloth.state.positions[i])).norm();
            const float present = length / model.rest_lengths[e] - 1;
            if (present > strain) edges.push_back({i, j, present});
        }
    }
    return edges;
}

/// Replaces particles by the first of the mesh's vertices that they are.
void name_by_vertices(const Cloth& cloth, std::span<StrainedEdge> edges) {
    const std::span<const std::uint32_t> particles = cloth.model.vertex_to_particle.span();
    std::vector<std::uint32_t> first(cloth.model.particle_count);
    for (auto v = static_cast<std::uint32_t>(particles.size()); v-- > 0;) first[particles[v]] = v;
    for (StrainedEdge& edge : edges) {
        edge.a = first[edge.a];
        edge.b = first[edge.b];
    }
}

}  // namespace

void Simulation::replace(ClothId id, std::unique_ptr<Cloth>&& next) {
    std::unique_ptr<Cloth>& place = *cloths.find(id);
    const Newcomer newcomer{place.get(), next->scratch_bytes, next->settings.self_collision,
                            next->contact_mesh.get(), !next->seams.empty()};
    Room room = make_room({&newcomer, 1}, parallel.width());

    // From here on nothing can fail.
    drop_level(*place);
    if (next->model.fingerprint != place->model.fingerprint) wake_near(*place);
    next->id = place->id;
    update_normals(parallel, *next);
    place = std::move(next);
    *views[id.index] = {};
    take(std::move(room));
}

Result<void> World::recut_cloth(ClothId id, const Mesh& mesh, std::span<const std::uint32_t> from) {
    return impl_->change(Call::recut_cloth, id, mesh, from)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            Simulation& simulation = impl_->simulation;
            auto model = cook(mesh, cloth.settings.fabric.bending_ratio);
            if (!model) return model.error();
            const auto sources = sources_of(cloth, *model, from);
            if (!sources) return sources.error();
            if (auto valid = validate_neighbours(*model, cloth.settings); !valid) return valid.error();
            const ClothInfo info = model->info;
            ClothSettings settings = cloth.settings;
            const bool bursts = settings.filling.kind != FillingKind::none && open_edges(info) > 0;
            if (bursts) settings.filling = {};
            if (auto valid = validate_filling(*model, settings); !valid) return valid.error();
            auto next = std::make_unique<Cloth>(std::move(model).value(), settings);
            next->take_maps(cloth, *sources);
            next->take_seams(next->make_seams(std::vector(cloth.seams)));
            std::vector<std::pair<SeamId, SeamState>> seams;
            for (const SeamRows* rows : cloth.seams)
                seams.emplace_back(rows->id(),
                                   after_cut(*simulation.state.seams.find(rows->id()), id, *sources));
            simulation.prepare(*next);
            next->go_on_from(cloth, *sources, simulation.state.colliders.size());
            simulation.state_has_changed(*next);
            const Sewn sewn = sew(simulation, id, {.moved = seams, .cut = {id, next.get()}});
            simulation.replace(id, std::move(next));
            sewn.give_to(simulation);
            for (auto& [seam, state] : seams) *simulation.state.seams.find(seam) = std::move(state);
            log_repairs(info);
            if (bursts)
                log_line(LogLevel::warning, "a cloth has burst: its mesh has %u open edges",
                         open_edges(info));
            return {};
        });
    });
}

Result<std::uint32_t> World::strained_edges(ClothId id, float strain, std::span<StrainedEdge> to) const {
    return impl_->read("strained_edges", [&] {
        return with_cloth(impl_->simulation, id, [&](const Cloth& cloth) -> Result<std::uint32_t> {
            if (!(strain >= -1))
                return out_of_range("strain", static_cast<double>(strain), "a number from -1");
            std::vector<StrainedEdge> edges = edges_beyond(cloth, strain);
            const std::size_t count = std::min(edges.size(), to.size());
            const auto before = [](const StrainedEdge& p, const StrainedEdge& q) {
                return std::tie(q.strain, p.a, p.b) < std::tie(p.strain, q.a, q.b);
            };
            std::ranges::partial_sort(edges, edges.begin() + static_cast<std::ptrdiff_t>(count), before);
            edges.resize(count);
            name_by_vertices(cloth, edges);
            std::ranges::copy(edges, to.begin());
            return static_cast<std::uint32_t>(count);
        });
    });
}

}  // namespace weft
