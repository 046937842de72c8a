#include "collision/contact/crossings/untangling.h"

#include <algorithm>
#include <cmath>

namespace weft {

namespace {

// Depth of a row per length of its edge: a greater one would throw the features.
constexpr float depth_per_edge = 0.25f;
// Least |E . N| of a direction with its second term. Below it, the edge lies in the triangle's plane.
constexpr float least_slope = 1e-2f;
// Least length of a contour's mean direction at which its rows keep their depth. Below it, the crossings
// hardly agree: a straight contour has directions at its ends alone, along itself, and they would push one
// sheet sideways off the other.
constexpr float full_agreement = 0.05f;

Vector3 unit(const Vector3& v) {
    const float squared = v.squaredNorm();
    return squared > 0 && std::isfinite(squared) ? Vector3(v / std::sqrt(squared)) : Vector3(0, 0, 0);
}

/// `of / whole`, within 0 .. 1; a half where `whole` is 0.
float part(float of, float whole) {
    return whole != 0 ? std::clamp(of / whole, 0.0f, 1.0f) : 0.5f;
}

/// Weights of the point where the edge passes through the triangle.
std::array<float, 5> weights_of(const Vector3& p, const Vector3& q, const std::array<Vector3, 3>& t,
                                const Vector3& across) {
    const float s = part(across.dot(t[0] - p), across.dot(q - p));
    const Vector3 hit = p + s * (q - p);
    std::array<float, 3> w{};
    float sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 a = t[(k + 1) % 3] - hit, b = t[(k + 2) % 3] - hit;
        w[k] = std::max(across.dot(a.cross(b)), 0.0f);
        sum += w[k];
    }
    if (!(sum > 0)) {
        w = {1, 1, 1};
        sum = 3;
    }
    return {1 - s, s, -w[0] / sum, -w[1] / sum, -w[2] / sum};
}

/// Volino & Magnenat-Thalmann 2006: R_f points along the curve into triangle f beside the edge, and G = sum
/// over f of R_f - 2 N (E . R_f) / (E . N).
Vector3 direction_of(const ContactBody& body, const Crossing& crossing, std::span<const Vec4> positions,
                     const Vector3& across) {
    const Vector3 p = xyz(positions[crossing.edge[0]]), q = xyz(positions[crossing.edge[1]]);
    const Vector3 along = unit(q - p), normal = unit(across);
    const float slope = along.dot(normal);
    Vector3 sum = Vector3::Zero();
    for_each_beside(body, crossing.edge, [&](std::uint32_t, std::uint32_t third) {
        const Vector3 to_third = xyz(positions[third]) - p;
        const Vector3 into = to_third - along.dot(to_third) * along;
        Vector3 curve = unit(normal.cross(along.cross(into)));
        if (curve.dot(into) < 0) curve = -curve;
        sum += curve;
        if (std::abs(slope) > least_slope) sum -= 2 * along.dot(curve) / slope * normal;
    });
    // A straight curve leaves nothing but rounding errors, which must not become a unit direction.
    return sum.squaredNorm() > 1 ? unit(sum) : sum;
}

}  // namespace

void Untangling::lay_out(Scratch& scratch, std::size_t crossings) {
    scratch.take(rows_, crossings);
    scratch.take(means_, crossings);
}

void Untangling::find(std::span<const ContactBody> bodies, std::span<const Vec4> positions,
                      std::span<const Crossing> crossings, const Contours& contours) {
    size_ = static_cast<std::uint32_t>(crossings.size());
    std::fill_n(means_.data(), contours.size(), Vec4{});
    for (std::uint32_t k = 0; k < size_; ++k) {
        const auto& [edge, triangle] = crossings[k];
        const Vector3 p = xyz(positions[edge[0]]), q = xyz(positions[edge[1]]);
        const std::array<Vector3, 3> t{xyz(positions[triangle[0]]), xyz(positions[triangle[1]]),
                                       xyz(positions[triangle[2]])};
        const Vector3 across = (t[1] - t[0]).cross(t[2] - t[0]);
        const Vector3 direction =
            direction_of(bodies[body_of(bodies, edge[0])], crossings[k], positions, across);
        rows_[k] = {.corners = {edge[0], edge[1], triangle[0], triangle[1], triangle[2]},
                    .weights = weights_of(p, q, t, across),
                    .direction = to_vec4(direction, depth_per_edge * (q - p).norm())};
        Vec4& mean = means_[contours.contour_of(k)];
        const float sign = contours.side_of_edge(k) == 0 ? 1.0f : -1.0f;
        mean = to_vec4(xyz(mean) + sign * direction, mean.w + 1);
    }
    for (std::uint32_t k = 0; k < size_; ++k) {
        const Vec4& mean = means_[contours.contour_of(k)];
        const float sign = contours.side_of_edge(k) == 0 ? 1.0f : -1.0f;
        const float agreement = std::min(xyz(mean).norm() / (full_agreement * mean.w), 1.0f);
        Vec4& own = rows_[k].direction;
        own = to_vec4(unit(xyz(own) + sign * unit(xyz(mean))), agreement * own.w);
    }
}

}  // namespace weft
