#pragma once
// A grid's graph by diagonals (Y. Saad, "Iterative methods for sparse linear systems", 2003, 3.4): the later
// neighbours of all nodes are at the same few differences. What two neighbours share is kept once, at the
// first of them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cloth/equation/sparse/stencil.h"

namespace weft {

struct Diagonals {
    static constexpr std::uint32_t most = 8;

    Diagonals() = default;
    /// From compressed rows, as a Stencil. Empty where differences are many, or most nodes lack most of them,
    /// or a large grid is so few rows that tiles of several of them (see GridWindows) are too few for
    /// threads.
    Diagonals(std::span<const std::uint32_t> offsets, std::span<const std::uint32_t> neighbours);

    std::uint32_t nodes = 0;
    std::uint32_t count = 0;
    std::array<std::uint32_t, most> differences{};  ///< ascending

    [[nodiscard]] bool empty() const noexcept { return count == 0; }
    [[nodiscard]] std::uint32_t groups() const noexcept {
        return (nodes + Stencil::lanes - 1) / Stencil::lanes;
    }
    /// How far apart neighbours are at most, in whole groups.
    [[nodiscard]] std::uint32_t reach() const noexcept {
        return empty() ? 0 : Stencil::whole_groups(differences[count - 1]);
    }
    /// Of values stored group by group, and in it diagonal by diagonal, 16 lanes each.
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
