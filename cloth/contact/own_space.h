#pragma once
// The region that a cloth has to itself in a substep, clear of cloths that are solved in other groups.

#include <algorithm>
#include <limits>

#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// An axis-aligned box, bounded by a plane towards each other cloth's box. The plane is across the axis along
/// which the two boxes are farthest apart, halfway between them; the region ends `floor` [m] before it.
class OwnSpace {
  public:
    OwnSpace(const Bounds& box, float floor)
        : box_lower_(to_vector(box.lower)), box_upper_(to_vector(box.upper)), floor_(floor) {}

    /// Adds the plane towards another box. Precondition: the two boxes are disjoint.
    void keep_from(const Bounds& other) {
        const Vector3 other_lower = to_vector(other.lower), other_upper = to_vector(other.upper);
        const Vector3 above = other_lower - box_upper_, below = box_lower_ - other_upper;
        Eigen::Index axis = 0;  // symmetric: the other cloth finds the same axis
        above.cwiseMax(below).maxCoeff(&axis);
        if (above[axis] > below[axis])
            upper_[axis] = std::min(upper_[axis], 0.5f * (other_lower[axis] + box_upper_[axis]) - floor_);
        else
            lower_[axis] = std::max(lower_[axis], 0.5f * (box_lower_[axis] + other_upper[axis]) + floor_);
    }
    [[nodiscard]] Bounds bounds() const { return {to_vec3(lower_), to_vec3(upper_)}; }

  private:
    static constexpr float infinity_ = std::numeric_limits<float>::infinity();
    Vector3 box_lower_, box_upper_, lower_ = Vector3::Constant(-infinity_), upper_ = -lower_;
    float floor_;
};

}  // namespace weft
