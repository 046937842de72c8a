#pragma once
// What of a cloth's levels is constant, as bytes and back: reading it takes a tenth of the time of making it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cloth/solvers/make_system.h"
#include "cloth/solvers/multigrid/galerkin.h"
#include "cloth/system/sparse/interpolation.h"
#include "engine/memory/shared_buffer.h"

namespace weft {

/// Lists as Multigrid and CoarseLevel have them, but for those that follow from others.
struct SavedLevels {
    struct Level {
        GalerkinLists lists;          ///< without sums
        Interpolation interpolation;  ///< perhaps without its transpose
    };

    SystemKind kind{ClothSettings()};  ///< of the system that they were made for
    SharedBuffer<std::uint32_t> slots;
    SharedBuffer<Link> constant_links;
    SharedBuffer<float> constant_weights;
    std::vector<Level> levels;  ///< the finest first
};

/// How many bytes write() writes: a multiple of 8.
[[nodiscard]] std::size_t written_size(const SavedLevels& levels);
void write(const SavedLevels& levels, std::span<std::byte> to);
/// Nothing: these are not all the bytes that write() wrote. The lists may hold anything.
[[nodiscard]] std::optional<SavedLevels> read_levels(std::span<const std::byte> bytes);

/// Whether they name only what there is, in a system of so many particles and entries.
[[nodiscard]] bool fit(const SavedLevels& levels, std::uint32_t particles, std::size_t entries);

}  // namespace weft
