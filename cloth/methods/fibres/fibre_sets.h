#pragma once
// Fibres and sets, made from any mesh's springs when a cloth gets its solver.
//
// A fibre is a chain of springs of one kind, each the straightest continuation of the one before. Invariants:
// every spring belongs to exactly one fibre; a fibre visits no particle twice (a ring is cut); no two fibres
// of a set share a particle. So the fibres of a set may be solved in any order, by any threads.

#include <array>
#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"
#include "engine/memory/aligned_buffer.h"

namespace weft {

enum class FibreKind : std::uint8_t { vertical, horizontal, shear };

struct Fibre {
    FibreKind kind;
    SpringKind springs;
    std::vector<std::uint32_t> particles;   ///< one more than springs
    std::vector<std::uint32_t> half_edges;  ///< the springs' half-edges in the model
};

/// Finds the fibres: on a grid, rows, columns and diagonals. Structural fibres are vertical if they run
/// further up or down than across, as the cloth starts; up is +z for level cloth. Diagonals are shear.
[[nodiscard]] std::vector<Fibre> find_fibres(const ClothModel& model);

/// A set's groups [groups_begin, groups_end), in blocks of about equal work.
struct FibreSet {
    FibreKind kind;
    std::uint32_t groups_begin, groups_end;
    std::vector<std::uint32_t> blocks;  ///< groups of block b: [blocks[b], blocks[b + 1])
};

/// The sets, in the order in which they are solved: the fibres that carry weight come last, because the last
/// correction holds. Fibres lie side by side in groups of 16 lanes, the longest first. Group g has springs in
/// rows [rows[g], rows[g + 1]) and particles in rows [rows[g] + g, rows[g + 1] + g + 1). A fibre that is
/// shorter than its group is filled up with a stand-in behind the cloth's last particle, and with rest
/// lengths `no_spring`.
struct FibreSets {
    static constexpr std::uint32_t lanes = 16;
    static constexpr float no_spring = -1;

    std::vector<FibreSet> sets;
    std::vector<std::uint32_t> rows;
    AlignedBuffer<std::uint32_t> particles;  ///< [row * lanes + lane]
    AlignedBuffer<float> rest_lengths;       ///< [m], likewise
    /// Each spring's half-edge in the model, likewise; any value where there is no spring.
    AlignedBuffer<std::uint32_t> half_edges;
    std::uint32_t stand_ins = 0;  ///< one for each group of the largest set

    [[nodiscard]] std::uint32_t particle_row(std::uint32_t group) const { return rows[group] + group; }
    [[nodiscard]] std::uint32_t rows_of(std::uint32_t group) const { return rows[group + 1] - rows[group]; }
    [[nodiscard]] std::size_t bytes() const noexcept;
};

[[nodiscard]] FibreSets make_fibre_sets(const ClothModel& model);

}  // namespace weft
