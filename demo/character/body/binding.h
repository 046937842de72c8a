#pragma once
// Points attached to a skeleton's joints: fixed vertices of garments, and skin.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "demo/character/body/body.h"
#include "weft/error.h"

namespace weft::demo {

enum class Blending : std::uint8_t {
    rigid,         ///< each point follows the joint of its greatest weight
    linear_blend,  ///< weighted mean over up to eight joints' frames (Magnenat-Thalmann 1988)
};

class Binding {
  public:
    Binding() = default;
    /// Binds points to four joints, by the inverse fourth power of their distance from each limb's surface in
    /// this pose. A limb whose ends belong to two joints shares its weight between both.
    [[nodiscard]] static Binding to_nearest(const Body& body, const Pose& pose, std::span<const Vec3> points,
                                            Blending blending = Blending::linear_blend);
    /// Binds points by a file's weights, as many joints and weights for each point; the eight greatest are
    /// kept. Error: not as many of both for each point, a joint that the skeleton lacks, weights that are
    /// negative, not finite or sum to 0, each with its point.
    [[nodiscard]] static Result<Binding> by_weights(const Pose& pose, std::span<const Vec3> points,
                                                    std::span<const std::uint32_t> joints,
                                                    std::span<const float> weights);

    /// Writes each point's position in the pose [m]. Precondition: `to` has size() elements.
    void place(const Pose& pose, std::span<Vec3> to) const;
    /// Rotates a vector at each point from the pose `bound`, in which points were bound, to `pose`. Blending
    /// may shorten vectors. Precondition: both spans have size() elements.
    void turn(const Pose& bound, const Pose& pose, std::span<const Vec3> vectors, std::span<Vec3> to) const;
    [[nodiscard]] std::size_t size() const { return bonds_.size(); }

  private:
    static constexpr std::size_t most = 8;
    struct Bond {
        std::array<std::uint32_t, most> joints{};
        std::array<float, most> weights{};  // descending, sum to 1; 0 ends the list
        std::array<Vector3, most> local;    // the point in each joint's frame
    };
    static Bond bond(const Pose& pose, const Vector3& point, std::span<const float> weight_of_joint,
                     std::size_t kept);

    std::vector<Bond> bonds_;
};

/// Parameter of the point's projection on the axis, clamped to 0 at end a and 1 at end b.
[[nodiscard]] float part_along(const TaperedCapsule& capsule, const Vector3& point);

}  // namespace weft::demo
