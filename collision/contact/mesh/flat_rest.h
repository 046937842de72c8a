#pragma once
// The law of FlatRest: a condition under which no features of a sheet come near, tested without a search.
//
// Let X be the positions of a sheet's points in a chart, a plane in which its triangles lie side by side and
// fill a convex region, and x those in space. On each triangle x is affine, with gradient F = dx/dX. Let R
// map the chart into space without stretching it, and let all triangles under a convex part of the chart have
// R w . F w >= s for every unit vector w. Then for any two points of that part, with w from one to the other
// and by the mean of F along the straight line between them,
//     |x(u) - x(v)| >= R w . (x(u) - x(v)) >= s |X(u) - X(v)|,
// and features that share no vertex are apart in the chart by the least altitude of the triangles around
// their corners: the line from a corner to the other feature leaves these across the side that faces the
// corner. In space they are apart by s times that. Cloth may turn by some 130 degrees before this fails.
//
// For a triangle, the least of R w . F w is the lesser eigenvalue of the symmetric part of R^T F.
//
// If all particles move the same fraction of a motion at a time, F is linear in that fraction, and so is
// R w . F w: a bound s at both ends holds between them. If each particle may move a fraction of its own, the
// normal n of closest points keeps a pair apart by their distance. The motion reduces that by at most
// n . (p - q) for p and q each a particle's motion or 0, which is at most the diameter of all these.

#include <array>
#include <cstdint>
#include <span>

#include "engine/memory/shared_buffer.h"
#include "weft/types.h"

namespace weft {

struct ContactPatch;
template <std::uint32_t corner_count>
struct FeatureSlots;

/// An isometry from the chart into space: x, y and z along the chart's first axis, then along its second.
using ChartFrame = std::array<float, 6>;

/// The frame nearest to a gradient; infinite if the gradient is not finite, or has hardly any area.
[[nodiscard]] ChartFrame nearest_frame(const ChartFrame& gradient) noexcept;

/// The sum of the gradients of a patch's triangles, and the bounds of the motions of its corners.
struct PatchStrain {
    ChartFrame sum;
    std::array<float, 3> least_motion, most_motion;

    /// The diameter of a box around the motions of both patches' corners and around 0.
    [[nodiscard]] float spread_with(const PatchStrain& other) const noexcept;
};

/// A group of sixteen slots of triangles, and a bit for each triangle that counts.
struct TriangleGroup {
    std::uint32_t number, triangles;
};

/// A pair of patches that lie side by side or nearly so, or a patch with itself.
struct PatchNeighbours {
    std::uint32_t other;       ///< the second patch, not below the first
    std::uint32_t begin, end;  ///< in FlatRest::covers_: the triangles in a convex region around both
    float height;              ///< least distance in the chart of features that share no vertex [m]
};

/// The charts of the pieces of a mesh. A piece has a chart if, projected along its mean normal at rest, it
/// has no fold and no hole, and a convex border. A sheet has one, and so has each of several sheets in one
/// mesh.
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
    /// Calls visit(list) for all lists.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        for (auto& values : self.inverse_) visit(values);
        visit(self.starts_);
        visit(self.neighbours_);
        visit(self.covers_);
    }
    /// Whether all indices in lists that were read are valid, for so many patches and slots of triangles.
    [[nodiscard]] bool is_sound(std::size_t patches, std::size_t triangle_slots) const;

    [[nodiscard]] bool is_empty() const noexcept { return starts_.empty(); }
    /// Whether all triangles are within a chart.
    [[nodiscard]] bool has_all_triangles() const noexcept;
    /// Inverse of the sides in the chart, by triangle slot, 0 outside charts: dx/dX = [x1 - x0, x2 - x0]
    /// times the matrix of rows (0, 1) and (2, 3).
    [[nodiscard]] const SharedBuffer<float>& inverse(std::size_t k) const noexcept { return inverse_[k]; }
    static constexpr std::uint32_t none = ~0u;
    /// The number of a pair of neighbours; none if the patches are no neighbours, or one is not within a
    /// chart. A patch within a chart is its own neighbour. Precondition: patch <= other.
    [[nodiscard]] std::uint32_t find(std::uint32_t patch, std::uint32_t other) const noexcept {
        if (is_empty()) return none;
        for (std::uint32_t k = starts_[patch]; k < starts_[patch + 1]; ++k)
            if (neighbours_[k].other == other) return k;
        return none;
    }
    /// Number of pairs of neighbours.
    [[nodiscard]] std::uint32_t pairs() const noexcept {
        return static_cast<std::uint32_t>(neighbours_.size());
    }
    /// The number of a patch's first pair.
    [[nodiscard]] std::uint32_t first_of(std::uint32_t patch) const noexcept { return starts_[patch]; }
    /// All pairs. Those of a patch with patches not below it begin at first_of(patch).
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
