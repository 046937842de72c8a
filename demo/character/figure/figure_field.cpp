#include "demo/character/figure/figure_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace weft::demo {
namespace {

constexpr float full = 0.955f;  // radius of a plain limb: the rest is room for where limbs are joined

const Vector3 middle = Vector3::Zero();

/// The smooth minimum of two distances (I. Quilez, "Smooth minimum", 2013). Its width goes with the angle
/// between both normals, so that limbs in one line do not bulge where they meet (after Gourmel et al., "A
/// gradient-based implicit blend", 2013).
void unite(SurfaceDistance& all, float& blend, const SurfaceDistance& next, float next_blend) {
    const float width = std::min(blend, next_blend) * (all.normal - next.normal).norm();
    const float apart = next.distance - all.distance;
    if (apart >= width) return;
    if (apart <= -width) {
        all = next;
        blend = next_blend;
        return;
    }
    const float part = 0.5f + 0.5f * apart / width;  // of the first
    all.distance += (1 - part) * apart - width * part * (1 - part);
    const Vector3 normal = part * all.normal + (1 - part) * next.normal;
    if (normal.squaredNorm() > 1e-6f) all.normal = normal.normalized();
    blend = part * blend + (1 - part) * next_blend;
}

}  // namespace

std::span<const FigureBlob> blobs_of(LimbKind kind) {
    static const std::array<FigureBlob, 1> plain{{{{0, middle, full}, {1, middle, full}}}};
    static const std::array<FigureBlob, 1> neck{{
        {{0, middle, 0.88f}, {1, {0, 0, -0.12f}, 0.84f}, {1, 1, 1}, 0.36f},
    }};
    static const std::array<FigureBlob, 5> head{{
        // Skull, jaw, nose and ears.
        {{0.75f, {0, 0, -0.08f}, 0.86f}, {1, {0, 0, -0.14f}, 0.86f}, {0.84f, 1, 1}, 0.4f},
        {{-0.35f, {0, 0, 0.60f}, 0.36f}, {0.55f, {0, 0, 0.12f}, 0.60f}, {0.86f, 1, 1}, 0.3f},
        {{0.22f, {0, 0, 0.86f}, 0.11f}, {0.70f, {0, 0, 0.68f}, 0.06f}, {1, 1, 1}, 0.10f},
        {{0.36f, {0.78f, 0, -0.06f}, 0.09f}, {0.70f, {0.80f, 0, -0.12f}, 0.11f}, {1, 1, 1}, 0.06f},
        {{0.36f, {-0.78f, 0, -0.06f}, 0.09f}, {0.70f, {-0.80f, 0, -0.12f}, 0.11f}, {1, 1, 1}, 0.06f},
    }};
    static const std::array<FigureBlob, 3> hand{{
        // Palm, fingers and thumb; the limb itself is flat.
        {{-0.2f, middle, 0.88f}, {0.34f, {0, 0, -0.10f}, 0.86f}, {1, 1, 1}, 0.4f},
        {{0.34f, {0, 0, -0.20f}, 0.72f}, {1.05f, {0, -0.3f, -0.24f}, 0.54f}, {1, 1, 1}, 0.4f},
        {{0.1f, {0, 0, 0.40f}, 0.42f}, {0.56f, {0, -0.15f, 0.68f}, 0.30f}, {1, 1, 1}, 0.12f},
    }};
    static const std::array<FigureBlob, 1> forearm{{
        {{0, middle, full}, {0.95f, middle, 0.88f}, {1, 1, 1}},
    }};
    static const std::array<FigureBlob, 2> shin{{
        // Bone and calf.
        {{0, middle, 0.93f}, {1, middle, full}, {1, 1, 1}},
        {{0.12f, {0, 0, -0.18f}, 0.78f}, {0.5f, {0, 0, -0.24f}, 0.72f}, {1, 1, 1}, 0.8f},
    }};
    static const std::array<FigureBlob, 2> foot{{
        // Ankle and instep.
        {{0, middle, full}, {0.6f, {0, 0.05f, 0}, 0.80f}},
        {{0.6f, {0, 0.05f, 0}, 0.80f}, {1, {0, -0.15f, 0}, 0.72f}},
    }};
    static const std::array<FigureBlob, 1> sole{{
        {{0, middle, 0.96f}, {1, {0, -0.05f, 0.1f}, 0.90f}, {1, 1, 1}, 0.6f},
    }};
    switch (kind) {
        case LimbKind::neck:
            return neck;
        case LimbKind::head:
            return head;
        case LimbKind::hand:
            return hand;
        case LimbKind::forearm:
            return forearm;
        case LimbKind::shin:
            return shin;
        case LimbKind::foot:
            return foot;
        case LimbKind::sole:
            return sole;
        default:
            return plain;
    }
}

FigureField::FigureField(std::span<const FigureLimb> limbs) {
    for (const FigureLimb& limb : limbs) {
        const auto first = static_cast<std::uint32_t>(blobs_.size());
        for (const FigureBlob& blob : blobs_of(limb.kind)) blobs_.push_back(place(blob, limb));
        of_limb_.push_back({first, static_cast<std::uint32_t>(blobs_.size())});
    }
}

FigureField::Placed FigureField::place(const FigureBlob& blob, const FigureLimb& limb) {
    const auto radius = [&](const FigureBlob::End& end) {
        return limb.radius(std::clamp(end.along, 0.0f, 1.0f));
    };
    const auto point = [&](const FigureBlob::End& end) -> Vector3 {
        return limb.at(end.along) + radius(end) * (limb.axes_a * end.aside.cwiseProduct(limb.scale));
    };
    const Vector3 a = point(blob.a), b = point(blob.b);
    const float radius_a = blob.a.radius * radius(blob.a), radius_b = blob.b.radius * radius(blob.b);
    const float blend = blob.blend * limb.radius(0.5f);
    const Vector3 scale = blob.scale.cwiseProduct(limb.scale);
    if (scale == Vector3::Ones())
        return {
            RoundCone(a, b, radius_a, radius_b), a, Matrix3::Identity(), Matrix3::Identity(), blend, false};
    const Vector3 finer = scale.cwiseInverse();
    const Matrix3 to_local = finer.asDiagonal() * limb.axes_a.transpose();
    const Matrix3 to_world = limb.axes_a * finer.asDiagonal();
    return {RoundCone(Vector3::Zero(), to_local * (b - a), radius_a, radius_b),
            a,
            to_local,
            to_world,
            blend,
            true};
}

SurfaceDistance FigureField::distance(const Placed& blob, const Vector3& point) {
    if (!blob.scaled) return blob.cone.distance_to(point);
    const SurfaceDistance local = blob.cone.distance_to(blob.to_local * (point - blob.origin));
    const Vector3 gradient = blob.to_world * local.normal;
    const float slope = gradient.norm();
    return {local.distance / slope, gradient / slope};
}

SurfaceDistance FigureField::at(const Vector3& point, std::span<const std::uint8_t> limbs) const {
    SurfaceDistance all{std::numeric_limits<float>::max(), Vector3::UnitY()};
    float blend = 0;
    for (const std::uint8_t limb : limbs)
        for (std::uint32_t k = of_limb_[limb].first; k < of_limb_[limb].end; ++k)
            unite(all, blend, distance(blobs_[k], point), blobs_[k].blend);
    return all;
}

float FigureField::of_limb(const Vector3& point, std::size_t limb) const {
    float least = std::numeric_limits<float>::max();
    for (std::uint32_t k = of_limb_[limb].first; k < of_limb_[limb].end; ++k)
        least = std::min(least, distance(blobs_[k], point).distance);
    return least;
}

}  // namespace weft::demo
