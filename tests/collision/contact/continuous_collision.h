#pragma once
// Whether two features touch on a straight way: an oracle that proves what it denies.
//
// J. M. Snyder, "Interval analysis for computer graphics", 1992; B. Wang et al., "A large-scale benchmark and
// an inclusion-based algorithm for continuous collision detection", 2021. The difference of two points, one
// of each feature, is linear in the time and in each of two coordinates along the features. So over a box of
// the three it lies in the box around its values at the eight corners, but for rounding, which is added. A
// box that is clear of the origin has no collision; others are halved.

#include <array>
#include <cmath>
#include <cstddef>
#include <Eigen/Core>

#include "tests/collision/contact/settle_reference.h"

namespace weft::test {

/// Four corners, of which the first `of_a` are side A, at the start and the end of their ways.
struct MovingPair {
    std::array<Point, 4> start, end;
    std::size_t of_a;

    [[nodiscard]] Point at(std::size_t corner, double time) const {
        return (1 - time) * start[corner] + time * end[corner];
    }
    /// From a point of B to one of A.
    [[nodiscard]] Point difference(double time, double u, double v) const {
        const Point a = at(0, time), b = at(1, time), c = at(2, time), d = at(3, time);
        if (of_a == 1) return a - ((1 - u - v) * b + u * c + v * d);
        return (1 - u) * a + u * b - ((1 - v) * c + v * d);
    }
};

/// Differences shorter than this, along each axis, are taken for contact [m].
inline constexpr double touching = 1e-9;

class CollisionOracle {
  public:
    explicit CollisionOracle(const MovingPair& pair) : pair_(pair) {
        for (const auto* corners : {&pair.start, &pair.end})
            for (const Point& x : *corners) rounding_ = std::max(rounding_, 1e-14 * x.cwiseAbs().maxCoeff());
    }
    /// False: they touch at no time, which is proved. True: they come as near as `touching`.
    [[nodiscard]] bool collide() const { return collide({{{0, 1}, {0, 1}, {0, 1}}}); }

  private:
    struct Interval {
        double least, most;
    };
    using Box = std::array<Interval, 3>;  // of the time, u and v

    [[nodiscard]] bool collide(const Box& box) const {
        const auto& [time, u, v] = box;
        if (pair_.of_a == 1 && u.least + v.least > 1) return false;  // beside the triangle
        Point lower = Point::Constant(1e300), upper = -lower;
        for (const double t : {time.least, time.most})
            for (const double s : {u.least, u.most})
                for (const double r : {v.least, v.most}) {
                    const Point value = pair_.difference(t, s, r);
                    lower = lower.cwiseMin(value);
                    upper = upper.cwiseMax(value);
                }
        if ((lower.array() > rounding_).any() || (upper.array() < -rounding_).any()) return false;
        if ((upper - lower).maxCoeff() < touching) return true;
        return halve(box);
    }
    [[nodiscard]] bool halve(const Box& box) const {
        std::size_t widest = 0;
        double most = -1;
        for (std::size_t k = 0; k < 3; ++k) {
            const double width = change_along(box, k);
            if (width > most) most = width, widest = k;
        }
        Box first = box, second = box;
        const double middle = 0.5 * (box[widest].least + box[widest].most);
        first[widest].most = second[widest].least = middle;
        return collide(first) || collide(second);
    }
    /// How much the difference changes along one side of the box.
    [[nodiscard]] double change_along(const Box& box, std::size_t k) const {
        std::array<double, 3> at = {box[0].least, box[1].least, box[2].least};
        const Point from = pair_.difference(at[0], at[1], at[2]);
        at[k] = box[k].most;
        const double change = (pair_.difference(at[0], at[1], at[2]) - from).norm();
        return change + 1e-12 * (box[k].most - box[k].least);  // of equals, the one that was halved less
    }

    const MovingPair& pair_;
    double rounding_ = 0;
};

inline bool boxes_meet(const MovingPair& pair) {
    Point lower[2], upper[2];
    for (const std::size_t side : {0u, 1u}) {
        lower[side] = Point::Constant(1e300);
        upper[side] = -lower[side];
        const std::size_t begin = side == 0 ? 0 : pair.of_a, end = side == 0 ? pair.of_a : 4;
        for (std::size_t k = begin; k < end; ++k)
            for (const Point& x : {pair.start[k], pair.end[k]}) {
                lower[side] = lower[side].cwiseMin(x);
                upper[side] = upper[side].cwiseMax(x);
            }
    }
    return (lower[0].array() <= upper[1].array()).all() && (lower[1].array() <= upper[0].array()).all();
}

inline bool collides(const MovingPair& pair) {
    return boxes_meet(pair) && CollisionOracle(pair).collide();
}

inline MovingPair moving_pair(const FeaturePair& pair, std::size_t of_a, const Points& start,
                              const Points& end) {
    MovingPair moving{{}, {}, of_a};
    for (std::size_t k = 0; k < 4; ++k) {
        moving.start[k] = start[pair.corners[k]];
        moving.end[k] = end[pair.corners[k]];
    }
    return moving;
}

}  // namespace weft::test
