#include "cloth/equation/seam_rows.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace weft {

SeamRows::SeamRows(SeamId id, std::size_t stitches) : id_(id) {
    rows_.reserve(stitches);
    ends_.reserve(2 * stitches);
}

void SeamRows::begin(const SeamState& seam, const Law& law, const std::array<Side, 2>& sides) {
    law_ = law;
    leader_ = std::min(sides[0].first, sides[1].first);
    rows_.clear();
    ends_.clear();
    for (std::uint32_t k = 0; k < seam.stitches.size(); ++k) {
        if (seam.holds[k] == 0) continue;
        std::array<std::uint32_t, 2> numbers{Side::fixed, Side::fixed};
        std::array<Vector3, 2> bases;
        const auto row = static_cast<std::uint32_t>(rows_.size());
        for (std::uint32_t side = 0; side < 2; ++side) {
            const std::uint32_t particle = seam.stitches[k].particles[side];
            const Vec4& base = sides[side].base_positions[particle];
            bases[side] = xyz(base);
            if (sides[side].first == Side::fixed) continue;
            numbers[side] = sides[side].first + particle;
            ends_.push_back({numbers[side], row, side, base.w > 0});
        }
        rows_.push_back({.pair = {{numbers[0], numbers[0], numbers[1], numbers[1]}},
                         .shape = {.weights = {1, 0, -1, 0}, .normal = {}},
                         .stitch = k,
                         .apart = bases[0] - bases[1],
                         .along = 0,
                         .across = 0,
                         .impulse = Vector3::Zero(),
                         .taken = {Vector3::Zero(), Vector3::Zero()},
                         .product = Vector3::Zero()});
    }
    std::ranges::sort(ends_, {}, [](const End& end) { return std::tuple(end.particle, end.row, end.side); });
    forget_forces();
}

std::size_t SeamRows::first_end(std::uint32_t particle) const noexcept {
    return static_cast<std::size_t>(std::ranges::lower_bound(ends_, particle, {}, &End::particle) -
                                    ends_.begin());
}

void SeamRows::take(std::uint32_t first, std::span<const Vec4> vector) {
    for (std::size_t e = first_end(first); e < ends_.size(); ++e) {
        const std::uint32_t i = ends_[e].particle - first;
        if (i >= vector.size()) break;
        rows_[ends_[e].row].taken[ends_[e].side] = xyz(vector[i]);
    }
}

// A stitch of no length has the same tension over its length in all directions, and needs none.
SeamRows::Pull SeamRows::pull_of(const Row& row) const {
    const Vector3 apart = row.apart + law_.gamma * (row.taken[0] - row.taken[1]);
    const float length = apart.norm();
    const Vector3 n = length > 0 ? Vector3(apart / length) : Vector3::UnitY();
    const float tension = law_.stiffness * (length - law_.rest_length);
    const float per_length = law_.rest_length == 0 ? law_.stiffness : length > 0 ? tension / length : 0;
    return {tension, per_length, n, -tension * n};
}

// As in springs.h: where the spring is pressed, its stiffness across would be negative, and is left out.
void SeamRows::linearise() {
    const float gamma = law_.gamma;
    for (Row& row : rows_) {
        const Pull pull = pull_of(row);
        row.shape.normal = to_vec4(pull.direction, 0);
        row.along = gamma * gamma * law_.stiffness;
        row.across = gamma * gamma * std::max(pull.per_length, 0.0f);
        row.impulse = gamma * pull.force;
    }
}

double SeamRows::multiply() {
    double sum = 0;
    for (Row& row : rows_) {
        const Vector3 u = row.taken[0] - row.taken[1];
        row.product = row.stiffness() * u;
        sum += static_cast<double>(u.dot(row.product));
    }
    return sum;
}

void SeamRows::add_products(std::uint32_t first, std::span<Vec4> product) const {
    for (std::size_t e = first_end(first); e < ends_.size(); ++e) {
        const End& end = ends_[e];
        const std::uint32_t i = end.particle - first;
        if (i >= product.size()) break;
        if (end.is_free) set_xyz(product[i], xyz(product[i]) + end.sign() * rows_[end.row].product);
    }
}

bool SeamRows::joins_what_is_held() const noexcept {
    return ends_.size() < 2 * rows_.size() ||
           std::ranges::any_of(ends_, [](const End& end) { return !end.is_free; });
}

void SeamRows::finish(SeamState& seam) {
    linearise();
    forget_forces();
    for (const Row& row : rows_) {
        const Pull pull = pull_of(row);
        force_ += pull.force;
        tightest_ = std::max(tightest_, pull.tension);
        if (!(pull.tension > law_.break_force)) continue;
        seam.holds[row.stitch] = 0;
        ++broken_;
    }
}

}  // namespace weft
