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
/// a and d are stored in half precision, since reading them takes most of a sweep's time. Invariant: both
/// ends of a spring and the diagonal are made of the rounded values, so that W is symmetric, keeps momentum,
/// and is positive definite.
///
/// A grid's entries are those of its diagonals, with each spring at its first end. Any other mesh's are those
/// of a stencil of rings, with each spring at both ends; see Rings.
struct SpringMatrix {
    SpringMatrix() = default;
    /// Makes the matrix of rings and their places; or that of a grid, whose stencil has no lists.
    SpringMatrix(Stencil of_rings, SharedBuffer<std::uint32_t> places, const Diagonals& of_grid)
        : stencil(std::move(of_rings)), group_places(std::move(places)), diagonals(of_grid) {}
    void lay_out(Scratch& scratch);
    /// Marks the diagonals of a grid that no spring is along, by bits.
    void set_isotropic(std::uint32_t bits) noexcept {
        spring_diagonals = 0;
        for (std::uint32_t d = 0; d < diagonals.count; ++d) {
            isotropic[d] = (bits >> d & 1) != 0;
            ranks[d] = spring_diagonals;
            spring_diagonals += isotropic[d] ? 0 : 1;
        }
    }
    /// Chooses the unit so that blocks A of up to `largest_block` [kg] fit half precision.
    void set_unit(float largest_block);

    [[nodiscard]] std::size_t entries() const noexcept {
        return diagonals.empty() ? stencil.neighbours.size() : diagonals.entries();
    }
    /// The place * 16 + lane of half-edge e of node i, which is a spring's; see Rings.
    [[nodiscard]] std::uint32_t place(std::uint32_t i, std::uint32_t e) const {
        const std::uint32_t group = i / Stencil::lanes, slot = stencil.slot_of[e];
        // The clamp matters only for a corrupt file: it keeps the place within the group.
        return (group_places[group] + std::min(slot + 1, springs_of(group))) * Stencil::lanes +
               i % Stencil::lanes;
    }
    /// The springs of a grid have places of their own, laid out as entries, but for the diagonals that have
    /// springs only: the place of an entry on such a diagonal, particle i's first one, and their number.
    [[nodiscard]] std::uint32_t spring_place(std::uint32_t entry) const noexcept {
        const std::uint32_t slot = entry / Stencil::lanes, group = slot / diagonals.count;
        // The diagonal has springs, except in a corrupt file.
        const std::uint32_t rank = std::min(ranks[slot % diagonals.count], spring_diagonals - 1);
        return (group * spring_diagonals + rank) * Stencil::lanes + entry % Stencil::lanes;
    }
    [[nodiscard]] std::uint32_t first_place(std::uint32_t i) const noexcept {
        return i / Stencil::lanes * spring_diagonals * Stencil::lanes + i % Stencil::lanes;
    }
    [[nodiscard]] std::size_t spring_places() const noexcept {
        return std::size_t{diagonals.groups()} * spring_diagonals * Stencil::lanes;
    }
    /// The number of a group's slots that have springs. These slots come first.
    [[nodiscard]] std::uint32_t springs_of(std::uint32_t group) const {
        return group_places[group + 1] - group_places[group] - 1;
    }
    /// The index of the first half of a group's slot, for rings. A slot that only bends has no d.
    [[nodiscard]] std::size_t halves(std::uint32_t group, std::uint32_t slot) const {
        const std::size_t before =
            stencil.group_slots[group] + std::size_t{3} * (group_places[group] - group);
        return Stencil::lanes * (before + halves_before(slot, springs_of(group)));
    }
    /// The index of the first half of a diagonal's slot in a grid's group.
    [[nodiscard]] std::size_t halves_of_diagonal(std::uint32_t group, std::uint32_t d) const noexcept {
        const std::size_t slots = std::size_t{group} * diagonals.count + d,
                          springs = std::size_t{group} * spring_diagonals + ranks[d];
        return Stencil::lanes * (slots + 3 * springs);
    }
    /// The number of arrays of 16 halves before a slot, in a group with so many slots of springs.
    [[nodiscard]] static constexpr std::uint32_t halves_before(std::uint32_t slot, std::uint32_t springs) {
        return slot < springs ? 4 * slot : 3 * springs + slot;
    }
    [[nodiscard]] std::uint32_t places() const noexcept {
        return group_places.empty() ? 0 : group_places[stencil.groups()];
    }
    /// The neighbour of particle i in one of its entries.
    [[nodiscard]] std::uint32_t neighbour(std::uint32_t entry, std::uint32_t i) const {
        return diagonals.empty() ? stencil.neighbours[entry]
                                 : i + diagonals.differences[entry / Stencil::lanes % diagonals.count];
    }

    Stencil stencil;  ///< without lists for a grid
    /// Places of group g: [group_places[g], group_places[g + 1]): the opening, and one for each slot with
    /// springs, which come first. The other slots have bending alone, and no d. A grid has no places.
    SharedBuffer<std::uint32_t> group_places;
    Diagonals diagonals;  ///< empty: the matrix is one of rings
    /// Diagonals with bending alone: d is 0, and neither written nor read.
    std::array<bool, Diagonals::most> isotropic{};
    std::array<std::uint32_t, Diagonals::most> ranks{};  ///< by diagonal: those with springs before it
    std::uint32_t spring_diagonals = 0;
    float unit = 1;                            ///< of d [sqrt(kg)]; a has its square; a power of two
    ScratchArray<std::uint16_t> coefficients;  ///< per 16 entries 16 a, d_x, d_y, d_z; see halves()
    ScratchArray<float> row_sums;              ///< r_i [kg]; 0 for pinned particles, whose rows count as 0
    const ContactRows* contacts = nullptr;     ///< G; null: there are no colliders
    ScratchArray<float> inverse_diagonal;  ///< per group 16 xx, yy, zz, xy, xz, yz; 0 for pinned particles

    [[nodiscard]] std::size_t all_halves() const noexcept {
        if (!diagonals.empty()) return entries() + 3 * spring_places();
        return Stencil::lanes * (stencil.slots() + std::size_t{3} * (places() - stencil.groups()));
    }
    [[nodiscard]] std::size_t bytes() const noexcept { return stencil.bytes() + group_places.bytes(); }
};

/// These functions do for one block what ImplicitSystem's of the same name do, and return its share of the
/// products. Invariant: `window` is null unless the matrix has diagonals.
Products multiply_block(const SpringMatrix& matrix, const BlockRange& range, const DottedWith& with,
                        const Vec4* x, Vec4* product, GridWindow* window);
void subtract_product_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                            Vec4* remainder, GridWindow* window);
void relax_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next, GridWindow* window);
/// Computes remainder = b - W x with x = step D^-1 b, in a grid. Rows of x are computed where they are read
/// and never stored.
void subtract_first_step_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                               Vec4* remainder, GridWindow& window);
/// Relaxes once from x + P e, in a grid, with that x.
void relax_corrected_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                           const Correction& correction, Vec4* next, GridWindow& window);
void precondition_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                        Vec4* x);
/// Like ImplicitSystem::spring_blocks, for the slots [range.begin, range.end) of the list.
void unpack_block(const SpringMatrix& matrix, const BlockRange& range, const std::uint32_t* slots,
                  Vec4* blocks);

}  // namespace weft
