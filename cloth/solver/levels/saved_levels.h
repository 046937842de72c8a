#pragma once
// What of a multilevel solver is constant, as bytes and back: it is used where it lies.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "cloth/fabric/spring_system.h"
#include "cloth/mesh/cook.h"
#include "cloth/solver/levels/coarse_level.h"
#include "cloth/solver/make_system.h"
#include "engine/memory/packed_lists.h"
#include "engine/memory/shared_buffer.h"

namespace weft {

/// Lists as the solver's parts have them.
struct SavedLevels {
    SystemKind kind{ClothSettings()};  ///< of the system that they were made for
    SharedBuffer<std::uint32_t> slots;
    SharedBuffer<Link> constant_links;
    SharedBuffer<float> constant_weights;
    SharedBuffer<float> constant_sums;           ///< where nothing is pinned; empty: to be found
    std::vector<CoarseLevel::Constants> levels;  ///< the finest first
    std::optional<SavedSprings> springs;         ///< the system, if it is of springs
};

void visit_lists(const SavedLevels& levels, PackedSize& size);
void visit_lists(const SavedLevels& levels, PackedWriter& writer);
/// Nothing: bytes are missing, or lists name what there is not. Those of elements may hold anything.
/// Precondition: the model's lists name only what there is.
[[nodiscard]] std::optional<SavedLevels> read_levels(PackedReader& reader, const ClothModel& model);

/// Whether they name only what there is, in a system of so many particles and entries.
[[nodiscard]] bool fit(const SavedLevels& levels, std::uint32_t particles, std::size_t entries);

}  // namespace weft
