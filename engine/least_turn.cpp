#include "engine/least_turn.h"

#include <cmath>

namespace weft {

Eigen::Quaternionf least_turn(const Vector3& from, const Vector3& to) {
    const Vector3 a = from.normalized(), b = to.normalized(), across = a.cross(b);
    const float cosine = b.dot(a);
    constexpr float nearly_opposite = -0.999f;  // rounding shows in 1 + cosine there, and in `across`
    Eigen::Quaternionf turn;
    if (cosine < nearly_opposite) {
        const Vector3 axis = across.squaredNorm() > 1e-7f ? across.normalized() : a.unitOrthogonal();
        turn.w() = (a + b).norm() / 2;
        turn.vec() = axis * std::sqrt(1 - turn.w() * turn.w());
        return turn;
    }
    const float s = std::sqrt((1 + cosine) * 2);
    turn.vec() = across * (1 / s);
    turn.w() = s / 2;
    return turn;
}

}  // namespace weft
