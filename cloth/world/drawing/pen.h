#pragma once
// Draws lines and text on a host's canvas.

#include <array>

#include "engine/vector.h"
#include "weft/collider.h"
#include "weft/debug_draw.h"

namespace weft {

class HeldShape;

class Pen {
  public:
    explicit Pen(const DebugCanvas& canvas) : canvas_(canvas) {}

    void line(const Vector3& from, const Vector3& to, const Vec3& colour) const {
        if (canvas_.line != nullptr) canvas_.line(canvas_.user, to_vec3(from), to_vec3(to), colour);
    }
    void text(const Vector3& at, const char* words, const Vec3& colour) const {
        if (canvas_.text != nullptr) canvas_.text(canvas_.user, to_vec3(at), words, colour);
    }
    /// Three lines of this length along the axes, which cross at `at`.
    void cross(const Vector3& at, float length, const Vec3& colour) const;
    /// The edges of a box, centred at `origin` and aligned with `axes`.
    void box(const Vector3& origin, const Matrix3& axes, const Vector3& half, const Vec3& colour) const;
    void box(const Bounds& bounds, const Vec3& colour) const;
    /// A circle about `centre` in the plane of u and v, whose length is its radius.
    void circle(const Vector3& centre, const Vector3& u, const Vector3& v, const Vec3& colour) const;

  private:
    const DebugCanvas& canvas_;
};

/// `held`: the shape of a PlacedShape. A plane is drawn as far as the box `about` extends, or farther.
void draw_collider(const Pen& pen, const Collider& collider, const HeldShape* held,
                   const Eigen::AlignedBox3f& about, const Vec3& colour);

}  // namespace weft
