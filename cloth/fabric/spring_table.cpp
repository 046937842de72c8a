#include "cloth/fabric/spring_table.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "cloth/fabric/membrane.h"
#include "engine/memory/list_checks.h"

namespace weft {

SpringTable::SpringTable(const ClothModel& model, const SpringMatrix& matrix, bool stiffens)
    : rest_lengths_(matrix.entries()),
      stiffness_(matrix.entries()),
      bending_(matrix.entries()),
      stiffening_(stiffens ? matrix.entries() : 0),
      slots_(matrix.entries() / Stencil::lanes) {
    std::ranges::fill(rest_lengths_.span(), 1.0f);
    for_each_entry(model, matrix, [&](std::uint32_t e, std::uint32_t entry) {
        rest_lengths_[entry] = model.rest_lengths[e];
        bending_[entry] = model.bending[e];
        stiffest_bending_ = std::max(stiffest_bending_, std::abs(model.bending[e]));
    });
}

bool SpringTable::is_sound(std::size_t entries, bool stiffens) const {
    std::uint32_t wrong = 0;
    for (const Slot& slot : slots_) wrong |= slot.kind > SlotKind::bending ? 1u : 0u;
    const float numbers[] = {stiffest_, stiffest_bending_};
    return wrong == 0 && are_from_zero(numbers) && rest_lengths_.size() == entries &&
           stiffness_.size() == entries && bending_.size() == entries &&
           stiffening_.size() == (stiffens ? entries : 0) && slots_.size() == entries / Stencil::lanes;
}

void SpringTable::make_own() {
    stiffness_.make_own();
    stiffening_.make_own();
    slots_.make_own();
}

void SpringTable::set(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept {
    if (empty()) return;
    std::ranges::fill(stiffness_.span(), 0.0f);
    for_each_spring_part(model, fabric, [&](std::uint32_t forth, std::uint32_t back, double part) {
        const auto [i, j] = std::minmax(model.neighbours[back], model.neighbours[forth]);
        stiffness_[matrix.diagonals.entry_between(i, j)] += static_cast<float>(part);
    });
    stiffest_ = 0;
    for (float& stiffness : stiffness_.span()) {
        stiffness = std::max(stiffness, 0.0f);
        stiffest_ = std::max(stiffest_, stiffness);
    }
    set_stiffening(model, matrix, fabric);
    sum_up_slots();
}

void SpringTable::set_stiffening(const ClothModel& model, const SpringMatrix& matrix,
                                 const Fabric& fabric) noexcept {
    if (stiffening_.size() == 0) return;
    std::ranges::fill(stiffening_.span(), 0.0f);
    const auto add = [&](std::uint32_t i, std::uint32_t j, double q) {
        stiffening_[matrix.diagonals.entry_between(std::min(i, j), std::max(i, j))] += static_cast<float>(q);
    };
    for (std::uint32_t row = 0; row + 1 < model.rows; ++row)
        for (std::uint32_t column = 0; column + 1 < model.columns; ++column)
            for_each_stiffening_of_cell(model, fabric, row * model.columns + column, add);
    const auto steepest = static_cast<float>(stiffened(last_stiffening_strain).slope);
    for (std::size_t e = 0; e < stiffening_.size(); ++e)
        stiffest_ = std::max(stiffest_, stiffness_[e] + steepest * stiffening_[e]);
}

void SpringTable::sum_up_slots() noexcept {
    const auto all_same = [](std::span<const float> lanes) {
        return std::ranges::count(lanes, lanes[0]) == Stencil::lanes;
    };
    for (std::size_t s = 0; s < slots_.size(); ++s) {
        const auto lanes = [&](const SharedBuffer<float>& values) {
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
