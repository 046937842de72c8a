#pragma once
// A hung sheet that something thin or fast strikes, and which side of it the sheet ends on.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/vector.h"
#include "weft/weft.h"

namespace weft::test {

/// What strikes: at time t [s] it is at(t), until `stops`; probes are points in it at the end.
struct Striker {
    void add_to(World&) {}

    enum class Kind { bar, ball, sword } kind;
    float speed;   ///< [m/s]; of a sword its tip's
    float radius;  ///< [m]

    static constexpr float behind = -0.3f, beyond = 0.3f;  // where bar and ball begin and stop [m]
    static constexpr float first_angle = -0.15f, last_angle = 0.7f;

    [[nodiscard]] float stops() const {
        return (kind == Kind::sword ? last_angle - first_angle : beyond - behind) / speed;
    }
    [[nodiscard]] Collider at(float t) const {
        const float way = speed * std::min(t, stops());
        if (kind == Kind::ball) return {Sphere{{0.013f, 0.507f, behind + way}, radius}, 0.4f};
        if (kind == Kind::bar)
            return {Capsule{{-0.8f, 0.42f, behind + way}, {0.8f, 0.58f, behind + way}, radius}, 0.4f};
        return {Capsule{{-0.05f, 1.3f, -0.3f}, tip(first_angle + way), radius}, 0.4f};
    }
    [[nodiscard]] std::vector<Vector3> probes() const {
        const Collider end = at(stops());
        if (const auto* const ball = std::get_if<Sphere>(&end.shape)) return {to_vector(ball->center)};
        const auto& bar = std::get<Capsule>(end.shape);
        std::vector<Vector3> points;
        for (int k = 0; k <= 40; ++k) {
            const float s = 0.01f + 0.98f * static_cast<float>(k) / 40;
            const Vector3 p = (1 - s) * to_vector(bar.a) + s * to_vector(bar.b);
            if (std::abs(p.x()) < 0.4f && p.y() < 0.9f && p.z() > 0.05f) points.push_back(p);
        }
        return points;
    }

  private:
    [[nodiscard]] static Vec3 tip(float angle) {
        return {0.05f, 1.3f - std::cos(angle), -0.3f + std::sin(angle)};
    }
};

/// A plate of a square or twelve corners, a box, a hull or a mesh, that flies broadside on.
struct Plate {
    enum class Kind { box, hull, mesh } kind;
    float speed, radius, half;  ///< [m/s], [m]; half the thickness [m]
    ShapeId shape{};

    void add_to(World& world) {
        constexpr std::uint32_t corners = 12;
        std::vector<Vec3> vertices;
        std::vector<Triangle> triangles;
        for (std::uint32_t k = 0; k < corners; ++k) {
            const float angle = 2 * 3.14159265f * static_cast<float>(k) / corners;
            for (const float z : {-half, half})
                vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
            const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % corners);
            triangles.insert(triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
            if (k > 0 && b > 0) triangles.insert(triangles.end(), {{0, b, a}, {1, a + 1, b + 1}});
        }
        if (kind == Kind::hull) shape = world.add_shape(ConvexHull{vertices}).value();
        if (kind == Kind::mesh) shape = world.add_shape(TriangleMesh{vertices, triangles}).value();
    }
    [[nodiscard]] float stops() const { return (Striker::beyond - Striker::behind) / speed; }
    [[nodiscard]] Collider at(float t) const {
        const Vec3 middle{0.013f, 0.507f, Striker::behind + speed * std::min(t, stops())};
        if (kind == Kind::box) return {.shape = Box{middle, {}, {radius, radius, half}}};
        return {.shape = PlacedShape{shape, middle}};
    }
    [[nodiscard]] std::vector<Vector3> probes() const {
        std::vector<Vector3> points;
        for (float y = -0.9f; y < 1; y += 0.3f)
            for (float x = -0.9f; x < 1; x += 0.3f)
                if (kind == Kind::box || x * x + y * y < 0.85f)
                    points.push_back({0.013f + radius * x, 0.507f + radius * y, Striker::beyond});
        return points;
    }
};

/// How often the sheet lies before a point, less how often it lies so turned over.
inline int layers_before(const ClothView& view, const Vector3& point) {
    int layers = 0;
    for (const Triangle& t : view.triangles) {
        const Vector3 a = xyz(view.positions[t[0]]) - point, b = xyz(view.positions[t[1]]) - point,
                      c = xyz(view.positions[t[2]]) - point;
        const auto side = [](const Vector3& p, const Vector3& q) {
            return static_cast<double>(p.x()) * static_cast<double>(q.y()) -
                   static_cast<double>(p.y()) * static_cast<double>(q.x());
        };
        const double u = side(b, c), v = side(c, a), w = side(a, b), area = u + v + w;
        if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || area == 0) continue;
        const double z = (u * static_cast<double>(a.z()) + v * static_cast<double>(b.z()) +
                          w * static_cast<double>(c.z())) /
                         area;
        if (z > 0) layers += area > 0 ? 1 : -1;
    }
    return layers;
}

struct Struck {
    float carried;      ///< part of the probes that have the sheet before them
    float fastest = 0;  ///< of its particles [m/s]
    bool sound = true;  ///< no step was taken back
};

/// phase: of a step, at which the striker sets out.
template <class Thing>
Struck strike(Thing striker, std::uint32_t side, float phase, int substeps = 1) {
    constexpr float h = 1.0f / 60;
    World world = World::create({.substeps = substeps}).value();
    ClothSettings settings;
    settings.thickness = 0.005f;
    const Mesh mesh =
        make_sheet({.rows = side, .columns = side, .origin = {-0.5f, 1, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}})
            .value();
    const ClothId cloth = world.add_cloth(mesh, settings).value();
    std::vector<std::uint32_t> top(side);
    for (std::uint32_t k = 0; k < side; ++k) top[k] = k;
    (void)world.pin(cloth, top);
    striker.add_to(world);
    const ColliderId id = world.add_collider(striker.at(0)).value();
    Struck struck{};
    const int turn = layers_before(world.cloth(cloth).value(), {0.01f, 0.5f, -1});
    const int last = static_cast<int>(std::ceil((striker.stops() + phase * h) / h)) + 2;
    for (int step = 1; step <= last; ++step) {
        (void)world.move_collider(id, striker.at((static_cast<float>(step) - phase) * h));
        const StepReport& report = world.step(h);
        struck.sound = struck.sound && !has(report.flags, StepFlags::state_restored);
        struck.fastest = std::max(struck.fastest, report.peak_speed);
    }
    const std::vector<Vector3> probes = striker.probes();
    const ClothView view = world.cloth(cloth).value();
    const auto carried =
        std::ranges::count_if(probes, [&](const Vector3& p) { return layers_before(view, p) == turn; });
    struck.carried = static_cast<float>(carried) / static_cast<float>(probes.size());
    return struck;
}

}  // namespace weft::test
