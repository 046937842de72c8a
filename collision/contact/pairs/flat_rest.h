#pragma once
// Why nothing of a calm sheet touches itself, without a look at its features.
//
// Let X be where points of a sheet lie in a chart, a plane in which its triangles lie side by side and fill a
// convex region, and x where they are in space. On each triangle x is affine, with gradient F = dx/dX. Let R
// take the chart into space without stretching it, and let all triangles under a convex part of the chart
// have R w . F w >= s for every unit vector w. Then for any two points of it, with w from one to the other
// and by the mean of F along the straight line between them,
//     |x(u) - x(v)| >= R w . (x(u) - x(v)) >= s |X(u) - X(v)|,
// and features that share no vertex are apart in the chart by the least altitude of the triangles around
// their corners: the line from a corner to what is not of its triangles leaves these across the side that
// faces it. So they are apart in space by s times that. Cloth may turn by some 130 degrees until it is not.
//
// Of a triangle, the least of R w . F w is the lesser eigenvalue of the symmetric part of R^T F.
//
// Over a motion of which all particles go the same part at a time, F is linear in that part, and so is
// R w . F w: what is s at both ends is no less between them. Where each particle may go another part of its
// own, the normal n of closest points keeps a pair apart by their distance. What the motion takes off is at
// most n . (p - q) for p and q each a particle's motion or 0, which is at most the diameter of all these.

#include <array>
#include <cstdint>
#include <span>

#include "engine/memory/shared_buffer.h"
#include "weft/types.h"

namespace weft {

struct ContactPatch;
template <std::uint32_t corner_count>
struct FeatureSlots;

/// A map of the chart into space that stretches nothing: x, y and z along the chart's first axis, then along
/// its second.
using ChartFrame = std::array<float, 6>;

/// The frame nearest to a gradient; it is finite if the gradient is, and has an area.
[[nodiscard]] ChartFrame nearest_frame(const ChartFrame& gradient) noexcept;

/// The sum of the gradients of a patch's triangles, and the motions of its corners.
struct PatchStrain {
    ChartFrame sum;
    std::array<float, 3> least_motion, most_motion;

    /// The diameter of the motions of the corners of both, and of none.
    [[nodiscard]] float spread_with(const PatchStrain& other) const noexcept;
};

/// Sixteen slots of triangles, and which of them count, a bit for each.
struct TriangleGroup {
    std::uint32_t number, triangles;
};

/// A pair of patches that lie side by side or nearly so, or one with itself.
struct PatchNeighbours {
    std::uint32_t other;       ///< not below the first
    std::uint32_t begin, end;  ///< in FlatRest::covers(): the triangles in a convex region around both
    float height;              ///< [m] between features that share no vertex, at least
};

/// The charts of those pieces of a mesh that have one: that, seen along their mean normal at rest, are
/// without a fold and without a hole, with a convex border. A sheet is, and so is each of several that are
/// one mesh.
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
    /// visit(list) for all of it.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        for (auto& values : self.inverse_) visit(values);
        visit(self.starts_);
        visit(self.neighbours_);
        visit(self.covers_);
    }
    /// Whether lists that were read name only what there is, for so many patches and slots of triangles.
    [[nodiscard]] bool is_sound(std::size_t patches, std::size_t triangle_slots) const;

    [[nodiscard]] bool is_empty() const noexcept { return starts_.empty(); }
    /// Whether all triangles are within a chart.
    [[nodiscard]] bool has_all_triangles() const noexcept;
    /// By triangle slot, 0 outside charts: dx/dX = [x1 - x0, x2 - x0] times the matrix of rows (0, 1) and (2,
    /// 3).
    [[nodiscard]] const SharedBuffer<float>& inverse(std::size_t k) const noexcept { return inverse_[k]; }
    static constexpr std::uint32_t none = ~0u;
    /// The number of a pair of neighbours; none if these are not, or one of them is not within a chart, where
    /// a patch is its own neighbour. Precondition: patch <= other.
    [[nodiscard]] std::uint32_t find(std::uint32_t patch, std::uint32_t other) const noexcept {
        if (is_empty()) return none;
        for (std::uint32_t k = starts_[patch]; k < starts_[patch + 1]; ++k)
            if (neighbours_[k].other == other) return k;
        return none;
    }
    /// How many pairs of neighbours there are.
    [[nodiscard]] std::uint32_t pairs() const noexcept {
        return static_cast<std::uint32_t>(neighbours_.size());
    }
    /// The first of a patch's pairs.
    [[nodiscard]] std::uint32_t first_of(std::uint32_t patch) const noexcept { return starts_[patch]; }
    /// Pairs of a patch and those not below it, from first_of() it to first_of() the next.
    [[nodiscard]] std::span<const PatchNeighbours> neighbours() const noexcept { return neighbours_.span(); }
    [[nodiscard]] std::span<const TriangleGroup> cover(const PatchNeighbours& pair) const noexcept {
        return covers_.span().subspan(pair.begin, pair.end - pair.begin);
    }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    std::array<SharedBuffer<float>, 4> inverse_;
    SharedBuffer<std::uint32_t> starts_;  // by patch, into neighbours_
    SharedBuffer<PatchNeighbours> neighbours_;
    SharedBuffer<TriangleGroup> covers_;
};

}  // namespace weft
