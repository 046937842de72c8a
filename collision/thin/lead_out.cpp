#include "collision/thin/lead_out.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <variant>

#include "collision/colliders/collider_kernels.h"
#include "collision/colliders/nearest_surface.h"
#include "collision/shapes/moving_shapes.h"
#include "engine/bounds.h"

namespace weft {

namespace {

/// A collider, with the cloth that may be inside of it at the substep's start.
class Inside {
  public:
    Inside(const ColliderMotion& motion, std::span<const ColliderMotion> colliders, const ClothSide& cloth,
           float h, const CollidingParticles& particles)
        : motion_(motion), colliders_(colliders), cloth_(cloth), particles_(particles), h_(h) {
        const Bounds box = grown(motion.filled, cloth.most_thickness);
        box_ = {to_vector(box.lower), to_vector(box.upper)};
        travel_ = with_shapes(motion, [&](const auto& start, const auto& end) {
            return sweeping(start, end, {h, motion.fastest}, 0).travel;
        });
    }

    /// Returns true if the nearest ways out draw one of the triangle's edges out by more than a quarter.
    [[nodiscard]] bool part(const std::array<std::uint32_t, 3>& triangle, float mean_edge) const {
        std::array<Depth, 3> found;
        for (std::size_t k = 0; k < 3; ++k) found[k] = at_start(triangle[k]);
        for (std::size_t k = 0; k < 3; ++k) {
            const Depth &a = found[k], &b = found[(k + 1) % 3];
            if (!(a.depth > 0 && b.depth > 0) || a.normal.dot(b.normal) > 0.8f) continue;
            const Vector3 edge =
                xyz(particles_.starts[triangle[(k + 1) % 3]]) - xyz(particles_.starts[triangle[k]]);
            const Vector3 out = edge + b.depth * b.normal - a.depth * a.normal;
            if (out.norm() > 1.25f * std::max(edge.norm(), mean_edge)) return true;
        }
        return false;
    }

    /// The direction by which all that is inside is out first, and into no other collider; times the way.
    [[nodiscard]] std::optional<Vector3> way_out() const {
        Eigen::AlignedBox3f found;
        for (std::uint32_t i = 0; i < particles_.starts.size(); ++i)
            if (at_start(i).depth > 0) found.extend(xyz(particles_.starts[i]));
        if (found.isEmpty()) return std::nullopt;
        std::optional<Vector3> best;
        for (int axis = 0; axis < 3; ++axis)
            for (const float way :
                 {box_.max()[axis] - found.min()[axis], box_.min()[axis] - found.max()[axis]}) {
                const Vector3 out = way * Vector3::Unit(axis);
                if ((!best || out.squaredNorm() < best->squaredNorm()) && is_free(found.center() + out, 0))
                    best = out;
            }
        return best;
    }

    /// Moves what is inside along with the collider, and out at a limited speed that it does not keep.
    void lead(const Vector3& out) const {
        const Vector3 way = travel_ + std::min(1.0f, h_ * FoundDepth::speed / out.norm()) * out;
        for (std::uint32_t i = 0; i < particles_.starts.size(); ++i) {
            Vec4& position = particles_.positions[i];
            if (!(position.w > 0 && at_start(i).depth > 0)) continue;
            set_xyz(position, xyz(particles_.starts[i]) + way);
            set_xyz(particles_.velocities[i], travel_ / h_);
        }
    }

  private:
    struct Depth {
        Vector3 normal;
        float depth = 0;  // [m]
    };
    /// Cloth at another collider's surface is squeezed, and stays there.
    [[nodiscard]] Depth at_start(std::uint32_t i) const {
        constexpr float reach = 1e-3f;
        const Vector3 p = xyz(particles_.starts[i]);
        if (!box_.contains(p) || !cloth_.meets(motion_.end, i)) return {};
        const SurfacePoint near = nearest_surface(motion_.start, p, motion_.held);
        const float depth = cloth_.thickness[i] + motion_.start.thickness - near.distance;
        return {near.normal, is_free(p, cloth_.thickness[i] + reach) ? depth : 0};
    }
    /// Whether no other collider, with its thickness, is as near to a point.
    [[nodiscard]] bool is_free(const Vector3& p, float distance) const {
        const Bounds about{to_vec3(p), to_vec3(p)};
        return std::ranges::none_of(colliders_, [&](const ColliderMotion& other) {
            return &other != &motion_ && cloth_.meets(other.end) &&
                   overlap(other.filled, grown(about, distance)) &&
                   nearest_surface(other.start, p, other.held).distance < distance + other.start.thickness;
        });
    }

    const ColliderMotion& motion_;
    std::span<const ColliderMotion> colliders_;
    const ClothSide& cloth_;
    const CollidingParticles& particles_;
    float h_;
    Eigen::AlignedBox3f box_;
    Vector3 travel_;
};

/// Whether cloth is led out of it: planes and grounds have no far side, and off a limb it comes over an end.
bool leads_out(const ColliderMotion& motion) {
    const auto& shape = motion.end.shape;
    const bool has_far_side = std::holds_alternative<Sphere>(shape) || std::holds_alternative<Box>(shape) ||
                              (motion.held != nullptr && !motion.held->is_ground());
    return has_far_side && finds_depth(motion);
}

}  // namespace

void lead_out(std::span<const std::array<std::uint32_t, 3>> triangles, float mean_edge,
              std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
              const CollidingParticles& particles) {
    for (const ColliderMotion& motion : colliders) {
        if (!cloth.meets(motion.end) || !leads_out(motion)) continue;
        const Inside inside(motion, colliders, cloth, h, particles);
        if (std::ranges::none_of(triangles, [&](const auto& t) { return inside.part(t, mean_edge); }))
            continue;
        if (const auto out = inside.way_out()) inside.lead(*out);
    }
}

}  // namespace weft
