#include "collision/thin/first_approach.h"

#include <algorithm>
#include <cmath>

#include "collision/geometry/nearest_on_triangle.h"

namespace weft {

namespace {

struct Nearest {
    Vector3 out;                   // from the core to the triangle
    float s;                       // along the core
    std::array<float, 3> weights;  // of corners
};

float quotient(float a, float positive) {
    return positive > 0 ? a / positive : 0;
}
float clamp_to_one(float t) {
    return std::clamp(t, 0.0f, 1.0f);
}

Nearest nearest_of_edge(const Core& core, const Vector3& p, const Vector3& q) {
    const Vector3 d1 = core.axis, d2 = q - p, r = core.a - p;
    const float a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
    const float across = a * e - b * b;
    float s = across > 1e-6f * a * e ? clamp_to_one((b * f - c * e) / across) : 0.5f;
    float t = quotient(b * s + f, e);
    if (t < 0 || t > 1) {
        t = clamp_to_one(t);
        s = clamp_to_one(quotient(b * t - c, a));
    }
    if (core.tilt != 0) {
        const float distance = (p + t * d2 - core.at(s)).norm();
        s = clamp_to_one(s + core.tilt * distance);
        t = clamp_to_one(quotient(d2.dot(core.at(s) - p), e));
    }
    return {p + t * d2 - core.at(s), s, {1 - t, t, 0}};
}

Nearest nearest_of_triangle(const Core& core, const std::array<Vector3, 3>& x) {
    const std::array<float, 3> weights = nearest_on_triangle(core.a, x);
    Nearest nearest{weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2] - core.a, 0, weights};
    if (weights[0] == 0 || weights[1] == 0 || weights[2] == 0) return nearest;
    // Within the face the vector is exactly along the normal: rounding of long sides would tilt it.
    const Vector3 normal = (x[1] - x[0]).cross(x[2] - x[0]);
    const float squared = normal.squaredNorm();
    if (squared > 0) nearest.out = -(normal.dot(core.a - x[0]) / squared) * normal;
    return nearest;
}

/// Early rejection: whether a plane, perpendicular to the line from the core to the corners' centroid,
/// separates the corners' straight paths from the core grown by `by`.
bool is_clear(const Core& core, float by, const CornerPaths& paths, std::size_t corners) {
    Vector3 middle = Vector3::Zero();
    for (std::size_t k = 0; k < corners; ++k) middle += paths.from[k];
    middle /= static_cast<float>(corners);
    const float s = clamp_to_one(quotient(core.axis.dot(middle - core.a), core.axis.squaredNorm()));
    const Vector3 out = middle - core.at(s);
    const float first = out.dot(core.a), last = out.dot(core.at(1));
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < corners; ++k)
        least = std::min({least, out.dot(paths.from[k]), out.dot(paths.to[k])});
    const float radius = std::max(core.radius, core.radius_at(1)) + by;
    return least - std::max(first, last) > radius * out.norm();
}

}  // namespace

std::optional<Approach> first_approach(const Cores& cores, const Core& core, const CornerPaths& paths,
                                       const Kept& kept) {
    const float gap = kept.gap;
    constexpr int most_steps = 64;
    constexpr float least_part = 1.0f / 128;  // of the path
    const std::size_t corners = core.is_point() ? 3 : 2;
    if (is_clear(core, 1.06f * gap, paths, corners)) return std::nullopt;
    const std::array<Vector3, 3>&from = paths.from, &to = paths.to;
    std::array<Vector3, 3> x = from;
    float t = 0;
    for (int step = 0; step < most_steps; ++step) {
        const Nearest nearest =
            core.is_point() ? nearest_of_triangle(core, x) : nearest_of_edge(core, x[0], x[1]);
        const float distance = nearest.out.norm();
        if (!(distance > 1e-7f)) return std::nullopt;  // it begins inside
        const Vector3 normal = nearest.out / distance;
        const float radius = core.radius_at(nearest.s), wanted = radius + gap, clear = distance - wanted;
        if (kept.only_from_outside && step == 0 && !core.is_point() && distance < radius) return std::nullopt;
        float fastest = 0;
        for (std::size_t k = 0; k < corners; ++k) fastest = std::max(fastest, normal.dot(from[k] - to[k]));
        const bool is_near = clear < 0.05f * gap;
        if (is_near && cores.is_outward(core, core.at(nearest.s), normal)) {
            const Vector3 foot = core.at(nearest.s);
            Vector3 end = Vector3::Zero();
            float least = std::numeric_limits<float>::infinity();
            for (std::size_t k = 0; k < corners; ++k) {
                end += nearest.weights[k] * to[k];
                least = std::min(least, normal.dot(to[k]));
            }
            const float depth = wanted - normal.dot(end - foot);
            if (depth > 0) return Approach{nearest.weights, foot, normal, depth};
            // This plane separates the two to the end.
            if (least > std::max(normal.dot(core.a), normal.dot(core.at(1)))) return std::nullopt;
        }
        if (t == 1 || !(fastest > 0)) return std::nullopt;
        // Near the core, a step goes no farther than the plane between the two allows.
        const float free = is_near ? std::max(0.8f * distance, least_part * fastest) : clear;
        t = std::min(t + free / fastest, 1.0f);
        for (std::size_t k = 0; k < corners; ++k) x[k] = from[k] + t * (to[k] - from[k]);
    }
    return std::nullopt;
}

}  // namespace weft
