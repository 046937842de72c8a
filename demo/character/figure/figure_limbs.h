#pragma once
// The limbs that a person's drawn surface refers to: ends, radii and axes, without the twist of their bones.

#include <span>
#include <utility>
#include <vector>

#include "demo/character/body/body.h"

namespace weft::demo {

/// A limb in a pose. Its axes turn from the rest pose's to the pose's; they may differ between both ends, and
/// are blended in between.
struct FigureLimb {
    LimbKind kind;
    Vector3 a, b;              ///< ends of the limb's axis [m]
    float radius_a, radius_b;  ///< [m]
    Matrix3 axes_a, axes_b;
    Vector3 scale = Vector3::Ones();  ///< of the limb's shape along its axes: hands are flat

    [[nodiscard]] Vector3 at(float along) const { return a + along * (b - a); }
    [[nodiscard]] Eigen::AlignedBox3f box(float margin = 0) const {
        Eigen::AlignedBox3f box;
        for (const auto& [end, reach] : {std::pair(a, radius_a + margin), {b, radius_b + margin}}) {
            box.extend(Vector3(end + Vector3::Constant(reach)));
            box.extend(Vector3(end - Vector3::Constant(reach)));
        }
        return box;
    }
    [[nodiscard]] float radius(float along) const { return radius_a + along * (radius_b - radius_a); }
};

/// FigureLimb::scale of hands, whose palms face down at rest.
inline const Vector3 flat_hand(1, 0.64f, 1);

/// Finds the limbs of a body. Arms and legs are round, so that their axes need no twist: they follow their
/// bones by the least turn, as skinning without artefacts of twist does (Kavan, Sorkine, "Elasticity-inspired
/// deformers", 2012). Forearms and shins share out the twist of hands and feet over their lengths.
class FigureRig {
  public:
    FigureRig(const Body& body, const Skeleton& skeleton);
    /// Writes the limbs in a pose. Precondition: `capsules` as Body::place() writes them.
    void place(const Pose& pose, std::span<const TaperedCapsule> capsules, std::vector<FigureLimb>& to) const;

  private:
    struct Source {
        LimbKind kind;
        std::size_t joint_a, joint_b;
        Vector3 rest_way;  // direction of the axis at rest
    };
    [[nodiscard]] Quaternion base_of(std::size_t limb, const Pose& pose,
                                     std::span<const Quaternion> own) const;

    std::vector<Source> sources_;
    std::size_t hips_, chest_;  // joints
};

}  // namespace weft::demo
