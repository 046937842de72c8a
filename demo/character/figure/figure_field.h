#pragma once
// The shape of a person's drawn surface: its limbs, without the twist of their bones; a smooth function of
// them; and the triangles where a function on a grid is 0.

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "demo/character/body/body.h"
#include "engine/vector.h"
#include "weft/mesh.h"

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

/// A round cone that is part of a limb's shape, in units of the limb. It is scaled along the limb's axes.
struct FigureBlob {
    struct End {
        float along;    ///< 0 at the limb's end a to 1 at its end b
        Vector3 aside;  ///< from the limb's axis, in the limb's axes, over its radius there
        float radius;   ///< over the limb's radius
    };
    End a, b;
    Vector3 scale = Vector3::Ones();
    float blend = 0.5f;  ///< width of the transition to other blobs, over the limb's radius
};

/// The blobs of one kind of limb. All are within the limb, but for corners.
[[nodiscard]] std::span<const FigureBlob> blobs_of(LimbKind kind);

/// The smooth union of all limbs' blobs in one pose.
class FigureField {
  public:
    explicit FigureField(std::span<const FigureLimb> limbs);

    /// Approximate distance from the blobs of some limbs, ascending; exact on the surface.
    [[nodiscard]] SurfaceDistance at(const Vector3& point, std::span<const std::uint8_t> limbs) const;
    /// Distance from one limb's own blobs.
    [[nodiscard]] float of_limb(const Vector3& point, std::size_t limb) const;

  private:
    struct Range {
        std::uint32_t first, end;  // of a limb's blobs
    };
    struct Placed {
        RoundCone cone;  // in the limb's scaled axes where `scaled`, otherwise in the World
        Vector3 origin;
        Matrix3 to_local, to_world;  // of points and of normals
        float blend;
        bool scaled;
    };
    [[nodiscard]] static Placed place(const FigureBlob& blob, const FigureLimb& limb);
    [[nodiscard]] static SurfaceDistance distance(const Placed& blob, const Vector3& point);

    std::vector<Placed> blobs_;
    std::vector<Range> of_limb_;
};

/// Values at the corners of a grid of cubes.
class CornerGrid {
  public:
    /// Covers the box and at least a cell beyond it; all corners have the value `outside`.
    CornerGrid(const Eigen::AlignedBox3f& box, float cell, float outside);

    /// Calls f(corner's place, its index) for the corners within a box.
    template <class F>
    void for_corners_in(const Eigen::AlignedBox3f& box, const F& f) const {
        const std::array<std::size_t, 3> low = corner_before(box.min()), high = corner_before(box.max());
        for (std::size_t z = low[2]; z <= high[2]; ++z)
            for (std::size_t y = low[1]; y <= high[1]; ++y)
                for (std::size_t x = low[0]; x <= high[0]; ++x) f(place(x, y, z), index(x, y, z));
    }
    [[nodiscard]] std::vector<float>& values() { return values_; }

    /// The surface, counter-clockwise seen from where values are positive: a vertex in each cell that it
    /// passes, in the mean of where it passes the cell's edges (Gibson, "Constrained elastic surface nets",
    /// 1998). It is closed if values on the grid's border are positive: each edge has as many triangles on
    /// one side as on the other, mostly one.
    [[nodiscard]] Mesh surface() const;

  private:
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
        return x + corners_[0] * (y + corners_[1] * z);
    }
    [[nodiscard]] Vector3 place(std::size_t x, std::size_t y, std::size_t z) const {
        return origin_ + cell_ * Vector3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    }
    [[nodiscard]] std::array<std::size_t, 3> corner_before(const Vector3& point) const;
    [[nodiscard]] Vector3 middle_of_crossings(std::size_t x, std::size_t y, std::size_t z,
                                              int& crossings) const;

    Vector3 origin_;
    float cell_;
    std::array<std::size_t, 3> corners_{};
    std::vector<float> values_;
};

}  // namespace weft::demo
