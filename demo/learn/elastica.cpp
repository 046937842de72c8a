#include "demo/learn/elastica.h"

#include <cmath>

namespace weft::demo {
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
