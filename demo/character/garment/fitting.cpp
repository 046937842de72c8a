#include "demo/character/garment/fitting.h"

#include <algorithm>
#include <limits>
#include <string>

#include "demo/character/garment/garment_mesh.h"

namespace weft::demo {
namespace {

constexpr float gap_held = 0.007f;         // between the body and vertices held to it [m]
constexpr float most_apart = 0.25f;        // mean move of fixed vertices, if a garment fits [m]
constexpr float least_radius_part = 0.3f;  // radii over their final size when growth begins
constexpr float deep = 0.008f;             // greater penetration depths count as deep [m]
constexpr float most_deep = 0.03f;         // greatest share of deep vertices in a garment that is wide enough
constexpr std::size_t samples = 1500;      // vertices, about, at which a place's cost is sampled

struct Nearest {
    float distance = std::numeric_limits<float>::max();
    Vector3 normal = Vector3::UnitY();
};

Nearest nearest_surface_of(const std::vector<TaperedCapsule>& capsules, const Vector3& point) {
    Nearest nearest;
    for (const TaperedCapsule& capsule : capsules) {
        const auto [distance, normal] = distance_to(capsule, point);
        if (distance < nearest.distance) nearest = {distance, normal};
    }
    return nearest;
}

/// One body in one stance, and the cost of placing a garment on it.
class FittingRoom {
  public:
    FittingRoom(const Skeleton& skeleton, const Body& body, float arms, float girth = 1) {
        Pose pose;
        place_joints(skeleton, body.stance(skeleton, arms), pose);
        body.place(pose, girth, capsules_);
        hips_ = pose.positions[body.joints()[Part::hips]];
        neck_ = pose.positions[body.joints()[Part::neck]];
    }

    [[nodiscard]] const std::vector<TaperedCapsule>& capsules() const { return capsules_; }
    /// Target of the middle of a garment's highest opening [m].
    [[nodiscard]] Vector3 place_of_opening(bool from_waist) const {
        return from_waist ? Vector3(hips_ + 0.3f * (neck_ - hips_)) : neck_;
    }

    /// Cost of a place [m^2]: mean squares of the depth inside, times 20, and of the opening's distance from
    /// gap_held.
    [[nodiscard]] float cost(const Garment& garment, const std::vector<Vector3>& normals,
                             const Vector3& shift) const {
        const std::vector<Vec3>& points = garment.mesh.positions;
        const std::size_t every = std::max<std::size_t>(points.size() / samples, 1);
        float inside = 0, apart = 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < points.size(); i += every, ++count) {
            const float depth = way_out(to_vector(points[i]) + shift, normals[i]);
            inside += depth * depth;
        }
        for (const std::uint32_t vertex : garment.fixed) {
            const float distance = nearest_surface_of(capsules_, to_vector(points[vertex]) + shift).distance;
            apart += (distance - gap_held) * (distance - gap_held);
        }
        return 20 * inside / static_cast<float>(count) +
               apart / static_cast<float>(std::max<std::size_t>(garment.fixed.size(), 1));
    }

    /// The share of the vertices that lie deep inside.
    [[nodiscard]] float share_inside(const Mesh& mesh, const std::vector<Vector3>& normals) const {
        std::size_t inside = 0;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            inside += way_out(to_vector(mesh.positions[i]), normals[i]) > deep;
        return static_cast<float>(inside) / static_cast<float>(mesh.positions.size());
    }

    /// Moves a point inside the body, or any point where `draw`, to gap_held from the body.
    [[nodiscard]] Vec3 held(const Vec3& start, bool draw) const {
        Vector3 p = to_vector(start);
        for (int i = 0; i < 20; ++i) {
            const auto [distance, normal] = nearest_surface_of(capsules_, p);
            if (distance >= 0 && !draw) break;
            p += (gap_held - distance) * normal;
        }
        return to_vec3(p);
    }

  private:
    /// Depth along the garment's own normal [m]: a point beyond a limb's axis has to cross the limb.
    [[nodiscard]] float way_out(const Vector3& point, const Vector3& normal) const {
        float way = 0;
        for (int i = 0; i < 20; ++i) {
            const float distance = nearest_surface_of(capsules_, point + way * normal).distance;
            if (distance >= 0) break;
            way += std::max(-distance, 0.004f);
        }
        return way;
    }

    std::vector<TaperedCapsule> capsules_;
    Vector3 hips_, neck_;
};

struct Place {
    float cost = std::numeric_limits<float>::max();
    float arms = Fit().arms;
    Vector3 shift = Vector3::Zero();
};

/// Updates `best` with the cheapest of a grid of places about `centre`.
void search(const FittingRoom& room, const Garment& garment, const std::vector<Vector3>& normals, float arms,
            const Vector3& centre, float reach, int steps, Place& best) {
    for (int y = -steps; y <= steps; ++y) {
        for (int z = -2; z <= 2; ++z) {
            const float step = reach / static_cast<float>(steps);
            const Vector3 shift =
                centre + Vector3(0, static_cast<float>(y) * step, 0.5f * static_cast<float>(z) * step);
            const float cost = room.cost(garment, normals, shift);
            if (cost < best.cost) best = {cost, arms, shift};
        }
    }
}

Place find_place(const Skeleton& skeleton, const Body& body, const Garment& garment) {
    Vector3 opening = Vector3::Zero();
    for (const std::uint32_t vertex : garment.fixed)
        opening += to_vector(garment.mesh.positions[vertex]) / static_cast<float>(garment.fixed.size());
    const std::vector<Vector3> normals = outward_normals(garment.mesh);
    Place best;
    for (const float arms : {25.0f, 40.0f, 55.0f, 70.0f}) {
        const FittingRoom room(skeleton, body, arms);
        search(room, garment, normals, arms, room.place_of_opening(garment.from_waist) - opening, 0.08f, 4,
               best);
    }
    for (const float turn : {-8.0f, 0.0f, 8.0f}) {
        const float arms = best.arms + turn;
        const FittingRoom room(skeleton, body, arms);
        search(room, garment, normals, arms, best.shift, 0.03f, 3, best);
    }
    return best;
}

/// The greatest girth for which the garment is wide enough, at least 0.8.
float find_girth(const Skeleton& skeleton, const Body& body, const Mesh& mesh, float arms) {
    const std::vector<Vector3> normals = outward_normals(mesh);
    float girth = 1;
    while (girth > 0.81f && FittingRoom(skeleton, body, arms, girth).share_inside(mesh, normals) > most_deep)
        girth -= 0.05f;
    return girth;
}

}  // namespace

Result<Fit> fit(const Skeleton& skeleton, const Body& body, Garment& garment) {
    Fit fit;
    if (!garment.stands_ready) {
        const Place place = find_place(skeleton, body, garment);
        fit.arms = place.arms;
        for (std::vector<Vec3>* positions : {&garment.mesh.positions, &garment.fine.positions})
            for (Vec3& p : *positions) p = to_vec3(to_vector(p) + place.shift);
        fit.girth = find_girth(skeleton, body, garment.mesh, fit.arms);
    }
    const FittingRoom room(skeleton, body, fit.arms, fit.girth);
    float apart = 0;
    for (const std::uint32_t vertex : garment.fixed) {
        const Vec3& start = garment.mesh.positions[vertex];
        fit.held.push_back(room.held(start, !garment.stands_ready));
        apart +=
            (to_vector(fit.held.back()) - to_vector(start)).norm() / static_cast<float>(garment.fixed.size());
    }
    if (!(apart <= most_apart))
        return Error{ErrorCode::invalid_mesh, "the garment does not fit: what is fixed of it is " +
                                                  std::to_string(apart) + " m from the body; at most " +
                                                  std::to_string(most_apart) + " can be drawn up"};
    for (const Vec3& p : garment.mesh.positions) {
        const float depth = -nearest_surface_of(room.capsules(), to_vector(p)).distance;
        if (depth <= 0) continue;
        ++fit.inside;
        fit.deepest = std::max(fit.deepest, depth);
    }
    return fit;
}

float growth_at(double time, double duration) {
    if (time >= duration) return 1;
    return least_radius_part + (1 - least_radius_part) * smooth_step(time / duration);
}

}  // namespace weft::demo
