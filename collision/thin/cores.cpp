#include "collision/thin/cores.h"

#include <algorithm>
#include <cmath>

#include "collision/shapes/moving_shapes.h"

namespace weft {

namespace {

/// Thresholds of Thinness: radius and thickness over triangles' present sides. A rod slips between two rows
/// of particles, a ball between the corners of a triangle.
constexpr float if_fast = 2, if_moved = 1.1f, rod_slips_through = 0.55f, ball_slips_through = 0.8f,
                is_held_in = 0.4f;
/// A collider that moves by less than this part of the thickness in a step stands still.
constexpr float moved = 0.02f;
/// Least motion, in thicknesses, of a body whose edges count. The equation does not know this contact: cloth
/// on edges would not come to rest, nor would a box with mass on cloth. Round cores always count, because
/// cloth on them would fall through.
constexpr float least_way = 0.25f;
/// A frame whose first column is along the axis.
Matrix3 frame_along(const Vector3& axis) {
    Matrix3 frame = Matrix3::Identity();
    const float length = axis.norm();
    if (!(length > 0)) return frame;
    frame.col(0) = axis / length;
    frame.col(1) = frame.col(0).unitOrthogonal();
    frame.col(2) = frame.col(0).cross(frame.col(1));
    return frame;
}

/// The rod inside a box runs along its longest side, and is as thick as its shortest.
InnerRod rod_of(const Vector3& half) {
    int longest = 0;
    half.maxCoeff(&longest);
    const float radius = half.minCoeff();
    float width = radius;
    for (int k = 0; k < 3; ++k)
        if (k != longest) width = std::max(width, half[k]);
    const Vector3 end = (half[longest] - radius) * Vector3::Unit(longest);
    return {-end, end, radius, width};
}

constexpr float thick = std::numeric_limits<float>::infinity();

/// Half width of a shape, and whether its edges can part cloth.
struct Width {
    float half = thick;
    bool has_edges = false, is_ball = false;
};
Width width_of(const Capsule& shape) {
    return {shape.radius, false, to_vector(shape.a) == to_vector(shape.b)};
}
Width width_of(const TaperedCapsule& shape) {
    return {std::min(shape.radius_a, shape.radius_b), false, to_vector(shape.a) == to_vector(shape.b)};
}
Width width_of(const Plane&) {
    return {};
}
Width width_of(const Box& box) {
    const InnerRod rod = rod_of(to_vector(box.half_extents));
    return {rod.width, true, rod.a == rod.b};
}
Width width_of(const HeldInstance& instance) {
    const InnerRod* const rod = instance.shape.rod();
    return {rod != nullptr ? rod->width : thick, instance.shape.is_edged(),
            rod != nullptr && rod->a == rod->b};
}

}  // namespace

Thinness Slipping::as_rod(float side) const {
    if (thin < is_held_in * side) return Thinness::thinnest;
    const float slips_through = is_ball ? ball_slips_through : rod_slips_through;
    if (thin < (moves ? if_moved : slips_through) * side) return Thinness::thin;
    return thin < if_fast * side ? Thinness::thin_if_fast : Thinness::thick;
}

std::optional<Slipping> slipping(const ColliderMotion& motion, float h, float thickness) {
    return with_shapes(motion, [&](const auto& start, const auto& end) -> std::optional<Slipping> {
        const Width width = width_of(end);
        if (width.half == thick && !width.has_edges) return std::nullopt;
        const float way = sweeping(start, end, {h, motion.fastest}, thickness).way;
        if (!(way >= 0)) return std::nullopt;
        const bool by_host = motion.body < 0;
        return Slipping{.thin = width.half + thickness,
                        .is_ball = width.is_ball,
                        .moves = by_host && way > moved * thickness,
                        .has_edges = by_host && width.has_edges,
                        .edges_move = way > least_way * thickness,
                        .way = way};
    });
}

Cores::Cores(const ColliderMotion& motion, float h, bool with_edges) {
    const Pace pace{h, motion.fastest};
    with_shapes(motion, [&]<class Shape>(const Shape& start, const Shape& end) {
        if constexpr (std::is_same_v<Shape, Capsule>) {
            add_round(moving(start, end, pace), 0, 0);
        } else if constexpr (std::is_same_v<Shape, TaperedCapsule>) {
            const MovingTaperedCapsule moved = moving(start, end, pace);
            add_round(moved, moved.wider, moved.tilt);
        } else if constexpr (std::is_same_v<Shape, Box>) {
            add_box(moving(start, end, pace), with_edges);
        } else if constexpr (std::is_same_v<Shape, HeldInstance>) {
            add_held(moving(start, end, pace), with_edges);
        } else {
            static_assert(std::is_same_v<Shape, Plane>, "only a plane has no core");
        }
    });
}

void Cores::add(const Vector3& a, const Vector3& b, float radius_a, float radius_b) {
    Core& core = cores_[count_++];
    core = {.a = a, .axis = b - a, .radius = radius_a, .wider = radius_b - radius_a};
    core.box = Eigen::AlignedBox3f(a - Vector3::Constant(radius_a), a + Vector3::Constant(radius_a));
    core.box.extend(Eigen::AlignedBox3f(b - Vector3::Constant(radius_b), b + Vector3::Constant(radius_b)));
    box_.extend(core.box);
}

void Cores::add_edge(const Vector3& a, const Vector3& b) {
    add(a, b, 0, 0);
    cores_[count_ - 1].is_edge = true;
}

void Cores::add_rod(const InnerRod& rod) {
    if (rod.a != rod.b) add(rod.a, rod.b, rod.radius, rod.radius);
    add(rod.a, rod.a, rod.radius, rod.radius);
    if (rod.a != rod.b) add(rod.b, rod.b, rod.radius, rod.radius);
}

void Cores::take_space(const MovingSpace& space) {
    to_own_ = space.to_own;
    from_start_ = space.to_own_at_start;
    origin_ = space.origin;
    start_origin_ = space.start_origin;
    velocity_ = space.velocity;
    gradient_ = space.spin * space.from_own;
}

void Cores::add_round(const MovingCapsule& capsule, float wider, float tilt) {
    are_round_ = true;
    const bool is_ball = capsule.per_length_squared == 0;
    const Matrix3 frame = is_ball ? Matrix3(Matrix3::Identity()) : frame_along(capsule.axis);
    to_own_ = frame.transpose();
    from_start_ = is_ball ? to_own_ : Matrix3(to_own_ * capsule.turn);
    origin_ = capsule.a;
    start_origin_ = capsule.start_a;
    velocity_ = capsule.velocity;
    gradient_ = Matrix3::Zero();
    const Vector3 a = Vector3::Zero();
    if (is_ball) {
        const float radius = capsule.radius + std::max(wider, 0.0f);
        add(a, a, radius, radius);
        return;
    }
    const float length = capsule.axis.norm();
    const Vector3 b(length, 0, 0);
    gradient_.col(0) = capsule.difference / length;
    const float radius_b = capsule.radius + wider;
    add(a, b, capsule.radius, radius_b);
    cores_[0].tilt = tilt;
    add(a, a, capsule.radius, capsule.radius);
    add(b, b, radius_b, radius_b);
}

void Cores::add_box(const MovingBox& box, bool with_edges) {
    take_space(box.space);
    const Vector3& half = box.half;
    add_rod(rod_of(half));
    if (!with_edges) return;
    for (std::uint32_t k = 0; k < 8; ++k) {
        const auto side = [&](std::uint32_t bit) { return (k & bit) != 0 ? 1.0f : -1.0f; };
        corners_[corner_count_++] = half.cwiseProduct(Vector3(side(1), side(2), side(4)));
    }
    for (std::uint32_t k = 0; k < 8; ++k) {
        add_edge(corners_[k], corners_[k]);
        for (const std::uint32_t bit : {1u, 2u, 4u})
            if ((k & bit) == 0) add_edge(corners_[k], corners_[k | bit]);
    }
}

// Edges between coplanar faces are no edges of the body; counting them costs time alone.
void Cores::add_held(const MovingHeld& held, bool with_edges) {
    take_space(held.space);
    if (held.shape->rod() != nullptr) add_rod(*held.shape->rod());
    if (!with_edges || !held.shape->is_edged()) return;
    const auto& tree = std::get<TriangleTree>(held.shape->data());
    for (const Vec3& corner : tree.vertices()) {
        corners_[corner_count_++] = to_vector(corner);
        add_edge(to_vector(corner), to_vector(corner));
    }
    for (std::uint32_t t = 0; t < tree.size(); ++t) {
        const Corners& corners = tree.triangle(t);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t i = corners[k], j = corners[(k + 1) % 3];  // each edge comes both ways
            if (i < j && count_ < most) add_edge(corners_[i], corners_[j]);
        }
    }
}

Vector3 Cores::velocity_at(const Vector3& own) const {
    return velocity_ + gradient_ * own;
}

bool Cores::is_outward(const Core& core, const Vector3& own, const Vector3& direction) const {
    if (!core.is_edge) return true;
    constexpr float slack = 0.05f;  // for rounding, and for bodies that turn on the way
    for (std::uint32_t k = 0; k < corner_count_; ++k) {
        const Vector3 to_corner = corners_[k] - own;
        if (direction.dot(to_corner) > slack * to_corner.norm()) return false;
    }
    return true;
}

}  // namespace weft
