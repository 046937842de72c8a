#pragma once
// A World's state as bytes in the host's memory, and back: see World::save.

#include <cstddef>
#include <span>

#include "weft/error.h"

namespace weft {

struct Simulation;

[[nodiscard]] std::size_t save_size(const Simulation& simulation);
Result<void> save(const Simulation& simulation, std::span<std::byte> to);
/// May run out of memory, too; then nothing has changed.
Result<void> restore(Simulation& simulation, std::span<const std::byte> saved);

}  // namespace weft
