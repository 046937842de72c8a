#include "demo/character/figure/figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "demo/character/figure/figure_field.h"

namespace weft::demo {

namespace {

constexpr float falloff = 0.6f;  // of weights with the distance from a limb, over its radius
constexpr float near_by = 1.1f;  // distance of limbs that a vertex follows, over their radius
constexpr float inset = 5e-4f;   // below the surface of the limbs, for rounding and chords [m]

/// Enlarges a limb about a point: its length, and the radii of its ends.
void enlarge(FigureLimb& limb, const Vector3& about, float longer, float wider_a, float wider_b,
             const Vector3& shift) {
    for (Vector3* end : {&limb.a, &limb.b}) *end = about + longer * (*end - about) + shift;
    limb.radius_a *= wider_a;
    limb.radius_b *= wider_b;
}

/// Copies the limbs with head, hands and feet enlarged, and arms thickened, so that an even grid meshes them
/// finer. They grow from where they are joined.
std::vector<FigureLimb> enlarged(std::vector<FigureLimb> limbs) {
    for (std::size_t k = 1; k < limbs.size(); ++k) {
        FigureLimb &limb = limbs[k], &before = limbs[k - 1];
        const Vector3 joint = before.b, way = (before.b - before.a).stableNormalized();
        const auto lengthen = [&](float by, float wider) {
            before.b += by * before.radius_b * way;
            before.radius_b *= wider;
            return Vector3(before.b - joint);
        };
        if (limb.kind == LimbKind::forearm) {
            before.radius_b *= 1.4f;
            limb.radius_a *= 1.4f;
        } else if (limb.kind == LimbKind::hand) {
            enlarge(limb, joint, 2.4f, 1.8f, 3.0f, lengthen(1.5f, 1.8f));
            limb.scale.setOnes();
        } else if (limb.kind == LimbKind::head) {
            enlarge(limb, joint, 2.0f, 1.6f, 2.0f, lengthen(1.0f, 1.35f));
        } else if (limb.kind == LimbKind::sole) {
            const Vector3 shift = lengthen(1.2f, 1.3f);
            enlarge(limb, joint, 1.6f, 1.5f, 1.6f, shift);
            enlarge(limbs[k + 1], joint, 1.6f, 1.3f, 1.6f, shift);  // the foot
        }
    }
    return limbs;
}

/// Meshes the field with cubes of this side.
Mesh mesh_of(const FigureField& field, std::span<const FigureLimb> limbs, float cell) {
    Eigen::AlignedBox3f all;
    for (const FigureLimb& limb : limbs) all.extend(limb.box());
    CornerGrid grid(all, cell, 1);
    std::vector<std::uint32_t> near(grid.values().size(), 0);  // a bit for each limb
    for (std::size_t limb = 0; limb < limbs.size(); ++limb)
        grid.for_corners_in(limbs[limb].box(4 * cell),
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

/// Where triangles are sampled: their corners' shares, in quarters, without the corners themselves.
constexpr std::array<std::array<float, 3>, 12> samples{{{2, 2, 0},
                                                        {0, 2, 2},
                                                        {2, 0, 2},
                                                        {2, 1, 1},
                                                        {1, 2, 1},
                                                        {1, 1, 2},
                                                        {3, 1, 0},
                                                        {1, 3, 0},
                                                        {0, 3, 1},
                                                        {0, 1, 3},
                                                        {3, 0, 1},
                                                        {1, 0, 3}}};

/// The limbs' surfaces that cloth meets, at one point.
struct Depth {
    SurfaceDistance surface{std::numeric_limits<float>::max(), Vector3::UnitY()};  // of the nearest
    std::uint32_t holders = 0;  // a bit for each limb that contains the point
};

Depth depth_in(std::span<const RoundCone> cones, std::span<const std::uint8_t> limbs, const Vector3& point) {
    Depth depth;
    for (const std::uint8_t limb : limbs) {
        const SurfaceDistance surface = cones[limb].distance_to(point);
        if (surface.distance < depth.surface.distance) depth.surface = surface;
        if (surface.distance <= 0) depth.holders |= 1u << limb;
    }
    return depth;
}

bool is_inside(std::span<const RoundCone> cones, std::span<const std::uint8_t> limbs, const Vector3& point) {
    return std::ranges::any_of(limbs, [&](std::uint8_t limb) { return cones[limb].contains(point); });
}

bool is_in_suit(LimbKind kind) {
    return kind == LimbKind::trunk || kind == LimbKind::thigh || kind == LimbKind::shin;
}
bool is_in_sleeve(LimbKind kind) {
    return kind == LimbKind::shoulder || kind == LimbKind::arm;
}

/// Hair is above a plane that slants from the brow to the nape, and not on the ears.
float share_of_hair(const FigureLimb& head, const Vector3& point) {
    const Vector3 from_skull = head.axes_a.transpose() * (point - head.b) / head.radius_b;
    const float above = 0.8f * from_skull.y() - 0.6f * from_skull.z() + 0.2f;
    const float ear = std::max(std::abs(from_skull.x()) - 0.76f, 0.0f);
    return std::clamp(0.5f + 6 * above - 20 * ear, 0.0f, 1.0f);
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
            if (is_in_suit(limb.kind)) wear.suit += weight;
            if (is_in_sleeve(limb.kind)) wear.sleeve += weight;
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
    std::vector<std::pair<float, std::uint8_t>> found;  // distance over the radius, and limb
    for (std::size_t limb = 0; limb < limbs.size(); ++limb) {
        const float size = 0.5f * (limbs[limb].radius_a + limbs[limb].radius_b);
        found.emplace_back(std::max(field.of_limb(point, limb), 0.0f) / size,
                           static_cast<std::uint8_t>(limb));
    }
    std::ranges::sort(found);
    std::size_t kept = 1;
    while (kept < std::min(found.size(), most) && found[kept].first <= near_by) ++kept;
    found.resize(kept);
    for (auto& [weight, limb] : found) weight = std::pow(falloff / (falloff + weight), 4.0f);
    std::ranges::sort(found, {}, [](const auto& each) { return each.second; });
    float sum = 0;
    for (const auto& each : found) sum += each.first;
    Vertex vertex;
    for (const auto& [weight, number] : found) {
        const FigureLimb& limb = limbs[number];
        const Vector3 axis = limb.b - limb.a;
        const std::size_t k = vertex.count++;
        const float along =
            std::clamp((point - limb.a).dot(axis) / std::max(axis.squaredNorm(), 1e-12f), 0.0f, 1.0f);
        vertex.limbs[k] = number;
        vertex.weights[k] = weight / sum;
        vertex.along[k] = along;
        vertex.aside[k] = (limb.axes_a.transpose() * (point - limb.at(along)) / limb.radius(along))
                              .cwiseQuotient(limb.scale);
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
    constexpr int rounds = 2, presses = 4;
    const FigureField field(limbs);
    std::vector<RoundCone> cones;
    for (const FigureLimb& limb : limbs) cones.emplace_back(limb.a, limb.b, limb.radius_a, limb.radius_b);
    std::vector<std::uint32_t> holders(size());
    for (std::size_t v = 0; v < size(); ++v) {
        const Vertex& vertex = vertices_[v];
        Vector3 p = follow(vertex, limbs);
        for (int round = 0; round < rounds; ++round) {
            const SurfaceDistance off = field.at(p, vertex.near());
            p -= (off.distance + inset) * off.normal;
        }
        to[v] = to_vec3(p);
        holders[v] = keep_inside(v, cones, to);
    }
    std::vector<std::uint8_t> is_new(size(), 1);  // moved since its triangles were sampled
    for (int press = 0; press < presses; ++press) {
        std::vector<std::uint8_t> moved(size(), 0);
        for (const Triangle& t : triangles_)
            if ((holders[t[0]] & holders[t[1]] & holders[t[2]]) == 0 &&
                (is_new[t[0]] | is_new[t[1]] | is_new[t[2]]) != 0)
                press_inside(t, field, cones, {holders, moved, to});
        is_new = std::move(moved);
    }
}

/// Moves a vertex that is outside of all limbs to the nearest; returns which limbs contain it.
std::uint32_t Figure::keep_inside(std::size_t v, std::span<const RoundCone> cones,
                                  std::span<Vec3> places) const {
    const Vector3 p = to_vector(places[v]);
    const Depth depth = depth_in(cones, vertices_[v].near(), p);
    if (depth.holders != 0) return depth.holders;
    const Vector3 moved = p - (depth.surface.distance + inset) * depth.surface.normal;
    places[v] = to_vec3(moved);
    return depth_in(cones, vertices_[v].near(), moved).holders;
}

/// Moves a triangle's corners inwards where it spans the crease between limbs. Limbs are convex: a triangle
/// within one of them needs no more than its corners.
void Figure::press_inside(const Triangle& triangle, const FigureField& field,
                          std::span<const RoundCone> cones, const Placing& of) const {
    const std::array<std::span<const std::uint8_t>, 3> near{
        vertices_[triangle[0]].near(), vertices_[triangle[1]].near(), vertices_[triangle[2]].near()};
    for (const std::array<float, 3>& parts : samples) {
        Vector3 point = Vector3::Zero();
        for (std::size_t c = 0; c < 3; ++c) point += 0.25f * parts[c] * to_vector(of.places[triangle[c]]);
        if (std::ranges::any_of(near, [&](const auto& limbs) { return is_inside(cones, limbs, point); }))
            continue;
        SurfaceDistance nearest = depth_in(cones, near[0], point).surface;
        for (const auto& limbs : {near[1], near[2]}) {
            const SurfaceDistance other = depth_in(cones, limbs, point).surface;
            if (other.distance < nearest.distance) nearest = other;
        }
        const Vector3 way = field.at(point, near[0]).normal;  // out of the crease
        const float by = nearest.distance / std::max(way.dot(nearest.normal), 0.4f);
        for (std::size_t c = 0; c < 3; ++c) {
            if (parts[c] == 0) continue;
            const std::uint32_t v = triangle[c];
            of.places[v] = to_vec3(to_vector(of.places[v]) - by * way);
            of.holders[v] = keep_inside(v, cones, of.places);
            of.moved[v] = 1;
        }
    }
}

namespace {

constexpr float arms_of_stance = 35, legs_of_stance = 0.25f;  // as Body::stance() takes them

/// The longest side of a box about all limbs [m].
float extent(const std::vector<FigureLimb>& limbs) {
    Eigen::AlignedBox3f all;
    for (const FigureLimb& limb : limbs) all.extend(limb.box());
    return all.sizes().maxCoeff();
}

}  // namespace

BodyFigure::BodyFigure(const Body& body, const Skeleton& skeleton, float edges) : rig_(body, skeleton) {
    Pose pose;
    std::vector<TaperedCapsule> capsules;
    std::vector<FigureLimb> limbs;
    place_joints(skeleton, body.stance(skeleton, arms_of_stance, legs_of_stance), pose);
    body.place(pose, 1, capsules);
    rig_.place(pose, capsules, limbs);
    figure_ = Figure(limbs, extent(limbs) / edges);
}

void BodyFigure::place(const Pose& pose, std::span<const TaperedCapsule> capsules, std::span<Vec3> to) const {
    std::vector<FigureLimb> limbs;
    rig_.place(pose, capsules, limbs);
    figure_.place(limbs, to);
}

}  // namespace weft::demo
