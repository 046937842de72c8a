#pragma once
// Points that a skeleton carries along: what of a garment is fixed to the body, and skin.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "demo/character/body/body.h"
#include "weft/error.h"

namespace weft::demo {

enum class Blending : std::uint8_t {
    rigid,         ///< each point with the joint that holds most of it
    linear_blend,  ///< with up to four, and between them where their frames put it (Magnenat-Thalmann 1988)
};

class Binding {
  public:
    Binding() = default;
    /// To the limbs that are nearest in this pose, by the inverse fourth power of the distance from their
    /// surfaces; along a limb whose ends belong to two joints, to both.
    [[nodiscard]] static Binding to_nearest(const Body& body, const Pose& pose, std::span<const Vec3> points,
                                            Blending blending = Blending::linear_blend);
    /// By weights that a file holds: four joints and four weights a point. Error: not four a point, a joint
    /// that the skeleton lacks, weights that are negative, not finite or sum to nothing, each with its point.
    [[nodiscard]] static Result<Binding> by_weights(const Pose& pose, std::span<const Vec3> points,
                                                    std::span<const std::uint32_t> joints,
                                                    std::span<const float> weights);

    /// Writes where the pose takes each point [m]. Precondition: `to` has size() elements.
    void place(const Pose& pose, std::span<Vec3> to) const;
    /// Writes how the pose turns what points there as the points are bound in pose `bound`, of a length up to
    /// its own. Precondition: both have size() elements.
    void turn(const Pose& bound, const Pose& pose, std::span<const Vec3> vectors, std::span<Vec3> to) const;
    [[nodiscard]] std::size_t size() const { return bonds_.size(); }

  private:
    static constexpr std::size_t most = 4;
    struct Bond {
        std::array<std::uint32_t, most> joints{};
        std::array<float, most> weights{};  // sum to 1, descending; 0: no more
        std::array<Vector3, most> local;    // the point in each joint's frame
    };
    static Bond bond(const Pose& pose, const Vector3& point, std::span<const float> weight_of_joint);

    std::vector<Bond> bonds_;
};

/// Of the point's foot on the axis, from 0 at the end a to 1 at b.
[[nodiscard]] float part_along(const TaperedCapsule& capsule, const Vector3& point);

}  // namespace weft::demo
