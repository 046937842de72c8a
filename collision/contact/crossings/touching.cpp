#include "collision/contact/crossings/touching.h"

#include <algorithm>
#include <cmath>

#include "collision/contact/crossings/contours.h"
#include "collision/contact/crossings/surface_at.h"
#include "engine/vector.h"

namespace weft {

namespace {

// A gap of less than this fraction of the largest coordinate is rounding.
constexpr float rounding_per_coordinate = 1e-7f;

// A surface stands on another if it rises from the other's plane by this fraction of its edges' length.
constexpr float least_rise = 0.1f;

// At a border the ring lies off the surface's place by this fraction of its edges' length.
constexpr float least_ring = 0.25f;

// A mean normal shorter than this is noise: triangles that face opposite ways cancel, as along a fold.
constexpr float least_normal = 0.1f;

/// The surface around one side of a pair.
struct Side {
    Vector3 normal = Vector3::Zero();  ///< of unit length, or 0 along a fold
    Vector3 ring = Vector3::Zero();    ///< to the mean of the neighbouring corners [m]
    float length = 0;                  ///< mean length of the edges [m]
};

bool is_border(const Side& side) {
    return side.ring.norm() > least_ring * side.length;
}

class TouchingPairs {
  public:
    TouchingPairs(std::span<const ContactBody> bodies, std::span<const Vec4> positions)
        : bodies_(bodies), positions_(positions) {
        for (const Vec4& x : positions)
            largest_ = std::max({largest_, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    }

    /// Calls visit(pair, shape, corners of A) for the pairs that touch.
    template <class Visit>
    void for_each(const PairList& pairs, const Visit& visit) const {
        for (std::uint32_t k = 0; k < pairs.size; ++k) {
            const FeaturePair& pair = pairs.pairs[k];
            const PairShape& shape = pairs.shapes[k];
            if (is_touching(pair, shape)) visit(pair, shape, pairs.corners_of_a(k));
        }
    }
    [[nodiscard]] bool any(const PairList& pairs) const {
        for (std::uint32_t k = 0; k < pairs.size; ++k)
            if (is_touching(pairs.pairs[k], pairs.shapes[k])) return true;
        return false;
    }
    /// Unit direction in which A moves relative to B; 0: undetermined. `both`: B moves the opposite way.
    [[nodiscard]] Vector3 way_of_a(const FeaturePair& pair, const PairShape& shape,
                                   std::uint32_t corners_of_a, bool& both) const {
        const Side a = side_of(pair, shape, 0, corners_of_a), b = side_of(pair, shape, corners_of_a, 4);
        const Vector3 rise = a.ring - b.ring;
        const float off_b = rise.dot(b.normal), off_a = rise.dot(a.normal);
        const bool is_off_b = std::abs(off_b) > std::abs(off_a);
        const float off = is_off_b ? off_b : off_a;
        both = false;
        // Against its own edges: what it stands on may have much longer ones.
        if (std::abs(off) > least_rise * (is_off_b ? a.length : b.length))
            return std::copysign(1.0f, off) * (is_off_b ? b.normal : a.normal);
        both = a.normal.dot(b.normal) < 0;
        if (both) return (a.normal - b.normal).stableNormalized();
        if (&body_of(pair.corners[0]) == &body_of(pair.corners[3])) {
            both = is_border(a) && is_border(b) && a.ring.dot(b.ring) < 0;
            return both ? rise.stableNormalized() : Vector3::Zero();
        }
        const Vector3 front = (a.normal + b.normal).stableNormalized();
        return pair.corners[0] > pair.corners[3] ? front : Vector3(-front);
    }

  private:
    /// The rounding of the largest coordinate of all rejects most pairs, and needs no gathering.
    [[nodiscard]] bool is_touching(const FeaturePair& pair, const PairShape& shape) const {
        if (std::abs(shape.normal.w) > rounding_per_coordinate * largest_) return false;
        float largest = 0;
        for (const std::uint32_t i : pair.corners)
            largest = std::max(largest, xyz(positions_[i]).cwiseAbs().maxCoeff());
        return std::abs(shape.normal.w) <= rounding_per_coordinate * largest;
    }

    [[nodiscard]] const ContactBody& body_of(std::uint32_t particle) const {
        return bodies_[weft::body_of(bodies_, particle)];
    }
    /// The surface around the closest point of a pair's corners in [begin, end).
    [[nodiscard]] Side side_of(const FeaturePair& pair, const PairShape& shape, std::uint32_t begin,
                               std::uint32_t end) const {
        Side side;
        float area = 0;
        for (std::uint32_t c = begin; c < end; ++c) {
            const float weight = std::abs(shape.weight(c));
            if (weight == 0) continue;
            const ContactBody& body = body_of(pair.corners[c]);
            const SurfaceAt at = surface_at(body, positions_, pair.corners[c]);
            side.normal += weight * at.normal;
            area += weight * at.area;
            side.ring += weight * at.ring;
            side.length += weight * at.length;
        }
        const float length = side.normal.norm();
        side.normal = length > least_normal * area ? Vector3(side.normal / length) : Vector3::Zero();
        return side;
    }

    std::span<const ContactBody> bodies_;
    std::span<const Vec4> positions_;
    float largest_ = 0;  // largest coordinate [m]
};

/// Sums the directions in which pairs move each particle. Returns whether any pair touches.
bool gather_ways(const TouchingPairs& touching, const PairList& pairs, std::span<Vec4> ways) {
    bool any = false;
    touching.for_each(pairs, [&](const FeaturePair& pair, const PairShape& shape, std::uint32_t of_a) {
        if (!any) std::ranges::fill(ways, Vec4{});
        any = true;
        bool both = false;
        const Vector3 way = touching.way_of_a(pair, shape, of_a, both);
        const bool a_is_later = pair.corners[0] > pair.corners[3];
        for (std::uint32_t c = 0; c < 4; ++c) {
            const bool is_a = c < of_a;
            if (shape.weight(c) == 0 || !(both || is_a == a_is_later)) continue;
            Vec4& sum = ways[pair.corners[c]];
            set_xyz(sum, xyz(sum) + (is_a ? way : Vector3(-way)));
        }
    });
    return any;
}

}  // namespace

bool any_touch(std::span<const ContactBody> bodies, const PairList& pairs, std::span<const Vec4> positions) {
    return TouchingPairs(bodies, positions).any(pairs);
}

bool part_touching(std::span<const ContactBody> bodies, const PairList& pairs, float distance,
                   std::span<Vec4> positions, std::span<Vec4> ways) {
    if (!gather_ways(TouchingPairs(bodies, positions), pairs, ways)) return false;
    bool moved = false;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vector3 way = xyz(ways[i]);
        if (way.isZero(0)) continue;
        set_xyz(positions[i], xyz(positions[i]) + distance * way.stableNormalized());
        moved = true;
    }
    return moved;
}

}  // namespace weft
