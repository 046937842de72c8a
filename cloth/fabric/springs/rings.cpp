#include "cloth/fabric/springs/rings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cloth/fabric/springs/membrane.h"
#include "engine/memory/list_checks.h"

namespace weft {

namespace {

/// The sides of a triangle, as a place at one of its corners has them: side k runs from corner k to the next.
struct SidesAt {
    std::uint32_t a, b, third;
};
SidesAt sides_at(std::uint32_t corner, bool starts_with_b) {
    const std::uint32_t forth = corner, back = (corner + 2) % 3;
    return {starts_with_b ? back : forth, starts_with_b ? forth : back, (corner + 1) % 3};
}

}  // namespace

Rings::Rings(const ClothModel& model, const RingOrder& order, const SpringMatrix& matrix, bool stiffens)
    : bending_(matrix.entries()),
      last_(std::size_t{lanes} * matrix.stencil.groups()),
      closes_(matrix.places()),
      corners_(model.rows == 0 ? 3 * model.triangles.size() : 0) {
    springs_ = SharedBuffer<float>(std::size_t{count} * lanes * matrix.places());
    if (stiffens) stiffening_ = SharedBuffer<float>(std::size_t{stiffening_count} * lanes * matrix.places());
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            bending_[matrix.stencil.entry(i, e)] = model.bending[e];
            stiffest_bending_ = std::max(stiffest_bending_, std::abs(model.bending[e]));
        }
    }
    for (std::uint32_t i = 0; i < last_.size(); ++i) last_[i] = std::min(i, model.particle_count - 1);
    const auto name = [&](std::uint32_t triangle, std::uint32_t particle, const RingPlace& a,
                          std::uint32_t place) {
        if (triangle == RingPlace::none) return;
        const Triangle& corners = model.triangles[triangle];
        const std::uint32_t k = corner_at(corners, particle);
        const bool starts_with_b = corners[(k + 1) % 3] != model.neighbours[a.half_edge];
        const std::uint32_t in_group = place - matrix.group_places[particle / lanes];
        corners_[std::size_t{3} * triangle + k] = static_cast<std::uint16_t>(2 * in_group + starts_with_b);
    };
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const std::uint32_t opening = matrix.group_places[i / lanes];
        for (std::uint32_t p = order.offsets[i]; p < order.end(i); ++p)
            name(order.places[p].triangle, i, order.places[p], opening + 1 + p - order.offsets[i]);
        if (order.openings[i] == RingPlace::none) continue;
        const RingPlace& last = order.places[order.end(i) - 1];
        name(order.openings[i], i, last, opening);
        last_[i] = model.neighbours[last.half_edge];
        closes_[opening + order.end(i) - order.offsets[i]] |= static_cast<std::uint16_t>(1u << i % lanes);
    }
}

void Rings::lay_out(Scratch& scratch) {
    scratch.take(directions_, springs_.size() / count * directions_count);
    scratch.take(reached_, stiffening_.size() / stiffening_count * reached_count);
}

bool Rings::is_sound(const ClothModel& model, std::size_t places, std::size_t entries, bool stiffens) const {
    const float numbers[] = {stiffest_, stiffest_bending_};
    const std::size_t particles = Stencil::whole_groups(model.particle_count);
    return are_from_zero(numbers) && springs_.size() == count * lanes * places &&
           stiffening_.size() == (stiffens ? stiffening_count * lanes * places : 0) &&
           bending_.size() == entries && last_.size() == particles && closes_.size() == places &&
           corners_.size() == (model.rows == 0 ? 3 * model.triangles.size() : 0) &&
           are_below(last_.span(), model.particle_count);
}

void Rings::make_own() {
    springs_.make_own();
    stiffening_.make_own();
}

void Rings::set(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept {
    if (empty()) return;
    std::ranges::fill(springs_.span(), 0.0f);
    std::ranges::fill(stiffening_.span(), 0.0f);
    stiffest_ = 0;
    if (model.rows > 0)
        set_cells(model, matrix, fabric);
    else
        set_triangles(model, matrix, fabric);
}

Rings::Corner Rings::corner_of(const ClothModel& model, const SpringMatrix& matrix, std::uint32_t triangle,
                               std::uint32_t k) const noexcept {
    const std::uint32_t particle = model.triangles[triangle][k], group = particle / lanes,
                        corner = corners_[std::size_t{3} * triangle + k];
    // The clamp matters only for a corrupt file: it keeps the place within the group.
    const std::uint32_t place = matrix.group_places[group] + std::min(corner / 2, matrix.springs_of(group));
    return {place * lanes + particle % lanes, corner % 2 != 0};
}

// The tension of side k is sum_m C'_km (l_m - L_m), over its triangles.
void Rings::set_triangles(const ClothModel& model, const SpringMatrix& matrix,
                          const Fabric& fabric) noexcept {
    float extra = 0;
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t) {
        const TriangleMembrane membrane = triangle_membrane(model, t, fabric);
        for (std::uint32_t k = 0; k < 3; ++k) {
            double offset = 0;
            for (std::uint32_t m = 0; m < 3; ++m)
                offset += (membrane.shared[k][m] + (m == k ? membrane.own[k] : 0)) * membrane.rest_lengths[m];
            const std::uint32_t i = model.triangles[t][k], j = model.triangles[t][(k + 1) % 3];
            for (const auto& [from, to] : {std::pair{i, j}, std::pair{j, i}}) {
                const std::uint32_t place = matrix.place(from, half_edge_between(model, from, to));
                number(place, stiffness) += static_cast<float>(membrane.own[k]);
                number(place, slope) += static_cast<float>(membrane.own[k] + membrane.shared[k][k]);
                number(place, Number::at_zero) += static_cast<float>(offset);
                stiffest_ = std::max(stiffest_, number(place, stiffness));
            }
            const Corner corner = corner_of(model, matrix, t, k);
            const auto [a, b, third] = sides_at(k, corner.starts_with_b);
            number(corner.place, other) = static_cast<float>(membrane.shared[a][b]);
            number(corner.place, third_a) = static_cast<float>(membrane.shared[a][third]);
            number(corner.place, third_b) = static_cast<float>(membrane.shared[b][third]);
        }
        if (stiffening_.size() > 0)
            extra = std::max(extra, set_stiffening(model, matrix, t, membrane, fabric));
    }
    stiffest_ += 2 * extra;  // a spring is a side of two triangles
}

float Rings::set_stiffening(const ClothModel& model, const SpringMatrix& matrix, std::uint32_t triangle,
                            const TriangleMembrane& membrane, const Fabric& fabric) noexcept {
    const TriangleStiffening stiffening = triangle_stiffening(model, triangle, fabric);
    std::array<double, 3> pulled{};  // stiffness added where the law is steepest, by both axes [N/m]
    for (std::uint32_t axis = 0; axis < 2; ++axis) {
        const std::array<double, 3>& v = stiffening.strains[axis];
        double sum = 0, offset = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            sum += std::abs(v[k]);
            offset -= v[k] * membrane.rest_lengths[k];
        }
        for (std::uint32_t k = 0; k < 3; ++k) {
            pulled[k] += stiffening.moduli[axis] * 2 * last_stiffening_strain *
                         std::max(v[k] * v[k], least_bound * sum * std::abs(v[k]));
            const auto [place, starts_with_b] = corner_of(model, matrix, triangle, k);
            const auto [a, b, third] = sides_at(k, starts_with_b);
            const std::uint32_t first = axis * axis_count;
            number(place, first + by_a) = static_cast<float>(v[a]);
            number(place, first + by_b) = static_cast<float>(v[b]);
            number(place, first + by_third) = static_cast<float>(v[third]);
            number(place, first + strain_at_zero) = static_cast<float>(offset);
            number(place, first + modulus) = static_cast<float>(stiffening.moduli[axis]);
        }
    }
    return static_cast<float>(*std::ranges::max_element(pulled));
}

void Rings::set_cells(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept {
    for_each_spring_part(model, fabric, [&](std::uint32_t forth, std::uint32_t back, double part) {
        const std::uint32_t i = model.neighbours[back], j = model.neighbours[forth];
        for (const std::uint32_t place : {matrix.place(i, forth), matrix.place(j, back)})
            number(place, stiffness) += static_cast<float>(part);
    });
    if (stiffening_.size() > 0) {
        const auto add = [&](std::uint32_t i, std::uint32_t j, double q) {
            const std::uint32_t forth = half_edge_between(model, i, j), back = half_edge_between(model, j, i);
            for (const std::uint32_t place : {matrix.place(i, forth), matrix.place(j, back)})
                number(place, of_sheet) += static_cast<float>(q);
        };
        for (std::uint32_t row = 0; row + 1 < model.rows; ++row)
            for (std::uint32_t column = 0; column + 1 < model.columns; ++column)
                for_each_stiffening_of_cell(model, fabric, row * model.columns + column, add);
    }
    const auto steepest = static_cast<float>(stiffened(last_stiffening_strain).slope);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            if (model.kinds[e] == SpringKind::bending) continue;
            const std::uint32_t place = matrix.place(i, e);
            const float k = number(place, stiffness) = std::max(number(place, stiffness), 0.0f);
            const float length = model.rest_lengths[e];
            number(place, slope) = k;
            number(place, at_zero) = k * length;
            stiffest_ = std::max(stiffest_, k);
            if (stiffening_.size() == 0) continue;
            stiffest_ = std::max(stiffest_, k + steepest * number(place, of_sheet));
            number(place, of_sheet) *= length;
            number(place, per_rest_length) = 1 / length;
        }
    }
}

}  // namespace weft
