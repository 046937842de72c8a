#pragma once
// The shape of a person's drawn surface, as a smooth function of its limbs.

#include <cstdint>
#include <span>
#include <vector>

#include "demo/character/body/round_cone.h"
#include "demo/character/figure/figure_limbs.h"

namespace weft::demo {

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

}  // namespace weft::demo
