#pragma once
// The figure of a body that follows a skeleton.

#include "demo/character/figure/figure.h"

namespace weft::demo {

class BodyFigure {
  public:
    /// Meshes the body with about `edges` edges from its soles to its crown.
    BodyFigure(const Body& body, const Skeleton& skeleton, float edges);

    [[nodiscard]] const Figure& figure() const { return figure_; }
    /// Writes each vertex's place [m]. Preconditions: `capsules` as Body::place() writes them for this pose,
    /// of any girth; `to` has as many elements as the figure has vertices.
    void place(const Pose& pose, std::span<const TaperedCapsule> capsules, std::span<Vec3> to) const;

  private:
    FigureRig rig_;
    Figure figure_;
};

}  // namespace weft::demo
