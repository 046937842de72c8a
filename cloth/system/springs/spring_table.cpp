#include "cloth/system/springs/spring_table.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "cloth/system/springs/membrane.h"

namespace weft {

SpringTable::SpringTable(const CookedCloth& model, const SpringMatrix& matrix)
    : rest_lengths_(matrix.entries()),
      stiffness_(matrix.entries()),
      bending_(matrix.entries()),
      slots_(matrix.entries() / Stencil::lanes) {
    std::ranges::fill(rest_lengths_.span(), 1.0f);
    for_each_entry(model, matrix, [&](std::uint32_t e, std::uint32_t entry) {
        rest_lengths_[entry] = model.rest_lengths[e];
        bending_[entry] = model.bending[e];
        stiffest_bending_ = std::max(stiffest_bending_, std::abs(model.bending[e]));
    });
}

bool SpringTable::set(const CookedCloth& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept {
    const bool is_same = fabric.warp == fabric_.warp && fabric.weft == fabric_.weft &&
                         fabric.shear == fabric_.shear && fabric_.areal_density >= 0;
    if (is_same) return false;
    fabric_ = fabric;
    std::ranges::fill(stiffness_.span(), 0.0f);
    // Where panels of a seam have sides of two lengths, the spring rests where its parts balance.
    const bool has_seams = !model.panel_sides.empty();
    if (has_seams) std::ranges::fill(rest_lengths_.span(), 0.0f);
    const auto entry_of = [&](std::uint32_t from, std::uint32_t e) {
        return matrix.entry(from, e, model.neighbours[e]);
    };
    for_each_spring_part(model, fabric,
                         [&](std::uint32_t forth, std::uint32_t back, double stiffness, double length) {
                             const std::uint32_t i = model.neighbours[back], j = model.neighbours[forth];
                             for (const std::uint32_t entry : {entry_of(i, forth), entry_of(j, back)}) {
                                 if (entry == SpringMatrix::no_entry) continue;
                                 stiffness_[entry] += static_cast<float>(stiffness);
                                 if (has_seams)
                                     rest_lengths_[entry] += static_cast<float>(stiffness * length);
                             }
                         });
    stiffest_ = 0;
    for (float& stiffness : stiffness_.span()) {
        stiffness = std::max(stiffness, 0.0f);
        stiffest_ = std::max(stiffest_, stiffness);
    }
    if (has_seams) {
        for_each_entry(model, matrix, [&](std::uint32_t e, std::uint32_t entry) {
            float& length = rest_lengths_[entry];
            length = stiffness_[entry] > 0 ? length / stiffness_[entry] : model.rest_lengths[e];
        });
    }
    sum_up_slots();
    return true;
}

void SpringTable::sum_up_slots() noexcept {
    const auto all_same = [](std::span<const float> lanes) {
        return std::ranges::count(lanes, lanes[0]) == Stencil::lanes;
    };
    for (std::size_t s = 0; s < slots_.size(); ++s) {
        const auto lanes = [&](const AlignedBuffer<float>& values) {
            return values.span().subspan(s * Stencil::lanes, Stencil::lanes);
        };
        const std::span<const float> rest = lanes(rest_lengths_), k = lanes(stiffness_), b = lanes(bending_);
        const bool no_springs = k[0] == 0 && all_same(k);
        SlotKind kind = no_springs ? SlotKind::bending : SlotKind::mixed;
        if (all_same(b) && no_springs)
            kind = SlotKind::same_bending;
        else if (all_same(b) && all_same(k) && all_same(rest))
            kind = SlotKind::same;
        slots_[s] = {{rest[0], k[0], b[0]}, kind};
    }
}

}  // namespace weft
