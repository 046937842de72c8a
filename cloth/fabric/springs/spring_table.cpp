#include "cloth/fabric/springs/spring_table.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "cloth/fabric/springs/membrane.h"
#include "engine/memory/list_checks.h"

namespace weft {

SpringTable::SpringTable(const ClothModel& model, const SpringMatrix& matrix, bool stiffens)
    : rest_lengths_(matrix.spring_places()),
      stiffness_(matrix.spring_places()),
      bending_(matrix.entries()),
      stiffening_(stiffens ? matrix.spring_places() : 0) {
    std::ranges::fill(rest_lengths_.span(), 1.0f);
    for_each_entry(model, matrix, [&](std::uint32_t e, std::uint32_t entry) {
        if (model.kinds[e] != SpringKind::bending)
            rest_lengths_[matrix.spring_place(entry)] = model.rest_lengths[e];
        bending_[entry] = model.bending[e];
        stiffest_bending_ = std::max(stiffest_bending_, std::abs(model.bending[e]));
    });
}

bool SpringTable::is_sound(std::size_t entries, std::size_t springs, bool stiffens) const {
    const float numbers[] = {stiffest_, stiffest_bending_};
    return are_from_zero(numbers) && bending_.size() == entries && rest_lengths_.size() == springs &&
           stiffness_.size() == springs && stiffening_.size() == (stiffens ? springs : 0);
}

void SpringTable::make_own() {
    stiffness_.make_own();
    stiffening_.make_own();
}

void SpringTable::set(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept {
    if (empty()) return;
    std::ranges::fill(stiffness_.span(), 0.0f);
    for_each_spring_part(model, fabric, [&](std::uint32_t forth, std::uint32_t back, double part) {
        const auto [i, j] = std::minmax(model.neighbours[back], model.neighbours[forth]);
        stiffness_[matrix.spring_place(matrix.diagonals.entry_between(i, j))] += static_cast<float>(part);
    });
    stiffest_ = 0;
    for (float& stiffness : stiffness_.span()) {
        stiffness = std::max(stiffness, 0.0f);
        stiffest_ = std::max(stiffest_, stiffness);
    }
    set_stiffening(model, matrix, fabric);
}

void SpringTable::set_stiffening(const ClothModel& model, const SpringMatrix& matrix,
                                 const Fabric& fabric) noexcept {
    if (stiffening_.size() == 0) return;
    std::ranges::fill(stiffening_.span(), 0.0f);
    const auto add = [&](std::uint32_t i, std::uint32_t j, double q) {
        const std::uint32_t entry = matrix.diagonals.entry_between(std::min(i, j), std::max(i, j));
        stiffening_[matrix.spring_place(entry)] += static_cast<float>(q);
    };
    for (std::uint32_t row = 0; row + 1 < model.rows; ++row)
        for (std::uint32_t column = 0; column + 1 < model.columns; ++column)
            for_each_stiffening_of_cell(model, fabric, row * model.columns + column, add);
    const auto steepest = static_cast<float>(stiffened(last_stiffening_strain).slope);
    for (std::size_t e = 0; e < stiffening_.size(); ++e)
        stiffest_ = std::max(stiffest_, stiffness_[e] + steepest * stiffening_[e]);
}

}  // namespace weft
