#include "demo/character/figure/figure_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/least_turn.h"

namespace weft::demo {

namespace {

bool is_upper(LimbKind kind) {
    return kind == LimbKind::arm || kind == LimbKind::thigh;
}
bool is_lower(LimbKind kind) {
    return kind == LimbKind::forearm || kind == LimbKind::shin;
}

/// The part of a rotation that turns about a direction.
Quaternion twist_about(const Quaternion& rotation, const Vector3& way) {
    const float along = rotation.vec().dot(way);
    const Quaternion twist(rotation.w(), along * way.x(), along * way.y(), along * way.z());
    return twist.norm() > 1e-6f ? twist.normalized() : Quaternion::Identity();
}

}  // namespace

FigureRig::FigureRig(const Body& body, const Skeleton& skeleton)
    : hips_(body.joints()[Part::hips]), chest_(body.joints()[Part::chest]) {
    Pose rest;
    place_joints(skeleton, JointAngles::at_rest(skeleton), rest);
    for (const Limb& limb : body.limbs()) {
        const Vector3 axis = rest.at(limb.b.joint, limb.b.local) - rest.at(limb.a.joint, limb.a.local);
        sources_.push_back({limb.kind, limb.a.joint, limb.b.joint, axis.stableNormalized()});
    }
}

/// Axes that the limb's own follow by the least turn: those of the trunk, or of the limb before it.
Quaternion FigureRig::base_of(std::size_t limb, const Pose& pose, std::span<const Quaternion> own) const {
    const LimbKind kind = sources_[limb].kind;
    if (is_lower(kind)) return own[limb - 1];
    return pose.rotations[kind == LimbKind::thigh ? hips_ : chest_];
}

void FigureRig::place(const Pose& pose, std::span<const TaperedCapsule> capsules,
                      std::vector<FigureLimb>& to) const {
    to.clear();
    std::vector<Quaternion> own(sources_.size());
    for (std::size_t limb = 0; limb < sources_.size(); ++limb) {
        const auto& [kind, joint_a, joint_b, rest_way] = sources_[limb];
        const Vector3 a = to_vector(capsules[limb].a), b = to_vector(capsules[limb].b);
        Quaternion at_b = pose.rotations[kind == LimbKind::shoulder ? joint_a : joint_b];
        own[limb] = pose.rotations[joint_a];
        if (is_upper(kind) || is_lower(kind)) {
            const Quaternion base = base_of(limb, pose, own);
            own[limb] = at_b = (least_turn(base * rest_way, b - a) * base).normalized();
            if (is_lower(kind)) {
                const Quaternion& end = pose.rotations[sources_[limb + 1].joint_a];
                at_b = own[limb] * twist_about(own[limb].conjugate() * end, rest_way);
            }
        }
        to.push_back({kind, a, b, capsules[limb].radius_a, capsules[limb].radius_b,
                      own[limb].toRotationMatrix(), at_b.toRotationMatrix(),
                      kind == LimbKind::hand ? flat_hand : Vector3(Vector3::Ones())});
    }
}

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

namespace {

constexpr std::uint32_t no_vertex = ~0u;

/// Adds two triangles along the shorter diagonal of a quad.
void add_quad(const std::array<std::uint32_t, 4>& quad, bool turned, Mesh& mesh) {
    const auto at = [&](std::size_t k) { return to_vector(mesh.positions[quad[k]]); };
    const std::size_t first = (at(0) - at(2)).squaredNorm() <= (at(1) - at(3)).squaredNorm() ? 0 : 1;
    for (const std::size_t k : {first, first + 2}) {
        const std::uint32_t a = quad[k % 4], b = quad[(k + 1) % 4], c = quad[(k + 2) % 4];
        mesh.triangles.push_back(turned ? Triangle{a, c, b} : Triangle{a, b, c});
    }
}

}  // namespace

CornerGrid::CornerGrid(const Eigen::AlignedBox3f& box, float cell, float outside)
    : origin_(box.min() - Vector3::Constant(1.5f * cell)), cell_(cell) {
    for (int axis = 0; axis < 3; ++axis)
        corners_[static_cast<std::size_t>(axis)] =
            static_cast<std::size_t>(std::ceil(box.sizes()[axis] / cell)) + 4;
    values_.assign(corners_[0] * corners_[1] * corners_[2], outside);
}

std::array<std::size_t, 3> CornerGrid::corner_before(const Vector3& point) const {
    std::array<std::size_t, 3> found{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        const float cells = std::clamp((point[k] - origin_[k]) / cell_, 0.0f, 1e6f);
        found[axis] = std::min(static_cast<std::size_t>(cells), corners_[axis] - 1);
    }
    return found;
}

/// The mean over the edges of the cell above this corner.
Vector3 CornerGrid::middle_of_crossings(std::size_t x, std::size_t y, std::size_t z, int& crossings) const {
    Vector3 sum = Vector3::Zero();
    crossings = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if ((corner >> axis & 1) != 0) continue;
            const std::size_t other = corner | std::size_t{1} << axis;
            const auto value = [&](std::size_t c) {
                return values_[index(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))];
            };
            const float a = value(corner), b = value(other);
            if ((a < 0) == (b < 0)) continue;
            Vector3 p = place(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
            p[static_cast<Eigen::Index>(axis)] += cell_ * a / (a - b);
            sum += p;
            ++crossings;
        }
    return crossings > 0 ? Vector3(sum / static_cast<float>(crossings)) : sum;
}

Mesh CornerGrid::surface() const {
    Mesh mesh;
    std::vector<std::uint32_t> vertex(values_.size(), no_vertex);  // of the cell above each corner
    const std::array<std::size_t, 3> step{1, corners_[0], corners_[0] * corners_[1]};
    const auto for_cells = [&](const auto& f) {
        for (std::size_t z = 0; z + 1 < corners_[2]; ++z)
            for (std::size_t y = 0; y + 1 < corners_[1]; ++y)
                for (std::size_t x = 0; x + 1 < corners_[0]; ++x) f(x, y, z);
    };
    for_cells([&](std::size_t x, std::size_t y, std::size_t z) {
        int crossings = 0;
        const Vector3 place = middle_of_crossings(x, y, z, crossings);
        if (crossings == 0) return;
        vertex[index(x, y, z)] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(to_vec3(place));
    });
    for_cells([&](std::size_t x, std::size_t y, std::size_t z) {
        const std::size_t here = index(x, y, z);
        const std::array<std::size_t, 3> at{x, y, z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
            const bool is_inside = values_[here] < 0;
            if (at[second] == 0 || at[third] == 0 || is_inside == (values_[here + step[axis]] < 0)) continue;
            const std::array<std::uint32_t, 4> quad{vertex[here - step[second] - step[third]],
                                                    vertex[here - step[third]], vertex[here],
                                                    vertex[here - step[second]]};
            add_quad(quad, !is_inside, mesh);
        }
    });
    return mesh;
}

}  // namespace weft::demo
