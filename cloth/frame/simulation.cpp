#include "cloth/frame/simulation.h"

#include <algorithm>
#include <thread>

namespace weft {

namespace {

bool has_gusts(const Wind& wind) {
    return wind.gust > 0;
}

Parallel make_parallel(const WorldSettings& settings) {
    if (settings.executor.run != nullptr) return Parallel(settings.executor);
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return Parallel(settings.threads > 0 ? settings.threads : std::clamp(cores, 1, 256));
}

}  // namespace

Simulation::Simulation(const WorldSettings& initial)
    : settings(initial), parallel(make_parallel(initial)), profiler(stage_names) {
    parallel.trace_to(&profiler.trace());
    reserve_motions(0);
}

void Simulation::apply(const WorldSettings& changed) {
    const bool other_threads =
        changed.threads != settings.threads || changed.executor.run != settings.executor.run ||
        changed.executor.user != settings.executor.user || changed.executor.width != settings.executor.width;
    if (other_threads) {
        parallel = make_parallel(changed);
        parallel.trace_to(&profiler.trace());
        reserve_motions(colliders.size());
    }
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        cloth->set_air(changed.wind.air_density > 0, has_gusts(changed.wind));
    });
    settings = changed;
}

void Simulation::expect_colliders(std::size_t count) {
    reserve_motions(count);
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) { cloth->set_colliders(count > 0); });
}

void Simulation::reserve_motions(std::size_t count) {
    motions_.resize(static_cast<std::size_t>(parallel.width()));
    for (std::vector<ColliderMotion>& motions : motions_) motions.reserve(count);
}

void Simulation::prepare(Cloth& cloth) {
    cloth.set_air(air_is_on(), has_gusts(settings.wind));
    cloth.set_colliders(colliders.size() > 0);
    cloth.extent = survey(parallel, cloth.state, cloth.partial_surveys.span());
    update_normals(parallel, cloth);
}

void Simulation::update_normals(Parallel& loops, Cloth& cloth) {
    cloth.surface.compute_normals(loops, cloth.state.positions.span(), cloth.state.normals.span());
}

}  // namespace weft
