#include "cloth/geodesics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {

namespace {

/// Precondition: the model has a spring between the two, as along every side of a triangle.
double rest_length(const CookedCloth& model, std::uint32_t i, std::uint32_t j) {
    const std::uint32_t* const row = model.neighbours.data();
    const std::uint32_t* const at =
        std::lower_bound(row + model.spring_offsets[i], row + model.spring_offsets[i + 1], j);
    return static_cast<double>(model.rest_lengths[static_cast<std::size_t>(at - row)]);
}

// The distance of a triangle's corner c, from those of a and b, if both were reached straight from one
// source: unfolded into the triangle's plane, that source lies where the circles about a and b meet, beyond
// the side a b (Novotni and Klein 2002; exact on flat cloth, where Kimmel and Sethian's plane waves are not).
// Infinity if the straight way does not lead through the side; the ways along the triangle's sides are then
// the shortest through it.
double distance_across(double distance_a, double distance_b, double side_ab, double side_bc, double side_ca) {
    const double c_along = (side_ca * side_ca - side_bc * side_bc + side_ab * side_ab) / (2 * side_ab);
    const double c_height = std::sqrt(std::max(0.0, side_ca * side_ca - c_along * c_along));
    const double along =
        (distance_a * distance_a - distance_b * distance_b + side_ab * side_ab) / (2 * side_ab);
    const double depth = std::sqrt(std::max(0.0, distance_a * distance_a - along * along));
    if (!(c_height + depth > 0)) return std::numeric_limits<double>::infinity();
    const double crossing = along + (c_along - along) * depth / (depth + c_height);
    if (crossing < 0 || crossing > side_ab) return std::numeric_limits<double>::infinity();
    return std::hypot(c_along - along, c_height + depth);
}

}  // namespace

Geodesics::Geodesics(const CookedCloth& model)
    : sides_(model.triangles.size()), distances_(model.particle_count), sources_(model.particle_count) {
    for (std::size_t t = 0; t < model.triangles.size(); ++t) {
        const auto& [a, b, c] = model.triangles[t];
        sides_[t] = {rest_length(model, b, c), rest_length(model, c, a), rest_length(model, a, b)};
    }
    front_.reserve(4 * std::size_t{model.particle_count});
}

void Geodesics::reach(std::uint32_t particle, double distance, std::uint32_t source) {
    constexpr double least_gain = 1 - 1e-9;  // rounding must not keep the front alive
    if (!(distance < least_gain * distances_[particle])) return;
    distances_[particle] = distance;
    sources_[particle] = source;
    front_.push_back({distance, particle});
    std::ranges::push_heap(front_, std::greater<>{}, &Front::distance);
}

void Geodesics::cross_triangle(const CookedCloth& model, std::uint32_t triangle, std::uint32_t from) {
    const Triangle& corners = model.triangles[triangle];
    const std::array<double, 3>& sides = sides_[triangle];
    const std::size_t a = corners[0] == from ? 0 : corners[1] == from ? 1 : 2;
    for (const std::size_t turn : {std::size_t{1}, std::size_t{2}}) {
        const std::size_t b = (a + turn) % 3, c = (a + 3 - turn) % 3;
        const double distance = distances_[from];
        reach(corners[c], distance + sides[b], sources_[from]);
        if (sources_[corners[b]] != sources_[from]) continue;
        reach(corners[c], distance_across(distance, distances_[corners[b]], sides[c], sides[a], sides[b]),
              sources_[from]);
    }
}

// In an obtuse triangle the front can reach the far corner before one of the other two. A particle that is
// reached by a shorter way later goes back into the front, which then corrects what it had reached from
// there.
void Geodesics::march(const CookedCloth& model, std::span<const std::uint32_t> sources) {
    std::ranges::fill(distances_, std::numeric_limits<double>::infinity());
    std::ranges::fill(sources_, none);
    front_.clear();
    for (const std::uint32_t source : sources) reach(source, 0, source);
    while (!front_.empty()) {
        std::ranges::pop_heap(front_, std::greater<>{}, &Front::distance);
        const auto [distance, particle] = front_.back();
        front_.pop_back();
        if (distance > distances_[particle]) continue;  // reached by a shorter way since
        for (std::uint32_t k = model.corner_offsets[particle]; k < model.corner_offsets[particle + 1]; ++k)
            cross_triangle(model, model.corner_triangles[k], particle);
    }
}

std::size_t Geodesics::bytes() const noexcept {
    return sides_.size() * sizeof(sides_[0]) + distances_.size() * sizeof(double) +
           sources_.size() * sizeof(std::uint32_t) + front_.capacity() * sizeof(Front);
}

}  // namespace weft
