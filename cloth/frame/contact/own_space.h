#pragma once
// The part of space that a cloth has to itself in a substep, beside cloths that are not solved with it.

#include <algorithm>
#include <limits>

#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// All that is on the cloth's side of planes, each halfway between its box and another's, across the axis
/// along which the two are farthest apart, and by `floor` off it [m].
class OwnSpace {
  public:
    OwnSpace(const Bounds& box, float floor)
        : box_lower_(to_vector(box.lower)), box_upper_(to_vector(box.upper)), floor_(floor) {}

    /// Of a box that is clear of this one. `is_first`: of the two cloths this one has the lower number, which
    /// decides where two axes are as good.
    void keep_from(const Bounds& other, bool is_first) {
        const Vector3 other_lower = to_vector(other.lower), other_upper = to_vector(other.upper);
        Eigen::Index above = 0, below = 0;
        const float gap_above = (other_lower - box_upper_).maxCoeff(&above);
        const float gap_below = (box_lower_ - other_upper).maxCoeff(&below);
        if (gap_above > gap_below || (gap_above == gap_below && is_first))
            upper_[above] = std::min(upper_[above], 0.5f * (other_lower[above] + box_upper_[above]) - floor_);
        else
            lower_[below] = std::max(lower_[below], 0.5f * (box_lower_[below] + other_upper[below]) + floor_);
    }
    [[nodiscard]] Bounds bounds() const { return {to_vec3(lower_), to_vec3(upper_)}; }

  private:
    static constexpr float infinity_ = std::numeric_limits<float>::infinity();
    Vector3 box_lower_, box_upper_, lower_ = Vector3::Constant(-infinity_), upper_ = -lower_;
    float floor_;
};

}  // namespace weft
