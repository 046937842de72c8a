#include "cloth/air/shelters.h"

#include "collision/shapes/moving_shapes.h"
#include "engine/vector.h"

namespace weft {

namespace {

/// A shelter as the loop reads it.
class Shelter {
  public:
    explicit Shelter(const AirShelter& shelter)
        : middle_(to_vector(shelter.position)),
          half_(shelter.kind == AirShelterKind::box ? to_vector(shelter.half_extents) : Vector3::Zero()),
          radius_(shelter.kind == AirShelterKind::ball ? shelter.radius : 0),
          per_border_(1 / shelter.border),
          exposure_(shelter.exposure) {
        if (shelter.kind == AirShelterKind::box)
            to_own_ = unit(shelter.rotation).conjugate().toRotationMatrix();
    }
    /// The factor of the wind at a point: a smooth step across the border.
    [[nodiscard]] float factor(const Vector3& point) const {
        const Vector3 own = to_own_ * (point - middle_);
        const float outside = (own.cwiseAbs() - half_).cwiseMax(0).norm() - radius_;
        const float t = std::clamp(outside * per_border_, 0.0f, 1.0f);
        return exposure_ + (1 - exposure_) * (t * t * (3 - 2 * t));
    }

  private:
    Vector3 middle_, half_;  // a ball has no extents, a box no radius
    float radius_, per_border_, exposure_;
    Matrix3 to_own_ = Matrix3::Identity();
};

}  // namespace

void shelter_air(Parallel& parallel, const Wind& wind, std::span<const Vec4> points,
                 std::span<Vec4> velocities) {
    parallel.ranges(static_cast<std::uint32_t>(points.size()), [&](const BlockRange& range) {
        for (const AirShelter& each : wind.shelters) {
            if (each.kind == AirShelterKind::none) continue;
            const Shelter shelter(each);
            for (std::uint32_t i = range.begin; i < range.end; ++i)
                set_xyz(velocities[i], shelter.factor(xyz(points[i])) * xyz(velocities[i]));
        }
    });
}

}  // namespace weft
