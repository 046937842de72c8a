#include "demo/character/body/figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "demo/character/body/surface_nets.h"

namespace weft::demo {
namespace {

constexpr float falloff = 0.6f;  // of weights with the distance from a limb, over its radius
constexpr float near_by = 1.6f;  // distance of limbs that a vertex follows, over their radius
constexpr float least_inset = 5e-4f, most_inset = 0.012f;  // [m]

/// Copies the limbs with head, hands and feet enlarged, so that an even grid meshes them finer.
std::vector<FigureLimb> enlarged(std::vector<FigureLimb> limbs) {
    const auto scale = [](FigureLimb& limb, const Vector3& about, float factor, const Vector3& shift) {
        for (Vector3* end : {&limb.a, &limb.b}) *end = about + factor * (*end - about) + shift;
        limb.radius_a *= factor;
        limb.radius_b *= factor;
    };
    for (std::size_t k = 1; k < limbs.size(); ++k) {
        FigureLimb &limb = limbs[k], &before = limbs[k - 1];
        const Vector3 way = (before.b - before.a).normalized();
        if (limb.kind == LimbKind::hand) {
            const Vector3 shift = 1.2f * limb.radius_a * way;
            before.b += shift;
            scale(limb, limb.a, 1.9f, shift);
        } else if (limb.kind == LimbKind::head) {
            const Vector3 shift = 0.35f * limb.radius_b * way;
            before.b += shift;
            scale(limb, limb.a, 1.5f, 2 * shift);
        } else if (limb.kind == LimbKind::sole) {
            const Vector3 shift = limb.radius_a * way, ankle = before.b;
            before.b += shift;
            scale(limb, ankle, 1.5f, shift);
            scale(limbs[k + 1], ankle, 1.5f, shift);  // the foot
        }
    }
    return limbs;
}

Eigen::AlignedBox3f box_about(const FigureLimb& limb, float margin) {
    Eigen::AlignedBox3f box;
    for (const auto& [end, radius] : {std::pair(limb.a, limb.radius_a), {limb.b, limb.radius_b}}) {
        box.extend(Vector3(end + Vector3::Constant(radius + margin)));
        box.extend(Vector3(end - Vector3::Constant(radius + margin)));
    }
    return box;
}

/// Meshes the field with cubes of this side.
Mesh mesh_of(const FigureField& field, std::span<const FigureLimb> limbs, float cell) {
    Eigen::AlignedBox3f all;
    for (const FigureLimb& limb : limbs) all.extend(box_about(limb, 0));
    CornerGrid grid(all, cell, 1);
    std::vector<std::uint32_t> near(grid.values().size(), 0);  // a bit for each limb
    for (std::size_t limb = 0; limb < limbs.size(); ++limb)
        grid.for_corners_in(box_about(limbs[limb], 0.04f + 2 * cell),
                            [&](const Vector3&, std::size_t at) { near[at] |= 1u << limb; });
    std::vector<std::uint8_t> list;
    grid.for_corners_in(all, [&](const Vector3& place, std::size_t at) {
        list.clear();
        for (std::size_t limb = 0; limb < limbs.size(); ++limb)
            if ((near[at] >> limb & 1) != 0) list.push_back(static_cast<std::uint8_t>(limb));
        if (!list.empty()) grid.values()[at] = field.at(place, list).distance;
    });
    return grid.surface();
}

/// A direction that turns with the limb, at a place on its axis.
Vector3 turned(const FigureLimb& limb, float along, const Vector3& aside) {
    const Vector3 at_a = limb.axes_a * aside, at_b = limb.axes_b * aside;
    const Vector3 mean = at_a + along * (at_b - at_a);
    return mean * (aside.norm() / std::max(mean.norm(), 1e-6f));
}

float share_of_hair(const FigureLimb& head, const Vector3& point) {
    const Vector3 from_skull = head.axes_a.transpose() * (point - head.b) / head.radius_b;
    return std::clamp(0.5f + 6 * (0.8f * from_skull.y() - 0.6f * from_skull.z() - 0.05f), 0.0f, 1.0f);
}

}  // namespace

Figure::Figure(std::vector<FigureLimb> stance, float cell) {
    stance = enlarged(std::move(stance));
    const FigureField field(stance);
    Mesh mesh = mesh_of(field, stance, cell);
    triangles_ = std::move(mesh.triangles);
    const auto bind_all = [&] {
        vertices_.clear();
        for (const Vec3& p : mesh.positions) vertices_.push_back(bind(to_vector(p), field, stance));
    };
    bind_all();
    smooth(field, mesh.positions);
    bind_all();
    for (std::size_t v = 0; v < size(); ++v) {
        Wear& wear = wear_.emplace_back();
        for (std::size_t k = 0; k < vertices_[v].count; ++k) {
            const FigureLimb& limb = stance[vertices_[v].limbs[k]];
            const float weight = vertices_[v].weights[k];
            if (limb.kind == LimbKind::head)
                wear.hair = share_of_hair(limb, to_vector(mesh.positions[v])) * (weight > 0.3f ? 1.0f : 0.0f);
            if (limb.kind == LimbKind::foot || limb.kind == LimbKind::sole) wear.shoe += weight;
        }
    }
}

/// Evens triangles out: vertices go to the mean of their neighbours along the surface.
void Figure::smooth(const FigureField& field, std::span<Vec3> places) const {
    constexpr int rounds = 12;
    std::vector<Vector3> sums(size());
    std::vector<float> counts(size());
    for (int round = 0; round < rounds; ++round) {
        std::ranges::fill(sums, Vector3::Zero());
        std::ranges::fill(counts, 0.0f);
        for (const Triangle& t : triangles_)
            for (std::size_t c = 0; c < 3; ++c) {
                sums[t[c]] += to_vector(places[t[(c + 1) % 3]]);
                counts[t[c]] += 1;
            }
        for (std::size_t v = 0; v < size(); ++v) {
            Vector3 p = to_vector(places[v]);
            const Vector3 way = 0.5f * (sums[v] / counts[v] - p);
            const Vector3 normal = field.at(p, vertices_[v].near()).normal;
            p += way - way.dot(normal) * normal;
            const SurfaceDistance off = field.at(p, vertices_[v].near());
            places[v] = to_vec3(p - off.distance * off.normal);
        }
    }
}

Figure::Vertex Figure::bind(const Vector3& point, const FigureField& field,
                            std::span<const FigureLimb> limbs) {
    std::vector<std::pair<float, std::uint8_t>> found;  // weight and limb
    for (std::size_t limb = 0; limb < limbs.size(); ++limb) {
        const float size = 0.5f * (limbs[limb].radius_a + limbs[limb].radius_b);
        const float away = std::max(field.of_limb(point, limb), 0.0f) / size;
        if (away > near_by) continue;
        const float part = falloff / (falloff + away);
        found.emplace_back(part * part * part * part, static_cast<std::uint8_t>(limb));
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, [](const auto& each) { return each.first; });
    found.resize(std::min(found.size(), most));
    std::ranges::sort(found, {}, [](const auto& each) { return each.second; });
    float sum = 0;
    for (const auto& each : found) sum += each.first;
    Vertex vertex;
    vertex.inset = least_inset;
    for (const auto& [weight, number] : found) {
        const FigureLimb& limb = limbs[number];
        const Vector3 axis = limb.b - limb.a;
        const std::size_t k = vertex.count++;
        const float along =
            std::clamp((point - limb.a).dot(axis) / std::max(axis.squaredNorm(), 1e-12f), 0.0f, 1.0f);
        vertex.limbs[k] = number;
        vertex.weights[k] = weight / sum;
        vertex.along[k] = along;
        vertex.aside[k] = limb.axes_a.transpose() * (point - limb.at(along)) / limb.radius(along);
    }
    return vertex;
}

Vector3 Figure::follow(const Vertex& vertex, std::span<const FigureLimb> limbs) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < vertex.count; ++k) {
        const FigureLimb& limb = limbs[vertex.limbs[k]];
        const float along = vertex.along[k];
        sum +=
            vertex.weights[k] * (limb.at(along) + limb.radius(along) * turned(limb, along, vertex.aside[k]));
    }
    return sum;
}

void Figure::place(std::span<const FigureLimb> limbs, std::span<Vec3> to) const {
    constexpr int rounds = 3;
    const FigureField field(limbs);
    std::vector<RoundCone> cones;
    for (const FigureLimb& limb : limbs) cones.emplace_back(limb.a, limb.b, limb.radius_a, limb.radius_b);
    for (std::size_t v = 0; v < size(); ++v) {
        const Vertex& vertex = vertices_[v];
        Vector3 p = follow(vertex, limbs);
        for (int round = 0; round < rounds; ++round) {
            const SurfaceDistance off = field.at(p, vertex.near());
            p -= (off.distance + vertex.inset) * off.normal;
        }
        SurfaceDistance nearest = cones[vertex.limbs[0]].distance_to(p);
        for (const std::uint8_t limb : vertex.near()) {
            const SurfaceDistance off = cones[limb].distance_to(p);
            if (off.distance < nearest.distance) nearest = off;
        }
        p -= std::max(nearest.distance + vertex.inset, 0.0f) * nearest.normal;
        to[v] = to_vec3(p);
    }
}

void Figure::keep_within(std::span<const FigureLimb> limbs) {
    constexpr int rounds = 4;
    constexpr float allowed = 3e-4f;  // [m]
    std::vector<RoundCone> cones;
    for (const FigureLimb& limb : limbs) cones.emplace_back(limb.a, limb.b, limb.radius_a, limb.radius_b);
    const auto outside = [&](const Vector3& point, const Vertex& vertex) {
        float least = 1;
        for (const std::uint8_t limb : vertex.near())
            least = std::min(least, cones[limb].distance_to(point).distance);
        return least;
    };
    std::vector<Vec3> places(size());
    std::vector<float> more(size());
    for (int round = 0; round < rounds; ++round) {
        place(limbs, places);
        std::ranges::fill(more, 0.0f);
        for (const Triangle& t : triangles_)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t a = t[c], b = t[(c + 1) % 3];
                const Vector3 middle = 0.5f * (to_vector(places[a]) + to_vector(places[b]));
                const float over =
                    std::min(outside(middle, vertices_[a]), outside(middle, vertices_[b])) - allowed;
                if (over <= 0) continue;
                more[a] = std::max(more[a], over);
                more[b] = std::max(more[b], over);
            }
        for (std::size_t v = 0; v < size(); ++v)
            vertices_[v].inset = std::min(vertices_[v].inset + more[v], most_inset);
    }
}

}  // namespace weft::demo
