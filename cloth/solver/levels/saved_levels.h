#pragma once
// The constant part of a multilevel solver, to bytes and back: lists are used in place.

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

/// The constant lists of the solver's parts.
struct SavedLevels {
    SystemKind kind{ClothSettings()};  ///< of the system that they were made for
    SharedBuffer<std::uint32_t> slots;
    SharedBuffer<double> constants;  ///< of the first level by place, see CoarseLinks; without pins
    SharedBuffer<float> shifts;
    std::vector<CoarseLevel::Constants> levels;  ///< the finest first
    std::optional<SavedSprings> springs;         ///< the system, if it is of springs
};

void visit_lists(const SavedLevels& levels, PackedSize& size);
void visit_lists(const SavedLevels& levels, PackedWriter& writer);
/// Returns nothing if bytes are missing or indices are out of range. Lists of finite elements are not
/// checked. Precondition: the indices in the model's lists are in range.
[[nodiscard]] std::optional<SavedLevels> read_levels(PackedReader& reader, const ClothModel& model);

/// Whether all indices are in range, in a system of so many particles and entries.
[[nodiscard]] bool fit(const SavedLevels& levels, std::uint32_t particles, std::size_t entries);

}  // namespace weft
