#include "demo/study/physics/known_answers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "demo/learn/drape.h"

namespace weft::study {

namespace {

using std::numbers::pi;

constexpr int steps = 2000;

/// Fourth-order Runge-Kutta from 0 to 1, or to `end`; `visit` sees the state at the end of each step.
template <std::size_t size, class Slope, class Visit>
std::array<double, size> integrate(std::array<double, size> y, double end, const Slope& slope,
                                   const Visit& visit) {
    const double h = end / steps;
    const auto moved = [](std::array<double, size> from, const std::array<double, size>& along, double by) {
        for (std::size_t i = 0; i < size; ++i) from[i] += by * along[i];
        return from;
    };
    for (int k = 0; k < steps; ++k) {
        const double s = k * h;
        const auto a = slope(s, y), b = slope(s + h / 2, moved(y, a, h / 2)),
                   c = slope(s + h / 2, moved(y, b, h / 2)), d = slope(s + h, moved(y, c, h));
        for (std::size_t i = 0; i < size; ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        visit(y);
    }
    return y;
}

/// The value at which `above` turns true.
template <class Above>
double bisect(double low, double high, const Above& above) {
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (above(middle) ? high : low) = middle;
    }
    return (low + high) / 2;
}

}  // namespace

double HangingStrip::chord_degrees() const {
    return std::atan2(drop, reach) * 180 / pi;
}

HangingStrip heavy_elastica(double gamma) {
    const Vec2 end = demo::elastica_curve(gamma, 2).back();
    return {.drop = -static_cast<double>(end.y), .reach = static_cast<double>(end.x)};
}

double lateral_buckling_gamma() {
    // In t = 1 - s from the free end: phi'' = -(lambda^2 / 4) t^4 phi, phi' = 0 at t = 0, phi = 0 at the
    // clamp.
    const auto buckled = [](double lambda) {
        bool crossed = false;
        (void)integrate<2>(
            {1, 0}, 1,
            [&](double t, const std::array<double, 2>& y) -> std::array<double, 2> {
                return {y[1], -0.25 * lambda * lambda * t * t * t * t * y[0]};
            },
            [&](const std::array<double, 2>& y) { crossed |= y[0] < 0; });
        return crossed;
    };
    return std::numbers::sqrt2 * bisect(1, 30, buckled);
}

double catenary_sag(double span, double length) {
    // length = 2 a sinh(span / 2 a) grows as a shrinks.
    const double a = 1 / bisect(1e-6, 200 / span, [&](double inverse) {
                         return 2 / inverse * std::sinh(span * inverse / 2) > length;
                     });
    return a * (std::cosh(span / (2 * a)) - 1);
}

double plate_pendulum_period(double length, double amplitude, double gravity) {
    const double a = amplitude * amplitude;
    return 2 * pi * std::sqrt(2 * length / (3 * gravity)) * (1 + a / 16 + 11 * a * a / 3072);
}

double chain_pendulum_period(double length, double gravity) {
    constexpr double first_zero = 2.404825557695773;  // of Bessel's J0
    return 4 * pi / first_zero * std::sqrt(length / gravity);
}

double terminal_speed(double areal_density, double gravity, double air_density, double drag) {
    return std::sqrt(2 * areal_density * gravity / (air_density * drag));
}

double capstan_friction(double shorter, double longer, double radius) {
    const auto holds = [&](double friction) {
        const auto end = integrate<1>(
            {shorter}, pi,
            [&](double phi, const std::array<double, 1>& y) -> std::array<double, 1> {
                return {radius * std::cos(phi) + friction * (y[0] + radius * std::sin(phi))};
            },
            [](const auto&) {});
        return end[0] > longer;
    };
    return bisect(0, 5, holds);
}

double slope_acceleration(double angle, double friction, double gravity) {
    return std::max(0.0, gravity * (std::sin(angle) - friction * std::cos(angle)));
}

}  // namespace weft::study
