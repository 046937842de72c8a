#include "demo/look/collider_motion.h"

#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float jump = 1;  // a longer way in a step was none [m]

float between(float a, float b, float share) {
    return a + share * (b - a);
}
Vec3 between(const Vec3& a, const Vec3& b, float share) {
    const Vector3 way = to_vector(b) - to_vector(a);
    return way.norm() > jump ? b : to_vec3(to_vector(a) + share * way);
}
Rotation between(const Rotation& a, const Rotation& b, float share) {
    const Eigen::Quaternionf from(a.w, a.x, a.y, a.z), to(b.w, b.x, b.y, b.z);
    const Eigen::Quaternionf mean = from.normalized().slerp(share, to.normalized());
    return {mean.x(), mean.y(), mean.z(), mean.w()};
}

Sphere between(const Sphere& a, const Sphere& b, float share) {
    return {between(a.center, b.center, share), between(a.radius, b.radius, share)};
}
Capsule between(const Capsule& a, const Capsule& b, float share) {
    return {between(a.a, b.a, share), between(a.b, b.b, share), between(a.radius, b.radius, share)};
}
TaperedCapsule between(const TaperedCapsule& a, const TaperedCapsule& b, float share) {
    return {between(a.a, b.a, share), between(a.b, b.b, share), between(a.radius_a, b.radius_a, share),
            between(a.radius_b, b.radius_b, share)};
}
Box between(const Box& a, const Box& b, float share) {
    return {between(a.center, b.center, share), between(a.rotation, b.rotation, share),
            between(a.half_extents, b.half_extents, share)};
}

}  // namespace

void ColliderMotion::note(ColliderId id, const Collider& collider, std::uint64_t step) {
    const auto [found, is_new] = motions_.try_emplace(key(id), Motion{collider, collider, step});
    Motion& motion = found->second;
    if (is_new || motion.step == step) {
        motion.now = collider;  // hands may have changed it
        return;
    }
    // Several steps since the last picture share the way out evenly.
    const bool follows = step > motion.step;
    const float share = follows ? 1 - 1 / static_cast<float>(step - motion.step) : 1;
    const Collider last = motion.now;
    motion = {last, collider, step};
    motion.before = at(id, share);
}

Collider ColliderMotion::at(ColliderId id, float share) const {
    const Motion& motion = motions_.at(key(id));
    Collider collider = motion.now;
    std::visit(
        [&](auto& shape) {
            using Shape = std::remove_reference_t<decltype(shape)>;
            const auto* before = std::get_if<Shape>(&motion.before.shape);
            if constexpr (requires { between(shape, shape, share); })
                if (before != nullptr) shape = between(*before, shape, share);
        },
        collider.shape);
    return collider;
}

}  // namespace weft::demo
