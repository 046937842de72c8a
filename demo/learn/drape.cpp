#include "demo/learn/drape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace weft::demo {

namespace {

/// A hash of the number, from -1 to 1.
float scattered(std::uint32_t number) {
    std::uint32_t h = number * 0x9E3779B9u + 0x7F4A7C15u;
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    return static_cast<float>((h ^ (h >> 13)) >> 8) / 8388608.0f - 1.0f;
}

struct Node {
    float angle;
    std::uint32_t vertex;
};

/// Appends the triangles between two rings; each ends at the next node by angle, of either ring.
void join(const std::vector<Node>& inner, const std::vector<Node>& outer, std::vector<Triangle>& triangles) {
    std::size_t i = 0, o = 0;
    while (i + 1 < inner.size() || o + 1 < outer.size()) {
        const bool on_outer =
            i + 1 == inner.size() || (o + 1 < outer.size() && outer[o + 1].angle <= inner[i + 1].angle);
        const std::uint32_t next = on_outer ? outer[o + 1].vertex : inner[i + 1].vertex;
        triangles.push_back({inner[i].vertex, next, outer[o].vertex});
        ++(on_outer ? o : i);
    }
}

constexpr float square = 1e-3f;  // side of a square of the shadow [m]

/// Marks the squares whose middles are within the triangle, seen from above.
void shade(const std::array<Vec3, 3>& corners, float left, float back, std::size_t across,
           std::vector<char>& dark) {
    const auto [x0, x1] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [z0, z1] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
    const auto first = [](float from) {
        return static_cast<std::size_t>(std::max(0.0f, std::ceil(from / square - 0.5f)));
    };
    for (std::size_t j = first(z0 - back); back + (static_cast<float>(j) + 0.5f) * square <= z1; ++j) {
        for (std::size_t i = first(x0 - left); left + (static_cast<float>(i) + 0.5f) * square <= x1; ++i) {
            const float x = left + (static_cast<float>(i) + 0.5f) * square,
                        z = back + (static_cast<float>(j) + 0.5f) * square;
            std::array<float, 3> side{};
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 &from = corners[k], &to = corners[(k + 1) % 3];
                side[k] = (to.x - from.x) * (z - from.z) - (to.z - from.z) * (x - from.x);
            }
            const auto [least, most] = std::ranges::minmax(side);
            if (least >= 0 || most <= 0) dark[j * across + i] = 1;
        }
    }
}

}  // namespace

Mesh drape_disc(float radius, std::uint32_t rings, const Vec3& middle) {
    constexpr float turn = 2 * std::numbers::pi_v<float>;
    Mesh mesh;
    const auto add = [&](float r, float angle) {
        const auto vertex = static_cast<std::uint32_t>(mesh.positions.size());
        const Vec2 flat{r * std::cos(angle), r * std::sin(angle)};
        mesh.pattern.push_back(flat);
        mesh.positions.push_back(
            {middle.x + flat.x, middle.y + 2e-4f * scattered(vertex), middle.z + flat.y});
        return vertex;
    };
    std::vector<Node> inner{{0, add(0, 0)}};
    for (std::uint32_t ring = 1; ring <= rings; ++ring) {
        const float spacing = turn / static_cast<float>(6 * ring), start = 0.5f * spacing * scattered(ring);
        std::vector<Node> outer;
        for (std::uint32_t k = 0; k < 6 * ring; ++k) {
            const float angle = start + spacing * static_cast<float>(k);
            outer.push_back(
                {angle, add(radius * static_cast<float>(ring) / static_cast<float>(rings), angle)});
        }
        outer.push_back({start + turn, outer.front().vertex});
        join(inner, outer, mesh.triangles);
        inner = std::move(outer);
    }
    return mesh;
}

float shadow_area(const Mesh& mesh, const ClothView& view) {
    const Bounds& box = view.bounds;
    const auto squares = [](float size) {
        return static_cast<std::size_t>(std::clamp(size, 0.0f, 2.0f) / square) + 2;
    };
    const std::size_t across = squares(box.upper.x - box.lower.x), along = squares(box.upper.z - box.lower.z);
    std::vector<char> dark(across * along);
    for (const auto& [a, b, c] : mesh.triangles) {
        std::array<Vec3, 3> corners;
        std::size_t k = 0;
        bool inside = true;
        for (const std::uint32_t vertex : {a, b, c}) {
            const Vec4& p = view.positions[view.vertex_to_particle[vertex]];
            corners[k++] = {p.x, p.y, p.z};
            inside = inside && p.x - box.lower.x <= 2 && p.z - box.lower.z <= 2;
        }
        if (inside) shade(corners, box.lower.x, box.lower.z, across, dark);
    }
    return static_cast<float>(std::ranges::count(dark, 1)) * square * square;
}

float drape_coefficient(float shadow, float table_radius, float disc_radius) {
    const float table = std::numbers::pi_v<float> * table_radius * table_radius;
    const float disc = std::numbers::pi_v<float> * disc_radius * disc_radius;
    return (shadow - table) / (disc - table);
}

namespace {

constexpr int steps = 400;

struct State {
    double angle, curvature, x, y;
};

/// Integrates from the clamp by fourth-order Runge-Kutta; `visit` gets each state, the first one too. Returns
/// the state at the free end.
template <class Visit>
State integrate(double gamma, double curvature, const Visit& visit) {
    const auto slope = [gamma](double s, const State& at) {
        return State{at.curvature, -gamma * (1 - s) * std::cos(at.angle), std::cos(at.angle),
                     std::sin(at.angle)};
    };
    const auto moved = [](const State& from, const State& along, double by) {
        return State{from.angle + by * along.angle, from.curvature + by * along.curvature,
                     from.x + by * along.x, from.y + by * along.y};
    };
    constexpr double h = 1.0 / steps;
    State at{0, curvature, 0, 0};
    visit(at);
    for (int k = 0; k < steps; ++k) {
        const double s = k * h;
        const State a = slope(s, at), b = slope(s + h / 2, moved(at, a, h / 2)),
                    c = slope(s + h / 2, moved(at, b, h / 2)), d = slope(s + h, moved(at, c, h));
        at = moved(moved(moved(moved(at, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
        visit(at);
    }
    return at;
}

}  // namespace

std::vector<Vec2> elastica_curve(double gamma, int points) {
    // Signs are as seen: the strip bends down, so angle and curvature are negative from the clamp on.
    const auto nothing = [](const State&) {};
    double low = -gamma, high = 0;  // bounds of the clamp's curvature; the free end's grows with it
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (integrate(-gamma, middle, nothing).curvature > 0 ? high : low) = middle;
    }
    std::vector<Vec2> dense;
    integrate(-gamma, (low + high) / 2, [&](const State& at) {
        dense.push_back({static_cast<float>(at.x), static_cast<float>(at.y)});
    });
    std::vector<Vec2> curve;
    for (int i = 0; i < points; ++i)
        curve.push_back(dense[static_cast<std::size_t>(std::lround(1.0 * i * steps / (points - 1)))]);
    return curve;
}

}  // namespace weft::demo
