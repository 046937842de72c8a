#include "demo/look/rounded_mesh.h"

#include <algorithm>
#include <map>

#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float rounding = 0.5f;  // exact where cloth is bent like a parabola

/// The middle of an edge, rounded towards the planes at its ends, but no farther than `most` of its length.
Vector3 rounded_middle(const Vector3& a, const Vector3& b, const Vector3& normal_a, const Vector3& normal_b,
                       float most) {
    const Vector3 middle = 0.5f * (a + b);
    const Vector3 on_a = middle - normal_a * normal_a.dot(middle - a);
    const Vector3 on_b = middle - normal_b * normal_b.dot(middle - b);
    const Vector3 out = rounding * (0.5f * (on_a + on_b) - middle);
    const float farthest = most * (b - a).norm();
    return middle + out * std::min(1.0f, farthest / std::max(out.norm(), 1e-9f));
}

}  // namespace

RoundedMesh::RoundedMesh(std::span<const Triangle> triangles, std::span<const Vec2> texcoords,
                         std::size_t vertices)
    : vertices_(vertices), texcoords_(texcoords.begin(), texcoords.end()) {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const std::array<std::uint32_t, 2> edge{std::min(a, b), std::max(a, b)};
        const auto [place, is_new] = middles.try_emplace(edge, static_cast<std::uint32_t>(size()));
        if (is_new) {
            edges_.push_back(edge);
            if (!texcoords_.empty())
                texcoords_.push_back(
                    {0.5f * (texcoords[a].x + texcoords[b].x), 0.5f * (texcoords[a].y + texcoords[b].y)});
        }
        return place->second;
    };
    for (const auto& [a, b, c] : triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        triangles_.insert(triangles_.end(), {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
}

void RoundedMesh::update(const ClothView& cloth, const To& to, float most) const {
    for (std::size_t i = 0; i < vertices_; ++i) {
        const std::uint32_t particle = cloth.vertex_to_particle[i];
        to.positions[i] = cloth.positions[particle];
        to.previous_positions[i] = cloth.previous_positions[particle];
        to.normals[i] = cloth.normals[particle];
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const auto [a, b] = edges_[e];
        const Vector3 normal_a = xyz(to.normals[a]), normal_b = xyz(to.normals[b]);
        const std::size_t i = vertices_ + e;
        set_xyz(to.positions[i],
                rounded_middle(xyz(to.positions[a]), xyz(to.positions[b]), normal_a, normal_b, most));
        set_xyz(to.previous_positions[i],
                rounded_middle(xyz(to.previous_positions[a]), xyz(to.previous_positions[b]), normal_a,
                               normal_b, most));
        set_xyz(to.normals[i], normal_a + normal_b);
    }
}

void RoundedMesh::spread(const ClothView& cloth, std::span<const Vec4> particles, std::span<Vec4> to) const {
    for (std::size_t i = 0; i < vertices_; ++i) to[i] = particles[cloth.vertex_to_particle[i]];
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const Vec4 &a = to[edges_[e][0]], &b = to[edges_[e][1]];
        to[vertices_ + e] = {0.5f * (a.x + b.x), 0.5f * (a.y + b.y), 0.5f * (a.z + b.z), 0.5f * (a.w + b.w)};
    }
}

}  // namespace weft::demo
