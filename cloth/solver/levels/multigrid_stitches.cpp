// The stitches of sewn cloth in its levels, and in the first and last step of a cycle.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "cloth/equation/seam_rows.h"
#include "cloth/solver/levels/multigrid.h"

namespace weft {

template <class Visit>
void Multigrid::for_each_side(const Visit& visit) const {
    for (const Part& part : parts_) {
        if (part.system == nullptr) continue;
        for (SeamRows* seam : part.equation->seams) visit(*seam, part);
    }
}

template <class Body>
void Multigrid::for_each_end(const Body& body) const {
    for (const std::uint32_t particle : stitched_) {
        const Part& part = part_of(particle);
        if (part.system != nullptr) body(part, particle - part.first, particle);
    }
}

// Stitches along one link, which lie in one direction, are one block.
void Multigrid::sum_stitches() {
    if (!is_common()) return;
    std::ranges::fill(springs_.span().last(stitches_.size()), Vec4{});
    const Numbering number = numbering();
    for_each_side([&](const SeamRows& seam, const Part& part) {
        if (!seam.is_led_by(part.equation->first)) return;
        seam.for_each_active_of(part.equation->first, part.count, [&](const PairRows::ActivePair& active) {
            const std::uint32_t a = number(active.pair.corners[0]), b = number(active.pair.corners[2]);
            if (a == Numbering::none || b == Numbering::none)
                return hold(active.pair.corners[a == Numbering::none ? 2 : 0], 1, active.stiffness());
            const std::uint32_t place = place_of_stitch({std::min(a, b), std::max(a, b)});
            if (place == none) return;
            Vec4& block = springs_[place];
            const float along = std::max(active.spring - active.damper, 0.0f);
            block = to_vec4(std::sqrt(xyz(block).squaredNorm() + along) * xyz(active.shape.normal),
                            block.w + active.damper);
        });
    });
}

template <class Of>
void Multigrid::multiply_stitches(const Of& of_part) {
    for_each_end([&](const Part& part, std::uint32_t i, std::uint32_t) { of_part(part)[i] = {}; });
    for_each_side(
        [&](SeamRows& seam, const Part& part) { seam.take(part.equation->first, of(part, smooth_)); });
    for_each_side([&](SeamRows& seam, const Part& part) {
        if (seam.is_led_by(part.equation->first)) seam.multiply();
    });
    for_each_side([&](const SeamRows& seam, const Part& part) {
        seam.add_products(part.equation->first, of_part(part));
    });
}

// The systems' own products leave out what a stitch does to one end where the other moves.
void Multigrid::subtract_stitches() {
    if (!is_common()) return;
    for_each_end([&](const Part& part, std::uint32_t i, std::uint32_t) {
        part.system->precondition_group(i, part.r, finest_step, of(part, smooth_));
    });
    multiply_stitches([&](const Part& part) { return part.z; });
    for_each_end([&](const Part& part, std::uint32_t i, std::uint32_t at) {
        remainder_[at] = to_vec4(xyz(remainder_[at]) - xyz(part.z[i]), 0);
    });
}

void Multigrid::relax_stitches() {
    if (!is_common()) return;
    const FreeRows p{coarse_.front().interpolation(), pinned_.data()};
    const std::span<const Vec4> coarse = coarse_.front().x();
    for_each_end([&](const Part& part, std::uint32_t i, std::uint32_t) {
        part.system->precondition_group(i, part.r, finest_step, of(part, smooth_));
    });
    for_each_end([&](const Part&, std::uint32_t, std::uint32_t at) {
        Vector3 x = xyz(smooth_[at]);
        const auto [nodes, weights] = p[at];
        for (std::uint32_t k = 0; k < Interpolation::width; ++k) x += weights[k] * xyz(coarse[nodes[k]]);
        smooth_[at] = to_vec4(x, 0);
    });
    multiply_stitches([&](const Part& part) { return of(part, remainder_); });
    for_each_end([&](const Part& part, std::uint32_t i, std::uint32_t) {
        part.system->precondition_group(i, of(part, remainder_), finest_step, of(part, smooth_));
    });
    for_each_end([&](const Part& part, std::uint32_t i, std::uint32_t at) {
        part.z[i] = to_vec4(xyz(part.z[i]) - xyz(smooth_[at]), 0);
    });
}

}  // namespace weft
