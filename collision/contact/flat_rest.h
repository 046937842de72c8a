#pragma once
// Why nothing of a calm sheet touches itself, without a look at its features.
//
// Let X be where points of a sheet lie in a chart, a plane in which its triangles lie side by side and fill a
// convex region, and x where they are in space. On each triangle x is affine, with gradient F = dx/dX. If all
// triangles under a convex part of the chart have F = C + E with |E| <= e, then for any two points of it, by
// the mean of F along the straight line between them,
//     |x(u) - x(v)| >= (s - e) |X(u) - X(v)|,     s the least singular value of C,
// and features that share no vertex are apart in the chart by the least altitude of the triangles around
// their corners: the line from a corner to what is not of its triangles leaves these across the side that
// faces it. So they are apart in space by (s - e) times that.
//
// Over a motion: the normal n of closest points keeps a pair apart by their distance. What a part of the
// motion takes off is at most n . (p - q) for p and q each a particle's motion or 0, which is at most the
// diameter of all these.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/aligned_buffer.h"
#include "weft/types.h"

namespace weft {

struct ContactPatch;
template <std::uint32_t corner_count>
struct FeatureSlots;

/// What holds the gradients dx/dX of a patch's triangles (x, y and z along the chart's first axis, then along
/// its second), and the motions of its corners.
struct PatchStrain {
    std::array<float, 6> lower, upper;
    std::array<float, 3> least_motion, most_motion;
};

/// A pair of patches that lie side by side or nearly so, or one with itself.
struct PatchNeighbours {
    std::uint32_t other;       ///< not below the first
    std::uint32_t begin, end;  ///< in FlatRest::covers(): the patches whose triangles lie around both
    float height;              ///< [m] between features that share no vertex, at least
};

/// The chart of a mesh, if it has one: if, seen along its mean normal at rest, it is one piece without a fold
/// and without a hole whose border is convex. A sheet is; of other meshes this is empty.
class FlatRest {
  public:
    struct Features {
        std::span<const Vec4> rest_positions;
        std::span<const std::array<std::uint32_t, 3>> triangles;
        std::span<const ContactPatch> patches;
        const FeatureSlots<1>& corner_slots;
        const FeatureSlots<3>& triangle_slots;
    };

    FlatRest() = default;
    explicit FlatRest(const Features& features);

    [[nodiscard]] bool is_empty() const noexcept { return starts_.empty(); }
    /// By triangle slot: dx/dX = [x1 - x0, x2 - x0] times the matrix of rows (0, 1) and (2, 3).
    [[nodiscard]] const AlignedBuffer<float>& inverse(std::size_t k) const noexcept { return inverse_[k]; }
    /// Null if the two are not neighbours. Precondition: patch <= other.
    [[nodiscard]] const PatchNeighbours* find(std::uint32_t patch, std::uint32_t other) const noexcept {
        if (is_empty()) return nullptr;
        for (std::uint32_t k = starts_[patch]; k < starts_[patch + 1]; ++k)
            if (neighbours_[k].other == other) return &neighbours_[k];
        return nullptr;
    }
    /// Whether all features of two neighbours that share no vertex surely stay farther apart than reach,
    /// while each particle goes any part of its motion. `strains` are those of the mesh's patches.
    [[nodiscard]] bool keeps_apart(const PatchNeighbours& pair, std::uint32_t patch, float reach,
                                   const PatchStrain* strains) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    std::array<AlignedBuffer<float>, 4> inverse_;
    std::vector<std::uint32_t> starts_;  // by patch, into neighbours_
    std::vector<PatchNeighbours> neighbours_;
    std::vector<std::uint32_t> covers_;
};

}  // namespace weft
