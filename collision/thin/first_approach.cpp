#include "collision/thin/first_approach.h"

#include <algorithm>
#include <cmath>

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

// Ericson 2004, 5.1.5.
Nearest nearest_of_triangle(const Core& core, const std::array<Vector3, 3>& x) {
    const auto with = [&](float u, float v, float w) {
        return Nearest{u * x[0] + v * x[1] + w * x[2] - core.a, 0, {u, v, w}};
    };
    const Vector3 ab = x[1] - x[0], ac = x[2] - x[0], ap = core.a - x[0];
    const float d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return with(1, 0, 0);
    const Vector3 bp = core.a - x[1];
    const float d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return with(0, 1, 0);
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const float v = quotient(d1, d1 - d3);
        return with(1 - v, v, 0);
    }
    const Vector3 cp = core.a - x[2];
    const float d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return with(0, 0, 1);
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const float w = quotient(d2, d2 - d6);
        return with(1 - w, 0, w);
    }
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const float w = quotient(d4 - d3, (d4 - d3) + (d5 - d6));
        return with(0, 1 - w, w);
    }
    const float sum = va + vb + vc;
    if (!(sum > 0)) return with(1, 0, 0);
    Nearest nearest = with(va / sum, vb / sum, vc / sum);
    // Exactly across: rounding of long sides would tilt it.
    const Vector3 normal = ab.cross(ac);
    const float squared = normal.squaredNorm();
    if (squared > 0) nearest.out = -(normal.dot(ap) / squared) * normal;
    return nearest;
}

}  // namespace

std::optional<Approach> first_approach(const Cores& cores, const Core& core, const CornerPaths& paths,
                                       const Kept& kept) {
    const float gap = kept.gap;
    constexpr int most_steps = 64;
    constexpr float least_part = 1.0f / 128;  // of the way
    const std::size_t corners = core.is_point() ? 3 : 2;
    const std::array<Vector3, 3>&from = paths.from, &to = paths.to;
    std::array<Vector3, 3> x = from;
    float t = 0;
    for (int step = 0; step < most_steps; ++step) {
        const Nearest nearest =
            core.is_point() ? nearest_of_triangle(core, x) : nearest_of_edge(core, x[0], x[1]);
        const float distance = nearest.out.norm();
        if (!(distance > 1e-7f)) return std::nullopt;  // it began within
        const Vector3 normal = nearest.out / distance;
        const float radius = core.radius_at(nearest.s), wanted = radius + gap, clear = distance - wanted;
        if (kept.only_from_outside && step == 0 && !core.is_point() && distance < radius) return std::nullopt;
        float fastest = 0;
        for (std::size_t k = 0; k < corners; ++k) fastest = std::max(fastest, normal.dot(from[k] - to[k]));
        const bool is_near = clear < 0.05f * gap;
        if (is_near && cores.is_outward(core.at(nearest.s), normal)) {
            const Vector3 foot = core.at(nearest.s);
            Vector3 end = Vector3::Zero();
            float least = std::numeric_limits<float>::infinity();
            for (std::size_t k = 0; k < corners; ++k) {
                end += nearest.weights[k] * to[k];
                least = std::min(least, normal.dot(to[k]));
            }
            const float depth = wanted - normal.dot(end - foot);
            if (depth > 0) return Approach{nearest.weights, foot, normal, depth};
            // The plane between the two is one to the end.
            if (least > std::max(normal.dot(core.a), normal.dot(core.at(1)))) return std::nullopt;
        }
        if (t == 1 || !(fastest > 0)) return std::nullopt;
        // Whatever is near goes no farther than the plane between the two holds.
        const float free = is_near ? std::max(0.8f * distance, least_part * fastest) : clear;
        t = std::min(t + free / fastest, 1.0f);
        for (std::size_t k = 0; k < corners; ++k) x[k] = from[k] + t * (to[k] - from[k]);
    }
    return std::nullopt;
}

}  // namespace weft
