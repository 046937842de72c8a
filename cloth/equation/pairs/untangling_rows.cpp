#include "cloth/equation/pairs/untangling_rows.h"

#include <algorithm>
#include <cmath>

namespace weft {

namespace {

// A row's spring over its mass, in units of gamma^-2: soft, as the depth need not be reached in one step.
constexpr float spring_per_mass = 10;
constexpr std::uint32_t corner_count = 5;

}  // namespace

void UntanglingRows::lay_out(Scratch& scratch, std::size_t rows) {
    scratch.take(springs_, rows);
    scratch.take(taken_, corner_count * rows);
    scratch.take(entries_, corner_count * rows);
}

void UntanglingRows::begin(std::span<const UntanglingRow> rows, std::span<const Vec4> base_positions,
                           float gamma) {
    rows_ = rows;
    gamma_ = gamma;
    entry_count_ = 0;
    for (std::uint32_t k = 0; k < rows.size(); ++k) {
        const Vec4& origin = base_positions[rows[k].corners[0]];
        Vector3 gap = Vector3::Zero();
        float mobility = 0;
        for (std::uint32_t c = 0; c < corner_count; ++c) {
            const Vec4& corner = base_positions[rows[k].corners[c]];
            const float b = rows[k].weights[c];
            gap += b * (xyz(corner) - xyz(origin));
            mobility += b * b * corner.w;
            if (corner.w > 0) entries_[entry_count_++] = {rows[k].corners[c], corner_count * k + c};
            taken_[corner_count * k + c] = {};
        }
        springs_[k] = {.mass = mobility > 0 ? 1 / mobility : 0,
                       .gap = xyz(rows[k].direction).dot(gap),
                       .spring = 0,
                       .impulse = 0,
                       .transfer = 0};
    }
    std::ranges::sort(entries_.span().first(entry_count_), [](const Entry& a, const Entry& b) {
        return a.particle != b.particle ? a.particle < b.particle : a.place < b.place;
    });
}

std::uint32_t UntanglingRows::first_entry(std::uint32_t particle) const {
    const std::span<const Entry> entries = entries_.span().first(entry_count_);
    return static_cast<std::uint32_t>(std::ranges::lower_bound(entries, particle, {}, &Entry::particle) -
                                      entries.begin());
}

void UntanglingRows::take(std::uint32_t first, std::span<const Vec4> vector) {
    for (std::uint32_t k = 0; k < rows_.size(); ++k)
        for (std::uint32_t c = 0; c < corner_count; ++c)
            if (const std::uint32_t i = rows_[k].corners[c] - first; i < vector.size())
                taken_[corner_count * k + c] = vector[i];
}

float UntanglingRows::along(std::uint32_t row) const {
    Vector3 sum = Vector3::Zero();
    for (std::uint32_t c = 0; c < corner_count; ++c)
        sum += rows_[row].weights[c] * xyz(taken_[corner_count * row + c]);
    return xyz(rows_[row].direction).dot(sum);
}

void UntanglingRows::linearise() {
    for (std::uint32_t k = 0; k < rows_.size(); ++k) {
        Spring& row = springs_[k];
        const float depth = rows_[k].direction.w - (row.gap + gamma_ * along(k));
        const bool pushes = rows_[k].direction.w > 0 && depth > 0;
        row.spring = pushes ? spring_per_mass * row.mass : 0;
        row.impulse = pushes ? row.spring / gamma_ * depth : 0;
    }
}

double UntanglingRows::multiply() {
    double sum = 0;
    for (std::uint32_t k = 0; k < rows_.size(); ++k) {
        Spring& row = springs_[k];
        row.transfer = 0;
        if (row.spring == 0) continue;
        const float u = along(k);
        row.transfer = row.spring * u;
        sum += double{u} * double{row.transfer};
    }
    return sum;
}

void UntanglingRows::add_products(std::uint32_t first, std::span<Vec4> product) const {
    const auto end = first + static_cast<std::uint32_t>(product.size());
    for_each_particle(first, end, [&](std::uint32_t i, const Sum& sum) {
        product[i - first] = to_vec4(xyz(product[i - first]) + sum.product, 0);
    });
}

void UntanglingRows::add(const Entry& entry, Sum& sum) const {
    const std::uint32_t row = entry.place / corner_count;
    const Spring& spring = springs_[row];
    if (spring.spring == 0) return;
    const Vector3 n = xyz(rows_[row].direction);
    const float weight = rows_[row].weights[entry.place % corner_count];
    sum.diagonal.add(0, std::sqrt(std::abs(weight) * spring.spring) * n);
    sum.impulse += weight * spring.impulse * n;
    sum.product += weight * spring.transfer * n;
}

}  // namespace weft
