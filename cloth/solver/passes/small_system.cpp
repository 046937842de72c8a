#include "cloth/solver/passes/small_system.h"

#include <algorithm>

namespace weft {

Coefficients least_energy(const SmallSystem& s) {
    constexpr double rounding = 1e-5;
    std::array<Coefficients, direction_count> l{};
    Coefficients d{}, y{}, c{};
    for (std::size_t k = 0; k < direction_count; ++k) {
        double left = s.g[k][k], right = s.b[k];
        for (std::size_t m = 0; m < k; ++m) {
            left -= l[k][m] * l[k][m] * d[m];
            right -= l[k][m] * y[m];
        }
        if (!(s.g[k][k] > 0) || !(left > rounding * s.g[k][k])) continue;  // d, y and the column of l stay 0
        d[k] = left;
        y[k] = right;
        for (std::size_t n = k + 1; n < direction_count; ++n) {
            double sum = s.g[n][k];
            for (std::size_t m = 0; m < k; ++m) sum -= l[n][m] * l[k][m] * d[m];
            l[n][k] = sum / left;
        }
    }
    for (std::size_t k = direction_count; k-- > 0;) {
        if (d[k] == 0) continue;
        c[k] = y[k] / d[k];
        for (std::size_t n = k + 1; n < direction_count; ++n) c[k] -= l[n][k] * c[n];
    }
    return c;
}

SmallSystem after_step(const SmallSystem& system, const Coefficients& c) {
    Coefficients of_step{};  // the step's products with W times each direction
    double step_step = 0;
    for (std::size_t k = 0; k < direction_count; ++k) {
        for (std::size_t m = 0; m < direction_count; ++m)
            of_step[k] += c[m] * system.g[std::max(k, m)][std::min(k, m)];
        step_step += c[k] * of_step[k];
    }
    SmallSystem after;
    after.g[change][change] = step_step;
    after.g[motion][change] = of_step[motion] + step_step;
    after.g[motion][motion] = system.g[motion][motion] + 2 * of_step[motion] + step_step;
    return after;
}

}  // namespace weft
