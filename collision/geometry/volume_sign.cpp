#include "collision/geometry/volume_sign.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace weft {

namespace {

using Row = std::array<double, 3>;

template <class Point>
Row row_of(const Point& p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

template <class Point>
Row difference(const Point& p, const Point& origin) {
    const Row to = row_of(p), from = row_of(origin);
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

/// Shewchuk 1997, error bound A of orient3d: (7 + 56 eps) eps times the permanent, eps = 2^-53. It allows for
/// rounding in every entry of the determinant.
constexpr double relative_error = (7 + 56 * 0x1p-53) * 0x1p-53;

struct Determinant {
    double value, permanent;
    [[nodiscard]] bool has_sign() const { return std::abs(value) > relative_error * permanent; }
};

Determinant determinant(const Row& u, const Row& v, const Row& w) {
    Determinant result{0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double jk = v[j] * w[k], kj = v[k] * w[j];
        result.value += u[i] * (jk - kj);
        result.permanent += std::abs(u[i]) * (std::abs(jk) + std::abs(kj));
    }
    return result;
}

/// Shewchuk 1997, grow-expansion with zero elimination (figure 6): a sum of doubles without rounding. Its
/// components do not overlap and ascend in magnitude.
class ExactSum {
  public:
    void add(double term) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < size_; ++k) {
            // Knuth 1969, two-sum: sum + error = term + component.
            const double component = components_[k], sum = term + component, of_component = sum - term;
            const double error = (term - (sum - of_component)) + (component - of_component);
            if (error != 0) components_[kept++] = error;
            term = sum;
        }
        if (term != 0) components_[kept++] = term;
        size_ = kept;
    }
    /// The largest component decides: the others together are smaller.
    [[nodiscard]] int sign() const {
        if (size_ == 0) return 0;
        return components_[size_ - 1] > 0 ? 1 : -1;
    }

    static constexpr std::size_t most_terms = 48;

  private:
    std::array<double, most_terms> components_;
    std::size_t size_ = 0;
};

/// Adds x y z of three floats. x y fits a double; its two halves times z do, too (Dekker 1971, splitting).
void add_product(ExactSum& sum, double x, double y, double z) {
    const double xy = x * y, scaled = (0x1p27 + 1) * xy;
    const double high = scaled - (scaled - xy), low = xy - high;
    sum.add(high * z);
    sum.add(low * z);
}

/// Adds sign * det(a, b, c).
void add_determinant(ExactSum& sum, double sign, const Row& a, const Row& b, const Row& c) {
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        add_product(sum, sign * a[i], b[j], c[k]);
        add_product(sum, -sign * a[i], b[k], c[j]);
    }
}

/// det(b - a, c - a, d - a) = det(b, c, d) - det(a, c, d) + det(a, b, d) - det(a, b, c).
int exact_volume_sign(const Row& a, const Row& b, const Row& c, const Row& d) {
    ExactSum sum;  // 4 determinants of 6 products of 2 terms
    add_determinant(sum, 1, b, c, d);
    add_determinant(sum, -1, a, c, d);
    add_determinant(sum, 1, a, b, d);
    add_determinant(sum, -1, a, b, c);
    return sum.sign();
}

/// det(n, b - a, c - a) = det(n, b, c) - det(n, a, c) + det(n, a, b).
int exact_area_sign(const Row& a, const Row& b, const Row& c, const Row& n) {
    ExactSum sum;  // 3 determinants of 6 products of 2 terms
    add_determinant(sum, 1, n, b, c);
    add_determinant(sum, -1, n, a, c);
    add_determinant(sum, 1, n, a, b);
    return sum.sign();
}

}  // namespace

int volume_sign(const Vec4& a, const Vec4& b, const Vec4& c, const Vec4& d) noexcept {
    const Determinant volume = determinant(difference(b, a), difference(c, a), difference(d, a));
    if (volume.has_sign()) return volume.value > 0 ? 1 : -1;
    if (volume.permanent == 0) return 0;
    return exact_volume_sign(row_of(a), row_of(b), row_of(c), row_of(d));
}

int area_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) noexcept {
    const Row u = difference(b, a), v = difference(c, a);
    const Determinant area = determinant(row_of(normal), u, v);
    if (area.has_sign()) return area.value > 0 ? 1 : -1;
    if (area.permanent == 0 || row_of(b) == row_of(c)) return 0;
    return exact_area_sign(row_of(a), row_of(b), row_of(c), row_of(normal));
}

}  // namespace weft
