#include "collision/thin/skewer.h"

#include <algorithm>
#include <cmath>

#include "collision/thin/yielding.h"

namespace weft {

namespace {

/// Speed of coming off: over the tip of a hand in one frame. The rest of the cloth draws back in each, by so
/// much that at half of this a forearm may keep it for ever.
constexpr float speed = 8;  // [m/s]

bool is_inside_another(const Vector3& point, const ColliderMotion& motion,
                       std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h) {
    constexpr std::uint32_t group = 16;  // arrays extend to its end
    constexpr float reach = 1e-3f;
    std::array<Vec4, group> points, still{};
    points.fill(to_vec4(point, 1));
    alignas(64) constexpr std::array<float, group> zeros{};
    const ClothSide side{.thickness = zeros, .friction = zeros, .mask = cloth.mask};
    const auto is_inside = [&](std::span<const ColliderMotion> others) {
        NearSurfaces near;
        return find_near_surfaces(others, side, h, reach, {}, std::span(points).first(1), 0,
                                  std::span(still).first(1), near) &&
               near.surfaces.w[0] < 0;
    };
    const auto own = static_cast<std::size_t>(&motion - colliders.data());
    return is_inside(colliders.first(own)) || is_inside(colliders.subspan(own + 1));
}

}  // namespace

std::optional<Skewer> Skewer::of(const Cores& cores) {
    const Core& axis = cores.list().front();
    if (!cores.are_round() || axis.is_point() || axis.radius == 0) return std::nullopt;
    Skewer skewer;
    skewer.cores_ = &cores;
    skewer.length_ = axis.axis.x();
    skewer.off_first_ = axis.radius;
    skewer.off_last_ = axis.radius_at(1);
    return skewer;
}

Bounds Skewer::bounds() const {
    const Vector3 a = cores_->place({0, 0, 0}), b = cores_->place({length_, 0, 0});
    return {to_vec3(a.cwiseMin(b)), to_vec3(a.cwiseMax(b))};
}

TurningBox Skewer::box() const {
    TurningBox box = cores_->turning_box(0);
    box.to_own_at_start = box.to_own;
    box.origin_at_start = box.origin;
    box.lower = {0, 0, 0};
    box.upper = {length_, 0, 0};
    return box;
}

/// Projected along the axis, the triangle is flat and the axis a point.
std::optional<Skewer::Hit> Skewer::hit(const Triangle& corners, std::span<const Vec4> positions) const {
    std::array<Vector3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = cores_->seen(xyz(positions[corners[k]]));
    const auto twice_area = [](const Vector3& a, const Vector3& b) { return a.y() * b.z() - a.z() * b.y(); };
    std::array<float, 3> areas{twice_area(p[1], p[2]), twice_area(p[2], p[0]), twice_area(p[0], p[1])};
    const auto [least, most] = std::ranges::minmax(areas);
    const float sum = areas[0] + areas[1] + areas[2];
    if (!(least >= 0 || most <= 0) || sum == 0) return std::nullopt;
    Hit found{};
    for (std::size_t k = 0; k < 3; ++k) {
        found.weights[k] = areas[k] / sum;
        found.x += found.weights[k] * p[k].x();
    }
    return found.x > 0 && found.x < length_ ? std::optional(found) : std::nullopt;
}

void Skewer::find_ways(const ColliderMotion& motion, std::span<const ColliderMotion> colliders,
                       const ClothSide& cloth, float h) {
    const Core& axis = cores_->list().front();
    over_first_ = !is_inside_another(cores_->place(axis.a), motion, colliders, cloth, h);
    over_last_ = !is_inside_another(cores_->place(axis.at(1)), motion, colliders, cloth, h);
    if (over_first_ || over_last_) return;
    over_first_ = axis.wider > 0;
    over_last_ = axis.wider < 0;
}

bool Skewer::take_off(const Triangle& corners, float h, std::span<Vec4> positions) const {
    const std::optional<Hit> found = hit(corners, positions);
    if (!found || !(over_first_ || over_last_)) return false;
    const float to_first = found->x + off_first_, to_last = length_ - found->x + off_last_;
    const bool forwards = over_last_ && (!over_first_ || to_last < to_first);
    const float length = std::min(forwards ? to_last : to_first, speed * h);
    const Vector3 way = cores_->in_world({forwards ? length : -length, 0, 0});
    return share_push(corners, found->weights, positions, [&](std::uint32_t i, float share) {
        set_xyz(positions[i], xyz(positions[i]) + share * way);
    });
}

}  // namespace weft
