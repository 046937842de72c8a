#include "cloth/simulation.h"

#include <algorithm>
#include <thread>

namespace weft {

namespace {

Parallel make_parallel(const WorldSettings& settings) {
    if (settings.executor.run != nullptr) return Parallel(settings.executor);
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return Parallel(settings.threads > 0 ? settings.threads : std::clamp(cores, 1, 256));
}

}  // namespace

Simulation::Simulation(const WorldSettings& initial)
    : settings(initial), parallel(make_parallel(initial)), profiler(stage_names) {}

void Simulation::apply(const WorldSettings& changed) {
    const bool other_threads =
        changed.threads != settings.threads || changed.executor.run != settings.executor.run ||
        changed.executor.user != settings.executor.user || changed.executor.width != settings.executor.width;
    if (other_threads) parallel = make_parallel(changed);
    settings = changed;
}

}  // namespace weft
