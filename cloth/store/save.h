#pragma once
// The state of a World, or of one cloth, as bytes in the host's memory, and back: see World::save.

#include <cstddef>
#include <cstdint>
#include <span>

#include "weft/error.h"

namespace weft {

struct Cloth;
struct Simulation;

[[nodiscard]] std::size_t save_size(const Simulation& simulation);
Result<void> save(const Simulation& simulation, std::span<std::byte> to);
/// May run out of memory, too; then nothing has changed. So may all that follow.
Result<void> restore(Simulation& simulation, std::span<const std::byte> saved);
/// Restores the cloths that have the keys of cloths here; returns their number.
Result<std::uint32_t> restore_cloths(Simulation& simulation, std::span<const std::byte> saved);

[[nodiscard]] std::size_t save_size(const Cloth& cloth);
Result<void> save_cloth(const Cloth& cloth, std::span<std::byte> to);
Result<void> restore_cloth(Simulation& simulation, Cloth& cloth, std::span<const std::byte> saved);

}  // namespace weft
