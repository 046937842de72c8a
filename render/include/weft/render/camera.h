#pragma once
// A camera that orbits a point, and rays through its pixels.

#include <array>

#include "weft/types.h"

namespace weft::render {

using Matrix4 = std::array<float, 16>;  ///< column-major, as OpenGL reads it

struct Ray {
    Vec3 origin;     ///< [m]
    Vec3 direction;  ///< unit length
};

/// Looks at `target` from `distance` away. Yaw turns about +Y, pitch lifts the eye above the horizon.
struct OrbitCamera {
    Vec3 target{0, 0.5f, 0};    ///< [m]
    float distance = 3.0f;      ///< [m], > 0
    float yaw = 0.6f;           ///< [rad]; 0 looks along -Z
    float pitch = 0.25f;        ///< [rad], within +-1.5
    float vertical_fov = 0.7f;  ///< [rad]
    /// Placement beside panels that cover a part of the picture. `shift`: the target's distance left of the
    /// middle, in halves of the picture's width. `shrink`: scale of the picture, > 0.
    float shift = 0, shrink = 1;

    [[nodiscard]] Vec3 eye() const;
    [[nodiscard]] Matrix4 view() const;
    [[nodiscard]] Matrix4 projection(float aspect) const;
    /// The ray through the point (x, y) of the image, both in [0, 1]; (0, 0) is the upper left corner.
    [[nodiscard]] Ray ray(float x, float y, float aspect) const;

    void orbit(float yaw_change, float pitch_change);  ///< [rad]
    void zoom(float factor);                           ///< a factor > 1 moves the eye closer
    void pan(float right, float up);                   ///< in fractions of the image's height
};

}  // namespace weft::render
