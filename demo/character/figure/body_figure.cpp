#include "demo/character/figure/body_figure.h"

namespace weft::demo {
namespace {

constexpr float arms_of_stance = 35, legs_of_stance = 0.25f;  // as Body::stance() takes them

/// The longest side of a box about all limbs [m].
float extent(const std::vector<FigureLimb>& limbs) {
    Eigen::AlignedBox3f all;
    for (const FigureLimb& limb : limbs) all.extend(limb.box());
    return all.sizes().maxCoeff();
}

}  // namespace

BodyFigure::BodyFigure(const Body& body, const Skeleton& skeleton, float edges) : rig_(body, skeleton) {
    Pose pose;
    std::vector<TaperedCapsule> capsules;
    std::vector<FigureLimb> limbs;
    place_joints(skeleton, body.stance(skeleton, arms_of_stance, legs_of_stance), pose);
    body.place(pose, 1, capsules);
    rig_.place(pose, capsules, limbs);
    figure_ = Figure(limbs, extent(limbs) / edges);
}

void BodyFigure::place(const Pose& pose, std::span<const TaperedCapsule> capsules, std::span<Vec3> to) const {
    std::vector<FigureLimb> limbs;
    rig_.place(pose, capsules, limbs);
    figure_.place(limbs, to);
}

}  // namespace weft::demo
