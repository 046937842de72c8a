#pragma once
// Cells of points, and buckets of cells in the hashed table.

#include <array>
#include <cstdint>

#include "weft/types.h"

namespace weft {

/// Odd multipliers spread neighbouring cells, the finaliser mixes their bits: a linear hash would put the
/// rows of a folded sheet on top of one another.
struct CellHash {
    static constexpr std::uint32_t x = 0xC2B2AE3Du, y = 0x9E3779B1u, z = 0x85EBCA77u;

    static std::uint32_t mix(std::uint32_t bits) noexcept {
        bits = (bits ^ (bits >> 15)) * 0x2C1B3C6Du;
        return bits ^ (bits >> 13);
    }
    static std::uint32_t row(std::uint32_t cell_y, std::uint32_t cell_z) noexcept {
        return mix(cell_y * y ^ cell_z * z);
    }
};

/// The lattice of cells, and buckets of points. `cells-inl.h` computes the same in lanes, to the last bit.
struct Cells {
    static constexpr float limit = 4194304.0f;  // 2^22: exact as a float, far from overflow as an int

    Vec3 origin;
    float per_metre = 0;
    float shift = 0;
    std::uint32_t mask = 0;  // buckets - 1

    /// The cell along one axis, counted from zero and never above 2^22, whatever the coordinate.
    [[nodiscard]] std::uint32_t at(float coordinate, float from) const noexcept {
        const float cell = (coordinate - from) * per_metre + shift;
        return static_cast<std::uint32_t>(
            static_cast<std::int32_t>(cell > 0 ? (cell < limit ? cell : limit) : 0));
    }

    /// Rows: a cell is one edge along x and two along y and z; its bucket is (x + H(y, z)) mod the number of
    /// buckets. Hence a cell and its two neighbours along x are one run of three buckets, and along y and z
    /// only the neighbour on the side of the point's half of its cell can be within an edge: four runs in
    /// all, named by their first buckets, the point's own row first.
    [[nodiscard]] std::array<std::uint32_t, 4> runs_near(float x, float y, float z) const noexcept {
        const std::uint32_t left = at(x, origin.x) - 1;
        const std::uint32_t half_y = at(y, origin.y), half_z = at(z, origin.z);
        const std::uint32_t own_y = half_y >> 1, own_z = half_z >> 1;
        const std::uint32_t other_y = own_y - 1 + 2 * (half_y & 1), other_z = own_z - 1 + 2 * (half_z & 1);
        return {(left + CellHash::row(own_y, own_z)) & mask, (left + CellHash::row(other_y, own_z)) & mask,
                (left + CellHash::row(own_y, other_z)) & mask,
                (left + CellHash::row(other_y, other_z)) & mask};
    }

    /// Cubes: one edge along each axis.
    [[nodiscard]] std::uint32_t cube_bucket(float x, float y, float z) const noexcept {
        const std::uint32_t row = CellHash::row(at(y, origin.y), at(z, origin.z));
        return CellHash::mix(at(x, origin.x) * CellHash::x ^ row) & mask;
    }
};

}  // namespace weft
