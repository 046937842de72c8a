#pragma once
// Runs a scene and measures its steps.

#include "demo/profile/hardware_counters.h"
#include "demo/profile/profile_options.h"
#include "demo/profile/stage_table.h"

namespace weft::demo {

/// The scene, with copies of its first cloth until there are as many cloths as the options ask for. A copy
/// has the same mesh, settings and pins, and those stay where they are. Error: it cannot be built.
[[nodiscard]] Result<Simulation> build_simulation(const ProfileOptions& options);

/// One run: the warm-up, then the frames, whose times go into `table` and, where they can be had, whose
/// counts are added to `counts`. The counters must be older than the first simulation: oneTBB keeps its
/// threads.
[[nodiscard]] Result<Measured> measure(const ProfileOptions& options, const HardwareCounters& counters,
                                       StageTable& table, std::optional<HardwareCounters::Counts>& counts);

/// A run of some frames that is traced. Error: the file cannot be written.
[[nodiscard]] Result<void> trace(const ProfileOptions& options);

}  // namespace weft::demo
