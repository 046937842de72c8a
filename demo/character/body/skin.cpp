#include "demo/character/body/skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace weft::demo {
namespace {

constexpr float legs_apart = 0.25f, arms_lowered = 30;  // stance in which limbs are joined; arms in degrees

struct NearestLimb {
    SurfaceDistance surface{std::numeric_limits<float>::max(), Vector3::UnitY()};
    std::size_t limb = 0;
};

NearestLimb nearest_limb(const std::vector<TaperedCapsule>& limbs, const Vector3& point) {
    NearestLimb nearest;
    for (std::size_t limb = 0; limb < limbs.size(); ++limb) {
        const SurfaceDistance found = distance_to(limbs[limb], point);
        if (found.distance < nearest.surface.distance) nearest = {found, limb};
    }
    return nearest;
}

/// The surface at distance 0 from the limbs, from distances at the corners of a grid.
class Tetrahedra {
  public:
    Tetrahedra(const std::vector<TaperedCapsule>& limbs, float cell) : limbs_(limbs), cell_(cell) {
        Eigen::AlignedBox3f box;
        for (const TaperedCapsule& limb : limbs) {
            for (const auto& [end, radius] : {std::pair(limb.a, limb.radius_a), {limb.b, limb.radius_b}}) {
                box.extend(Vector3(to_vector(end) + Vector3::Constant(radius)));
                box.extend(Vector3(to_vector(end) - Vector3::Constant(radius)));
            }
        }
        origin_ = box.min() - Vector3::Constant(1.5f * cell);
        for (int axis = 0; axis < 3; ++axis)
            corners_[static_cast<std::size_t>(axis)] =
                static_cast<std::size_t>(std::ceil(box.sizes()[axis] / cell)) + 4;
        find_distances();
    }

    /// Splits each cell into six tetrahedra about its long diagonal; neighbours split shared sides alike.
    [[nodiscard]] Mesh surface() {
        constexpr std::array<std::array<std::size_t, 4>, 6> of_cell{
            {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
        for (std::size_t z = 0; z + 1 < corners_[2]; ++z)
            for (std::size_t y = 0; y + 1 < corners_[1]; ++y)
                for (std::size_t x = 0; x + 1 < corners_[0]; ++x)
                    for (const auto& tetrahedron : of_cell) {
                        std::array<std::size_t, 4> at{};
                        for (std::size_t k = 0; k < 4; ++k) {
                            const std::size_t c = tetrahedron[k];
                            at[k] = index(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
                        }
                        cut(at);
                    }
        return std::move(mesh_);
    }

  private:
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
        return x + corners_[0] * (y + corners_[1] * z);
    }
    [[nodiscard]] Vector3 corner(std::size_t at) const {
        const std::size_t x = at % corners_[0], rows = at / corners_[0];
        return origin_ + cell_ * Vector3(static_cast<float>(x), static_cast<float>(rows % corners_[1]),
                                         static_cast<float>(rows / corners_[1]));
    }
    /// Computes distances at all corners. Those next to 0 are enlarged: triangles would have no area there.
    void find_distances() {
        distances_.resize(corners_[0] * corners_[1] * corners_[2]);
        const float least = 0.15f * cell_;
        for (std::size_t at = 0; at < distances_.size(); ++at) {
            const float distance = nearest_limb(limbs_, corner(at)).surface.distance;
            distances_[at] = std::abs(distance) < least ? std::copysign(least, distance) : distance;
        }
    }

    std::uint32_t vertex_between(std::size_t a, std::size_t b) {
        if (a > b) std::swap(a, b);
        const auto [found, is_new] = vertices_.try_emplace(a * distances_.size() + b, 0u);
        if (is_new) {
            const float part = distances_[a] / (distances_[a] - distances_[b]);
            Vector3 p = corner(a) + part * (corner(b) - corner(a));
            const SurfaceDistance off = nearest_limb(limbs_, p).surface;
            p -= off.distance * off.normal;
            found->second = static_cast<std::uint32_t>(mesh_.positions.size());
            mesh_.positions.push_back(to_vec3(p));
        }
        return found->second;
    }
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
        mesh_.triangles.push_back(turned ? Triangle{a, c, b} : Triangle{a, b, c});
    }
    /// Adds a tetrahedron's triangles. Their winding relies on all tetrahedra having the same orientation.
    void cut(const std::array<std::size_t, 4>& at) {
        std::array<std::size_t, 4> order{};  // corners inside first; `odd`: its parity
        std::size_t inside = 0;
        for (std::size_t k = 0; k < 4; ++k)
            if (distances_[at[k]] < 0) order[inside++] = k;
        if (inside == 0 || inside == 4) return;
        for (std::size_t k = 0, next = inside; k < 4; ++k)
            if (!(distances_[at[k]] < 0)) order[next++] = k;
        bool odd = false;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t l = k + 1; l < 4; ++l) odd ^= order[k] > order[l];
        const auto edge = [&](std::size_t k, std::size_t l) {
            return vertex_between(at[order[k]], at[order[l]]);
        };
        if (inside == 1) {
            add(edge(0, 1), edge(0, 2), edge(0, 3), odd);
        } else if (inside == 3) {
            add(edge(3, 0), edge(3, 1), edge(3, 2), odd);
        } else {
            const std::uint32_t a = edge(0, 2), b = edge(0, 3), c = edge(1, 3), d = edge(1, 2);
            add(a, b, c, odd);
            add(a, c, d, odd);
        }
    }

    const std::vector<TaperedCapsule>& limbs_;
    float cell_;
    Vector3 origin_;
    std::array<std::size_t, 3> corners_{};
    std::vector<float> distances_;
    std::unordered_map<std::size_t, std::uint32_t> vertices_;  // by edge
    Mesh mesh_;
};

}  // namespace

Skin Skin::round_limbs(const Body& body, const Skeleton& skeleton, float girth, float cell) {
    Pose pose;
    place_joints(skeleton, body.stance(skeleton, arms_lowered, legs_apart), pose);
    std::vector<TaperedCapsule> limbs;
    body.place(pose, girth, limbs);
    const Mesh mesh = Tetrahedra(limbs, cell).surface();
    Skin skin;
    skin.triangles_ = mesh.triangles;
    skin.binding_ = Binding::to_nearest(body, pose, mesh.positions);
    for (const Vec3& p : mesh.positions) {
        const std::size_t limb = nearest_limb(limbs, to_vector(p)).limb;
        skin.cores_.push_back({limb, part_along(limbs[limb], to_vector(p))});
    }
    return skin;
}

Result<Skin> Skin::by_weights(const Mesh& mesh, const Pose& pose, std::span<const std::uint32_t> joints,
                              std::span<const float> weights) {
    auto binding = Binding::by_weights(pose, mesh.positions, joints, weights);
    if (!binding) return binding.error();
    Skin skin;
    skin.triangles_ = mesh.triangles;
    skin.binding_ = std::move(*binding);
    return skin;
}

void Skin::place(const Pose& pose, const std::vector<TaperedCapsule>& limbs, float growth,
                 std::span<Vec3> to) const {
    binding_.place(pose, to);
    if (growth == 1) return;
    for (std::size_t v = 0; v < cores_.size(); ++v) {
        const TaperedCapsule& limb = limbs[cores_[v].limb];
        const Vector3 a = to_vector(limb.a), core = a + cores_[v].along * (to_vector(limb.b) - a);
        to[v] = to_vec3(core + growth * (to_vector(to[v]) - core));
    }
}

}  // namespace weft::demo
