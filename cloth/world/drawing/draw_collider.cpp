#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "cloth/world/drawing/pen.h"
#include "collision/shapes/held_shape.h"
#include "collision/shapes/moving_shapes.h"

namespace weft {

namespace {

/// Two unit vectors, perpendicular to a third and to each other.
std::array<Vector3, 2> across(const Vector3& axis) {
    const Vector3 u = axis.unitOrthogonal();
    return {u, axis.cross(u)};
}

void draw_ball(const Pen& pen, const Vector3& centre, float radius, const Vec3& colour) {
    const Matrix3 axes = radius * Matrix3::Identity();
    for (int k = 0; k < 3; ++k) pen.circle(centre, axes.col(k), axes.col((k + 1) % 3), colour);
}

// The lines touch both balls where their common tangent cone does.
void draw_capsule(const Pen& pen, const Vector3& a, const Vector3& b, float radius_a, float radius_b,
                  const Vec3& colour) {
    draw_ball(pen, a, radius_a, colour);
    draw_ball(pen, b, radius_b, colour);
    const float length = (b - a).norm(), slope = length > 0 ? (radius_a - radius_b) / length : 2.0f;
    if (std::abs(slope) >= 1) return;  // one ball contains the other
    const Vector3 axis = (b - a) / length;
    const auto [u, v] = across(axis);
    const float level = std::sqrt(1 - slope * slope);
    for (const Vector3& side : {u, v, Vector3(-u), Vector3(-v)}) {
        const Vector3 out = slope * axis + level * side;
        pen.line(a + radius_a * out, b + radius_b * out, colour);
    }
}

/// A square of nine lines each way, at least 4 m wide, under or over all of the box.
void draw_plane(const Pen& pen, const Plane& plane, const Eigen::AlignedBox3f& about, const Vec3& colour) {
    constexpr int lines = 4;
    const float spacing = std::max(2.0f, 0.5f * about.diagonal().norm()) / lines;
    const auto [normal, offset] = unit(plane);
    const Vector3 middle = about.center(), centre = middle - (normal.dot(middle) - offset) * normal;
    const auto [u, v] = across(normal);
    for (int k = -lines; k <= lines; ++k) {
        const float along = spacing * static_cast<float>(k), end = spacing * lines;
        pen.line(centre + along * u - end * v, centre + along * u + end * v, colour);
        pen.line(centre + along * v - end * u, centre + along * v + end * u, colour);
    }
}

void draw_triangle(const Pen& pen, const std::array<Vector3, 3>& corners, const Vec3& colour) {
    for (std::size_t k = 0; k < 3; ++k) pen.line(corners[k], corners[(k + 1) % 3], colour);
}

void draw_held(const Pen& pen, const HeldShape& shape, const PlacedShape& place, const Vec3& colour) {
    const Matrix3 axes = unit(place.rotation).toRotationMatrix();
    const Vector3 origin = to_vector(place.position);
    const auto in_world = [&](const Vector3& p) { return Vector3(origin + axes * p); };
    if (const auto* const tree = std::get_if<TriangleTree>(&shape.data())) {
        for (std::uint32_t t = 0; t < tree->size(); ++t) {
            std::array<Vector3, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = in_world(to_vector(tree->vertices()[tree->triangle(t)[k]]));
            draw_triangle(pen, corners, colour);
        }
    } else if (const auto* const ground = std::get_if<HeldHeights>(&shape.data())) {
        for (std::uint32_t row = 0; row < ground->rows; ++row)
            for (std::uint32_t column = 0; column < ground->columns; ++column) {
                const Vector3 here = in_world(ground->vertex(row, column));
                if (column + 1 < ground->columns)
                    pen.line(here, in_world(ground->vertex(row, column + 1)), colour);
                if (row + 1 < ground->rows) pen.line(here, in_world(ground->vertex(row + 1, column)), colour);
            }
    } else {
        pen.box(in_world(shape.box().center()), axes, 0.5f * shape.box().sizes(), colour);
    }
}

}  // namespace

void Pen::cross(const Vector3& at, float length, const Vec3& colour) const {
    for (int k = 0; k < 3; ++k) {
        const Vector3 half = 0.5f * length * Vector3::Unit(k);
        line(at - half, at + half, colour);
    }
}

void Pen::box(const Vector3& origin, const Matrix3& axes, const Vector3& half, const Vec3& colour) const {
    const auto corner = [&](unsigned k) {
        const Vector3 signs((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
        return Vector3(origin + axes * half.cwiseProduct(signs));
    };
    for (unsigned k = 0; k < 8; ++k)
        for (unsigned axis = 1; axis < 8; axis *= 2)
            if ((k & axis) == 0) line(corner(k), corner(k | axis), colour);
}

void Pen::box(const Bounds& bounds, const Vec3& colour) const {
    const Vector3 lower = to_vector(bounds.lower), upper = to_vector(bounds.upper);
    box(0.5f * (lower + upper), Matrix3::Identity(), 0.5f * (upper - lower), colour);
}

void Pen::circle(const Vector3& centre, const Vector3& u, const Vector3& v, const Vec3& colour) const {
    constexpr int sides = 24;
    Vector3 from = centre + u;
    for (int k = 1; k <= sides; ++k) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / sides;
        const Vector3 to = centre + std::cos(angle) * u + std::sin(angle) * v;
        line(from, to, colour);
        from = to;
    }
}

void draw_collider(const Pen& pen, const Collider& collider, const HeldShape* held,
                   const Eigen::AlignedBox3f& about, const Vec3& colour) {
    const auto draw = [&]<class Shape>(const Shape& shape) {
        if constexpr (std::same_as<Shape, Sphere>)
            draw_ball(pen, to_vector(shape.center), shape.radius, colour);
        else if constexpr (std::same_as<Shape, Capsule>)
            draw_capsule(pen, to_vector(shape.a), to_vector(shape.b), shape.radius, shape.radius, colour);
        else if constexpr (std::same_as<Shape, TaperedCapsule>)
            draw_capsule(pen, to_vector(shape.a), to_vector(shape.b), shape.radius_a, shape.radius_b, colour);
        else if constexpr (std::same_as<Shape, Plane>)
            draw_plane(pen, shape, about, colour);
        else if constexpr (std::same_as<Shape, Box>)
            pen.box(to_vector(shape.center), unit(shape.rotation).toRotationMatrix(),
                    to_vector(shape.half_extents), colour);
        else if (held != nullptr)
            draw_held(pen, *held, shape, colour);
    };
    std::visit(draw, collider.shape);
}

}  // namespace weft
