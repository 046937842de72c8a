#include "engine/least_turn.h"

#include <cmath>

namespace weft {

Eigen::Quaternionf least_turn(const Vector3& from, const Vector3& to) {
    const Vector3 a = from.normalized(), b = to.normalized(), across = a.cross(b);
    const float cosine = b.dot(a);
    Eigen::Quaternionf turn;
    if (cosine <
        -0.999f) {  // nearly opposite: rounding shows in 1 + cosine, and in the direction of `across`
        const Vector3 axis = across.squaredNorm() > 1e-7f ? across.normalized() : a.unitOrthogonal();
        turn.w() = (a + b).norm() / 2;
        turn.vec() = axis * std::sqrt(1 - turn.w() * turn.w());
        return turn;
    }
    const float s = std::sqrt((1 + cosine) * 2), inverse = 1 / s;
    turn.vec() = across * inverse;
    turn.w() = s * 0.5f;
    return turn;
}

}  // namespace weft
