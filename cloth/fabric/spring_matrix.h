#pragma once
// The matrix of springs, and the loops over its rows: a block of particles at a time, with the widest vectors
// that the machine has.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "cloth/equation/contacts.h"
#include "cloth/equation/grid/diagonals.h"
#include "cloth/equation/implicit_system.h"
#include "engine/memory/scratch.h"
#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// W by rows, in groups of 16 particles: (W x)_i = (r_i + G_i) x_i + sum_j A_ij (x_i - x_j), A = a I + d d^T.
///
/// a and d are kept in half precision, since a sweep takes as long as these bytes do. Invariant: both ends of
/// a spring and the diagonal are made of the cut values, so that W is symmetric, keeps momentum, and is
/// positive definite.
///
/// A grid: the entries are those of diagonals, each spring at its first end. Any other mesh: those of a
/// stencil of rings, each spring at both ends; see Rings.
struct SpringMatrix {
    SpringMatrix() = default;
    /// The matrix of rings and their places; or of a grid, whose stencil has no lists.
    SpringMatrix(Stencil of_rings, SharedBuffer<std::uint32_t> places, const Diagonals& of_grid)
        : stencil(std::move(of_rings)), group_places(std::move(places)), diagonals(of_grid) {}
    void lay_out(Scratch& scratch);
    /// Chooses the unit so that blocks A of up to `largest_block` [kg] fit half precision.
    void set_unit(float largest_block);

    [[nodiscard]] std::size_t entries() const noexcept {
        return diagonals.empty() ? stencil.neighbours.size() : diagonals.entries();
    }
    /// The place * 16 + lane of half-edge e of node i, which is a spring's; see Rings.
    [[nodiscard]] std::uint32_t place(std::uint32_t i, std::uint32_t e) const {
        const std::uint32_t group = i / Stencil::lanes, entry = stencil.entries[e];
        const std::uint32_t slot = entry / Stencil::lanes - stencil.group_slots[group];
        // The slot is one of the group's, unless a file was made to mislead.
        return (group_places[group] + std::min(slot + 1, springs_of(group))) * Stencil::lanes +
               entry % Stencil::lanes;
    }
    /// Slots of a group that have springs, which are its first ones.
    [[nodiscard]] std::uint32_t springs_of(std::uint32_t group) const {
        return group_places[group + 1] - group_places[group] - 1;
    }
    /// The first half of a group's slot, for rings. A slot that only bends has a alone.
    [[nodiscard]] std::size_t halves(std::uint32_t group, std::uint32_t slot) const {
        const std::size_t before =
            stencil.group_slots[group] + std::size_t{3} * (group_places[group] - group);
        return Stencil::lanes * (before + halves_before(slot, springs_of(group)));
    }
    /// Arrays of 16 halves before a slot of a group with so many slots of springs.
    [[nodiscard]] static constexpr std::uint32_t halves_before(std::uint32_t slot, std::uint32_t springs) {
        return slot < springs ? 4 * slot : 3 * springs + slot;
    }
    [[nodiscard]] std::uint32_t places() const noexcept {
        return group_places.empty() ? 0 : group_places[stencil.groups()];
    }
    /// The particle that particle i has in one of its entries.
    [[nodiscard]] std::uint32_t neighbour(std::uint32_t entry, std::uint32_t i) const {
        return diagonals.empty() ? stencil.neighbours[entry]
                                 : i + diagonals.differences[entry / Stencil::lanes % diagonals.count];
    }

    Stencil stencil;  ///< of a grid without lists
    /// Places of group g: [group_places[g], group_places[g + 1]), one and one for each of its first slots;
    /// in the others there is bending alone, and d is not kept. A grid has none.
    SharedBuffer<std::uint32_t> group_places;
    Diagonals diagonals;  ///< empty for what is no grid
    /// Diagonals along which there is bending alone: d is 0, and neither written nor read.
    std::array<bool, Diagonals::most> isotropic{};
    float unit = 1;                            ///< of d [sqrt(kg)], and its square of a; a power of two
    ScratchArray<std::uint16_t> coefficients;  ///< per 16 entries 16 a, d_x, d_y, d_z; see halves()
    ScratchArray<float> row_sums;              ///< r_i [kg]; 0 for pinned particles, whose rows count as 0
    const ContactRows* contacts = nullptr;     ///< G; null: there are no colliders
    ScratchArray<float> inverse_diagonal;  ///< per group 16 xx, yy, zz, xy, xz, yz; 0 for pinned particles

    [[nodiscard]] std::size_t all_halves() const noexcept {
        if (!diagonals.empty()) return 4 * entries();
        return Stencil::lanes * (stencil.slots() + std::size_t{3} * (places() - stencil.groups()));
    }
    [[nodiscard]] std::size_t bytes() const noexcept { return stencil.bytes() + group_places.bytes(); }
};

/// These do what ImplicitSystem's functions of the same name do, for one block, and return its shares.
/// Invariant: `window` is null but for matrices with diagonals.
Products multiply_block(const SpringMatrix& matrix, const BlockRange& range, const DottedWith& with,
                        const Vec4* x, Vec4* product, GridWindow* window);
void subtract_product_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                            Vec4* remainder, GridWindow* window);
void relax_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next, GridWindow* window);
/// In a grid: remainder = b - W x with x = step D^-1 b. Rows of x are made where they are read and never
/// stored.
void subtract_first_step_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                               Vec4* remainder, GridWindow& window);
/// In a grid: a step from x + P e.
void relax_corrected_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                           const Correction& correction, Vec4* next, GridWindow& window);
void precondition_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                        Vec4* x);
/// As ImplicitSystem::spring_blocks, for the slots [range.begin, range.end) of the list.
void unpack_block(const SpringMatrix& matrix, const BlockRange& range, const std::uint32_t* slots,
                  Vec4* blocks);

}  // namespace weft
