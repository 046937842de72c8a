#include "cloth/solvers/linear/mean_motion.h"

#include <algorithm>

namespace weft {

namespace {

std::span<const std::uint32_t> particles_of(const CookedCloth& model, std::uint32_t component) {
    const std::uint32_t begin = model.component_offsets[component];
    return std::span(model.component_particles)
        .subspan(begin, model.component_offsets[component + 1] - begin);
}

}  // namespace

MeanMotion::MeanMotion(const CookedCloth& model)
    : component_change_(model.component_offsets.size() - 1), partials_(block_count(model.particle_count)) {}

template <class Term>
MeanMotion::Sum MeanMotion::sum_over(Parallel& parallel, std::span<const std::uint32_t> particles,
                                     std::span<const Vec4> right_side, const Term& term) {
    return parallel.reduce(
        static_cast<std::uint32_t>(particles.size()), partials_.span(), Sum{},
        [&](const BlockRange& range) {
            Sum sum;
            for (const std::uint32_t i : particles.subspan(range.begin, range.end - range.begin)) {
                const Vector3 value = term(i);
                const float row_sum = right_side[i].w;
                sum.x += static_cast<double>(value.x());
                sum.y += static_cast<double>(value.y());
                sum.z += static_cast<double>(value.z());
                sum.row_sum += static_cast<double>(row_sum);
                sum.pinned |= row_sum == 0;
            }
            return sum;
        },
        [](const Sum& l, const Sum& r) {
            return Sum{l.x + r.x, l.y + r.y, l.z + r.z, l.row_sum + r.row_sum, l.pinned || r.pinned};
        });
}

void MeanMotion::take_out(Parallel& parallel, const CookedCloth& model, std::span<Vec4> right_side) {
    for (std::uint32_t c = 0; c < component_change_.size(); ++c) {
        const auto particles = particles_of(model, c);
        const Sum sum =
            sum_over(parallel, particles, right_side, [&](std::uint32_t i) { return xyz(right_side[i]); });
        component_change_[c] = {};
        if (sum.pinned) continue;

        const Vector3 u = sum.mean();
        component_change_[c] = to_vec4(u, 1);
        parallel.ranges(static_cast<std::uint32_t>(particles.size()), [&](const BlockRange& range) {
            for (const std::uint32_t i : particles.subspan(range.begin, range.end - range.begin)) {
                Vec4& b = right_side[i];
                set_xyz(b, xyz(b) - b.w * u);
            }
        });
    }
}

void MeanMotion::put_back(Parallel& parallel, const CookedCloth& model, std::span<const Vec4> right_side,
                          std::span<Vec4> velocity_change) {
    for (std::uint32_t c = 0; c < component_change_.size(); ++c) {
        if (component_change_[c].w == 0) continue;
        const auto particles = particles_of(model, c);
        const Sum sum = sum_over(parallel, particles, right_side, [&](std::uint32_t i) {
            return Vector3(right_side[i].w * xyz(velocity_change[i]));
        });
        const Vector3 u = xyz(component_change_[c]) - sum.mean();
        parallel.ranges(static_cast<std::uint32_t>(particles.size()), [&](const BlockRange& range) {
            for (const std::uint32_t i : particles.subspan(range.begin, range.end - range.begin)) {
                set_xyz(velocity_change[i], xyz(velocity_change[i]) + u);
            }
        });
    }
}

std::size_t MeanMotion::bytes() const noexcept {
    return component_change_.bytes() + partials_.bytes();
}

}  // namespace weft
