#include "cloth/bodies/body_contacts.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <Eigen/Geometry>

#include "collision/colliders/nearest_surface.h"
#include "collision/geometry/surfaces.h"
#include "collision/shapes/held_shape.h"
#include "collision/shapes/moving_shapes.h"

namespace weft {

namespace {

/// All balls about the points of a segment, their radii going evenly from one end's to the other's.
struct Edge {
    Vector3 a, b;
    float radius_a, radius_b;

    [[nodiscard]] Vector3 at(float t) const { return a + t * (b - a); }
    [[nodiscard]] float radius(float t) const { return radius_a + t * (radius_b - radius_a); }
};

/// Visits what a collider consists of: ball(centre, radius) of each corner, and its edges.
template <class Ball, class OfEdge>
void for_each_corner(const Collider& collider, const HeldShape* held, const Ball& ball, const OfEdge& edge) {
    const auto round = [&](const Edge& axis) {
        ball(axis.a, axis.radius_a);
        ball(axis.b, axis.radius_b);
        edge(axis);
    };
    const auto visit = [&]<class Kind>(const Kind& shape) {
        if constexpr (std::is_same_v<Kind, Sphere>) {
            ball(to_vector(shape.center), shape.radius);
        } else if constexpr (std::is_same_v<Kind, Capsule>) {
            round({to_vector(shape.a), to_vector(shape.b), shape.radius, shape.radius});
        } else if constexpr (std::is_same_v<Kind, TaperedCapsule>) {
            round({to_vector(shape.a), to_vector(shape.b), shape.radius_a, shape.radius_b});
        } else if constexpr (std::is_same_v<Kind, Box>) {
            const Matrix3 axes = unit(shape.rotation).toRotationMatrix();
            const auto corner = [&](unsigned k) -> Vector3 {
                const Vector3 half = to_vector(shape.half_extents);
                return to_vector(shape.center) + axes * Vector3((k & 1u) != 0 ? half.x() : -half.x(),
                                                                (k & 2u) != 0 ? half.y() : -half.y(),
                                                                (k & 4u) != 0 ? half.z() : -half.z());
            };
            for (unsigned k = 0; k < 8; ++k) {
                ball(corner(k), 0.0f);
                for (const unsigned along : {1u, 2u, 4u})
                    if ((k & along) == 0) edge(Edge{corner(k), corner(k | along), 0, 0});
            }
        } else if constexpr (std::is_same_v<Kind, PlacedShape>) {
            const BodyPose pose{to_vector(shape.position), unit(shape.rotation)};
            for (const Vec3& corner : held->corners()) ball(pose * to_vector(corner), 0.0f);
        } else {
            static_assert(std::is_same_v<Kind, Plane>);  // it has no corners
        }
    };
    std::visit(visit, collider.shape);
}

/// Visits the triangles of a mesh or of heights whose boxes overlap `box`, all in the shape's own space.
template <class Visit>
void for_each_triangle(const HeldShape& held, const Eigen::AlignedBox3f& box, const Visit& triangle) {
    const auto visit = [&](const std::array<Vector3, 3>& corners) {
        const Eigen::AlignedBox3f own(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
                                      corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]));
        if (own.intersects(box)) triangle(corners);
    };
    if (const auto* const heights = std::get_if<HeldHeights>(&held.data())) {
        const auto cells = [&](float at, std::uint32_t corners) {
            return static_cast<std::uint32_t>(
                std::clamp(at / heights->spacing, 0.0f, static_cast<float>(corners - 1)));
        };
        const std::uint32_t last_row = std::min(cells(box.max().z(), heights->rows) + 1, heights->rows - 1),
                            last = std::min(cells(box.max().x(), heights->columns) + 1, heights->columns - 1);
        for (std::uint32_t r = cells(box.min().z(), heights->rows); r < last_row; ++r)
            for (std::uint32_t c = cells(box.min().x(), heights->columns); c < last; ++c)
                for (const int half : {0, 1}) visit(heights->triangle(r, c, half));
    } else if (const auto* const tree = std::get_if<TriangleTree>(&held.data())) {
        const auto below = [&](const auto& self, const TriangleTree::Node& node) -> void {
            if (!box.intersects(Eigen::AlignedBox3f(to_vector(node.lower), to_vector(node.upper)))) return;
            for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
                const auto corner = [&](std::size_t k) {
                    return to_vector(tree->vertices()[tree->triangle(t)[k]]);
                };
                visit({corner(0), corner(1), corner(2)});
            }
            if (node.count == 0)
                for (const std::uint32_t child : {node.first, node.first + 1})
                    self(self, tree->nodes()[child]);
        };
        below(below, tree->nodes().front());
    }
}

/// Visits the corners and edges of a shape's triangles within `reach` of a collider, at most within twice its
/// radius, as many triangles would be in reach of a fast one: see for_each_corner().
template <class Ball, class OfEdge>
void for_each_corner_near(const ColliderMotion& shape, const Collider& to, const HeldShape* held, float reach,
                          const Ball& ball, const OfEdge& edge) {
    const PlacedShape& placed = std::get<PlacedShape>(shape.end.shape);
    const BodyPose pose{to_vector(placed.position), unit(placed.rotation)};
    const Sphere about = ball_around(to, held);
    const Vector3 centre = pose.inverse() * to_vector(about.center);
    const Vector3 half = Vector3::Constant(about.radius + std::min(reach, about.radius));
    const bool with_edges = !std::holds_alternative<PlacedShape>(to.shape);
    for_each_triangle(*shape.held, {centre - half, centre + half},
                      [&](const std::array<Vector3, 3>& corners) {
                          for (std::size_t k = 0; k < 3; ++k) {
                              const Vector3 a = pose * corners[k], b = pose * corners[(k + 1) % 3];
                              ball(a, 0.0f);
                              if (with_edges) edge(Edge{a, b, 0, 0});
                          }
                      });
}

/// Nearest surface points of another collider, for the ball of each corner and for the nearest ball of each
/// edge. Golden sections find that one: beside a convex body the signed distance is convex along an edge.
/// Calls visit(centre, radius, nearest surface point).
template <class Visit>
struct NearBalls {
    const Collider& other;
    const HeldShape* held;
    float sight;  ///< [m]
    const Visit& visit;

    [[nodiscard]] SurfacePoint nearest(const Vector3& centre, float radius) const {
        return nearest_surface(other, centre, held, sight + radius);
    }
    void operator()(const Vector3& centre, float radius) const {
        visit(centre, radius, nearest(centre, radius));
    }
    void operator()(const Edge& edge) const {
        if (std::holds_alternative<Plane>(other.shape)) return;  // an end is nearest
        constexpr int sections = 14;
        constexpr float golden = 0.618034f, nearer = 1e-5f;  // [m]
        const float length = (edge.b - edge.a).norm();
        const auto gap = [&](float t) {
            return nearest(edge.at(t), edge.radius(t) + length).distance - edge.radius(t);
        };
        float lower = 0, upper = 1, left = 1 - golden, right = golden;
        float at_left = gap(left), at_right = gap(right);
        for (int k = 0; k < sections; ++k) {
            const bool is_left = at_left < at_right;
            (is_left ? upper : lower) = is_left ? right : left;
            if (is_left) {
                right = left;
                at_right = at_left;
                at_left = gap(left = upper - golden * (upper - lower));
            } else {
                left = right;
                at_left = at_right;
                at_right = gap(right = lower + golden * (upper - lower));
            }
        }
        // An edge that is nearest at an end has no contact besides those of its corners.
        const float t = 0.5f * (lower + upper);
        if (gap(t) < std::min(gap(0), gap(1)) - nearer) (*this)(edge.at(t), edge.radius(t));
    }
};

/// The velocity of a rigid collider's material at a point, from its poses at both ends of a part.
Vector3 surface_velocity(const ColliderMotion& motion, const Vector3& point, float h) {
    const auto of_poses = [&](const BodyPose& start, const BodyPose& end) -> Vector3 {
        return (point - start * (end.inverse() * point)) / h;
    };
    const auto visit = [&]<class Kind>(const Kind& end) -> Vector3 {
        const Kind& start = std::get<Kind>(motion.start.shape);
        if constexpr (std::is_same_v<Kind, Sphere>) {
            return (to_vector(end.center) - to_vector(start.center)) / h;
        } else if constexpr (std::is_same_v<Kind, Plane>) {
            const Vector3 normal = to_vector(end.normal).stableNormalized();
            return (end.offset - start.offset) / h * normal;
        } else if constexpr (std::is_same_v<Kind, Box>) {
            return of_poses({to_vector(start.center), unit(start.rotation)},
                            {to_vector(end.center), unit(end.rotation)});
        } else if constexpr (std::is_same_v<Kind, PlacedShape>) {
            return of_poses({to_vector(start.position), unit(start.rotation)},
                            {to_vector(end.position), unit(end.rotation)});
        } else {
            const Vector3 a = to_vector(end.a), axis = to_vector(end.b) - a;
            const float squared = axis.squaredNorm();
            const float t = squared > 0 ? std::clamp((point - a).dot(axis) / squared, 0.0f, 1.0f) : 0.0f;
            return ((1 - t) * (a - to_vector(start.a)) + t * (to_vector(end.b) - to_vector(start.b))) / h;
        }
    };
    return std::visit(visit, motion.end.shape);
}

}  // namespace

void BodyContacts::add(const Collider& attached, const HeldShape* held, const BodyPose& pose,
                       const ColliderMotion& other, float reach) {
    const Collider own = carried(attached, pose);
    const float thickness = thickness_between(own.thickness, other.end.thickness);
    const float friction = friction_between(own.friction, other.end.friction);
    const float restitution = restitution_between(own.restitution, other.end.restitution);
    const float sight = reach + thickness;
    const auto contact = [&](const Vector3& on_other, const Vector3& normal, float gap) {
        if (!(gap - thickness < reach)) return;
        nearest_ = std::min(nearest_, gap - thickness);
        const Vector3 on_own = on_other + gap * normal;
        const Vector3 gone = on_own - body_.start * (pose.inverse() * on_own);
        add({.arm = (on_own - pose.position).cast<double>(),
             .normal = normal.cast<double>(),
             .surface = surface_velocity(other, on_other, body_.h).cast<double>(),
             .gap = static_cast<double>(gap - thickness - normal.dot(gone)),
             .friction = static_cast<double>(friction),
             .restitution = static_cast<double>(restitution)});
    };
    const auto of_own = [&](const Vector3&, float radius, const SurfacePoint& on_other) {
        contact(on_other.point, on_other.normal, on_other.distance - radius);
    };
    const auto of_other = [&](const Vector3& centre, float radius, const SurfacePoint& on_own) {
        contact(centre - radius * on_own.normal, -on_own.normal, on_own.distance - radius);
    };
    const NearBalls from_own{other.end, other.held, sight, of_own};
    const NearBalls from_other{own, held, sight, of_other};
    for_each_corner(own, held, from_own, from_own);
    if (std::holds_alternative<Sphere>(own.shape)) return;  // its centre says all
    if (std::holds_alternative<PlacedShape>(other.end.shape))
        for_each_corner_near(other, own, held, reach + thickness, from_other, from_other);
    else
        for_each_corner(other.end, other.held, from_other, from_other);
}

void BodyContacts::add(const Contact& contact) {
    constexpr double same = 1e-8;  // [m^2]: corners that several triangles share
    const std::span<Contact> known = std::span(contacts_).first(count_);
    const auto again = std::ranges::find_if(known, [&](const Contact& other) {
        return (other.arm - contact.arm).squaredNorm() < same && other.normal.dot(contact.normal) > 0.99;
    });
    if (again == known.end() && count_ < most) {
        contacts_[count_++] = contact;
        return;
    }
    Contact& farthest = again != known.end() ? *again : *std::ranges::max_element(known, {}, &Contact::gap);
    if (contact.gap < farthest.gap) farthest = contact;
}

// A contact allows the approach that closes its gap by the end of the part. Penetration at the start opens at
// a limited speed, relative to the collider. At a contact the body yields as `mobility` says: the change of
// its velocity there, by an impulse.
Vector6 BodyContacts::impulse() const {
    constexpr int most_rounds = 50;
    constexpr double opening = 0.1;  // [m/s]
    constexpr double still = 1e-5;   // change of velocity in a round [m/s]
    struct Row {
        Eigen::Matrix<double, 6, 3> moves;  // velocity of the body, by an impulse here
        Eigen::Matrix3d mobility;
        double yielding, least;  // along the normal
        Eigen::Vector3d given = Eigen::Vector3d::Zero();
    };
    const double h = static_cast<double>(body_.h);
    const double slow = 2 * (body_.now - body_.velocity).head<3>().norm();  // what is slower does not bounce
    const Matrix6 inverse_mass = body_.root * body_.root.transpose();
    const auto velocity = [](const Contact& at, const Vector6& of) -> Eigen::Vector3d {
        return of.head<3>() + Eigen::Vector3d(of.tail<3>()).cross(at.arm);
    };
    std::array<Row, most> rows;
    for (std::size_t k = 0; k < count_; ++k) {
        const Contact& at = contacts_[k];
        Row& row = rows[k];
        for (int axis = 0; axis < 3; ++axis) {
            row.moves.col(axis) = inverse_mass * wrench(at.arm, Eigen::Vector3d::Unit(axis));
            row.mobility.col(axis) = velocity(at, row.moves.col(axis));
        }
        row.yielding = at.normal.dot(row.mobility * at.normal);
        const double along = at.normal.dot(at.surface), opens = -at.gap / h - along;
        const double impact = at.normal.dot(velocity(at, body_.now)) - along;
        row.least = along + std::min(opens, opening);
        if (impact < opens && impact < -slow) {
            // The body leaves at the speed that it would have at this gap on its way up.
            const double fall = -at.normal.dot((body_.now - body_.velocity).head<3>()) / h;
            const double squared = std::pow(at.restitution * impact, 2) - 2 * std::max(0.0, fall * at.gap);
            if (squared > 0) row.least = std::max(row.least, along + std::sqrt(squared));
        }
    }
    Vector6 sum = Vector6::Zero(), now = body_.now;
    double change = 2 * still;
    for (int round = 0; round < most_rounds && change > still; ++round) {
        change = 0;
        for (std::size_t k = 0; k < count_; ++k) {
            const Contact& at = contacts_[k];
            Row& row = rows[k];
            if (!(row.yielding > 0)) continue;
            const Eigen::Vector3d v = velocity(at, now);
            const double pressed = at.normal.dot(row.given);
            const double pressing = std::max(0.0, pressed + (row.least - at.normal.dot(v)) / row.yielding);
            if (pressing == 0 && pressed == 0) continue;
            Eigen::Vector3d slip = v + (pressing - pressed) * (row.mobility * at.normal) - at.surface;
            slip -= at.normal.dot(slip) * at.normal;
            Eigen::Vector3d rubbing = row.given - pressed * at.normal;
            const double eases = slip.dot(row.mobility * slip);
            if (eases > 0) rubbing -= slip.squaredNorm() / eases * slip;
            const double limit = at.friction * pressing, length = rubbing.norm();
            if (length > limit) rubbing *= limit / length;
            const Eigen::Vector3d more = pressing * at.normal + rubbing - row.given;
            row.given += more;
            sum += wrench(at.arm, more);
            now += row.moves * more;
            change = std::max(change, (row.mobility * more).norm());
        }
    }
    return sum;
}

}  // namespace weft
