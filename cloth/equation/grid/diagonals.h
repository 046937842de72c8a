#pragma once
// A grid's graph by diagonals (Y. Saad, "Iterative methods for sparse linear systems", 2003, 3.4): the later
// neighbours of all nodes are at the same few differences. Values that two neighbours share are stored once,
// at the first of them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cloth/equation/sparse/stencil.h"

namespace weft {

struct Diagonals {
    static constexpr std::uint32_t most = 8;

    Diagonals() = default;
    /// From compressed rows, like a Stencil. Empty if differences are many, if most nodes lack most of them,
    /// or if a large grid has so few rows that it gives threads too few tiles (see GridWindows).
    Diagonals(std::span<const std::uint32_t> offsets, std::span<const std::uint32_t> neighbours);

    std::uint32_t nodes = 0;
    std::uint32_t count = 0;
    std::array<std::uint32_t, most> differences{};  ///< ascending

    [[nodiscard]] bool empty() const noexcept { return count == 0; }
    [[nodiscard]] std::uint32_t groups() const noexcept {
        return (nodes + Stencil::lanes - 1) / Stencil::lanes;
    }
    /// The greatest difference between neighbours, rounded up to whole groups.
    [[nodiscard]] std::uint32_t reach() const noexcept {
        return empty() ? 0 : Stencil::whole_groups(differences[count - 1]);
    }
    /// Number of values, stored group by group and there diagonal by diagonal, 16 lanes each.
    [[nodiscard]] std::size_t entries() const noexcept {
        return std::size_t{groups()} * count * Stencil::lanes;
    }
    [[nodiscard]] std::uint32_t entry(std::uint32_t i, std::uint32_t diagonal) const noexcept {
        return (i / Stencil::lanes * count + diagonal) * Stencil::lanes + i % Stencil::lanes;
    }
    /// Precondition: the nodes are neighbours, first < second.
    [[nodiscard]] std::uint32_t entry_between(std::uint32_t first, std::uint32_t second) const noexcept;
};

}  // namespace weft
