#pragma once
// Runs a scene and measures its steps.

#include "demo/profile/hardware_counters.h"
#include "demo/profile/profile_options.h"
#include "demo/profile/stage_table.h"

namespace weft::demo {

/// Builds the scene, with copies of its first cloth up to the options' number of cloths. A copy has the same
/// mesh, settings and pins; its pins do not move. Error: the scene cannot be built.
[[nodiscard]] Result<Simulation> build_simulation(const ProfileOptions& options);

/// Runs the warm-up, then the frames. Adds their times to `table` and, where available, their counts to
/// `counts`. The counters must be older than the first simulation, since oneTBB keeps its threads.
[[nodiscard]] Result<Measured> measure(const ProfileOptions& options, const HardwareCounters& counters,
                                       StageTable& table, std::optional<HardwareCounters::Counts>& counts);

/// Runs some frames and writes their trace. Error: the file cannot be written.
[[nodiscard]] Result<void> trace(const ProfileOptions& options);

}  // namespace weft::demo
