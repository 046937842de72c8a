#include "collision/shapes/cores.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "collision/shapes/moving_shapes.h"
#include "engine/vector.h"

namespace weft {

namespace {

// A flat triangle over a cylinder of this many of its edges dips into it by a sixteenth of one.
constexpr float thin_per_edge = 2;

constexpr std::uint32_t box_corners = 8;

Vector3 corner_sign(std::uint32_t corner) {
    const auto sign = [&](std::uint32_t axis) { return (corner >> axis & 1) != 0 ? 1.0f : -1.0f; };
    return {sign(0), sign(1), sign(2)};
}

const ContactMesh& core_of_box() {
    static const ContactMesh mesh = [] {
        std::array<Vec4, box_corners> corners{};
        std::vector<ContactMesh::Edge> edges;
        for (std::uint32_t c = 0; c < box_corners; ++c) {
            corners[c] = to_vec4(corner_sign(c), 0);
            for (std::uint32_t axis = 0; axis < 3; ++axis)
                if ((c >> axis & 1) == 0) edges.push_back({c, c | 1u << axis});
        }
        return ContactMesh(corners, edges);
    }();
    return mesh;
}

const ContactMesh& core_of_capsule() {
    static const ContactMesh mesh = [] {
        const std::array<Vec4, 2> ends{{{0, 0, 0, 0}, {1, 0, 0, 0}}};
        const std::array<ContactMesh::Edge, 1> axis{{{0, 1}}};
        return ContactMesh(ends, axis);
    }();
    return mesh;
}

const ContactMesh& core_of_sphere() {
    static const ContactMesh mesh = [] {
        const std::array<Vec4, 1> centre{};
        return ContactMesh(centre, std::span<const ContactMesh::Edge>());
    }();
    return mesh;
}

/// x -> turn (x - from) + to.
CommonMotion rigid(const Vector3& from, const Vector3& to, const Matrix3& turn) {
    return {.centre = from,
            .translation = to - from,
            .linear = turn - Matrix3::Identity(),
            .inverse = turn.transpose(),
            .kind = CommonMotionKind::rigid};
}

Matrix3 turn_of(const Rotation& from, const Rotation& to) {
    if (from.x == to.x && from.y == to.y && from.z == to.z && from.w == to.w) return Matrix3::Identity();
    return (unit(to) * unit(from).conjugate()).toRotationMatrix();
}

/// The least turn that takes one direction to another; neither need have a length.
Matrix3 least_turn(const Vector3& from, const Vector3& to) {
    const float lengths = from.squaredNorm() * to.squaredNorm();
    if (from == to || !(lengths > 0 && lengths < std::numeric_limits<float>::infinity()))
        return Matrix3::Identity();
    return Eigen::Quaternionf::FromTwoVectors(from, to).toRotationMatrix();
}

Vector3 middle(const Vec3& a, const Vec3& b) {
    return 0.5f * (to_vector(a) + to_vector(b));
}

CommonMotion rigid_of_axis(const Vec3& from_a, const Vec3& from_b, const Vec3& to_a, const Vec3& to_b) {
    return rigid(middle(from_a, from_b), middle(to_a, to_b),
                 least_turn(to_vector(from_b) - to_vector(from_a), to_vector(to_b) - to_vector(to_a)));
}

}  // namespace

const ContactMesh* core_of(const Collider& collider, float edge) {
    const auto is_thin = [&](float radius) { return radius < thin_per_edge * edge; };
    if (const auto* const sphere = std::get_if<Sphere>(&collider.shape))
        return is_thin(sphere->radius) ? &core_of_sphere() : nullptr;
    if (const auto* const capsule = std::get_if<Capsule>(&collider.shape))
        return is_thin(capsule->radius) ? &core_of_capsule() : nullptr;
    if (const auto* const limb = std::get_if<TaperedCapsule>(&collider.shape))
        return is_thin(std::min(limb->radius_a, limb->radius_b)) ? &core_of_capsule() : nullptr;
    if (std::holds_alternative<Box>(collider.shape)) return &core_of_box();
    return nullptr;
}

const ContactMesh& largest_core() {
    return core_of_box();
}

void place_core(const Collider& collider, std::span<Vec4> points) {
    const auto place = [](const Vec3& at, float radius) { return to_vec4(to_vector(at), radius); };
    if (const auto* const sphere = std::get_if<Sphere>(&collider.shape)) {
        points[0] = place(sphere->center, sphere->radius);
    } else if (const auto* const capsule = std::get_if<Capsule>(&collider.shape)) {
        points[0] = place(capsule->a, capsule->radius);
        points[1] = place(capsule->b, capsule->radius);
    } else if (const auto* const limb = std::get_if<TaperedCapsule>(&collider.shape)) {
        points[0] = place(limb->a, limb->radius_a);
        points[1] = place(limb->b, limb->radius_b);
    } else if (const auto* const box = std::get_if<Box>(&collider.shape)) {
        const Matrix3 from_own = unit(box->rotation).toRotationMatrix();
        for (std::uint32_t c = 0; c < box_corners; ++c) {
            const Vector3 own = corner_sign(c).cwiseProduct(to_vector(box->half_extents));
            points[c] = to_vec4(to_vector(box->center) + from_own * own, 0);
        }
    }
}

CommonMotion motion_of_core(const ColliderMotion& motion) {
    return std::visit(
        [&]<class Kind>(const Kind& end) {
            const Kind& start = *std::get_if<Kind>(&motion.start.shape);
            if constexpr (std::is_same_v<Kind, Sphere>)
                return rigid(to_vector(start.center), to_vector(end.center), Matrix3::Identity());
            else if constexpr (std::is_same_v<Kind, Capsule> || std::is_same_v<Kind, TaperedCapsule>)
                return rigid_of_axis(start.a, start.b, end.a, end.b);
            else if constexpr (std::is_same_v<Kind, Box>)
                return rigid(to_vector(start.center), to_vector(end.center),
                             turn_of(start.rotation, end.rotation));
            else
                return CommonMotion{};
        },
        motion.end.shape);
}

bool has_jumped(const ColliderMotion& motion, float h) {
    return with_shapes(motion, [&](const auto& start, const auto& end) {
        return sweeping(start, end, {h, motion.fastest}, 0).way < 0;
    });
}

}  // namespace weft
