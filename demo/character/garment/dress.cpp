#include <algorithm>
#include <cmath>
#include <numbers>

#include "demo/character/garment/garment.h"

namespace weft::demo {
namespace {

constexpr float gap = 0.009f;         // between body and dress [m]
constexpr float flare = 0.42f;        // growth of the skirt's radius over its drop in height
constexpr float bodice_part = 0.33f;  // share of the rows

/// Rings about the body's axis, from the bodice's rim to the hem.
class DressMaker {
  public:
    DressMaker(const Body& body, const Pose& pose) {
        const auto at = [&](Part part) { return pose.positions[body.joints()[part]]; };
        for (std::size_t limb = 0; limb < body.limbs().size(); ++limb) {
            if (is_trunk(body, limb)) trunk_.push_back(body.placed(limb, pose));
        }
        const float hips = at(Part::hips).y();
        top_ = hips + 0.80f * (at(Part::neck).y() - hips);
        waist_ = hips + 0.30f * (at(Part::neck).y() - hips);
        hem_ = at(Part::left_shin).y() - 0.02f;
        axis_ = at(Part::hips);
    }

    [[nodiscard]] Garment make(std::uint32_t vertices) const {
        // Along the hem, the widest ring, two vertices have the length of three down the skirt.
        const auto columns = static_cast<std::uint32_t>(std::lround(std::sqrt(1.85 * vertices)));
        const std::uint32_t rows = vertices / columns;
        const auto fixed_rows =
            std::max(2u, static_cast<std::uint32_t>(std::lround(bodice_part * static_cast<float>(rows))));
        Garment dress;
        dress.stands_ready = true;
        std::vector<float> radii(columns, 0.0f);
        for (std::uint32_t row = 0; row < rows; ++row) {
            const float height = height_of(row, rows, fixed_rows);
            for (std::uint32_t column = 0; column < columns; ++column) {
                const float angle =
                    2 * std::numbers::pi_v<float> * static_cast<float>(column) / static_cast<float>(columns);
                float& radius = radii[column];
                const float near = radius_at(height, angle);
                const float drop = row < fixed_rows ? 0 : height_of(row - 1, rows, fixed_rows) - height;
                radius = row < fixed_rows ? near : std::max(near, radius + flare * drop);
                const Vector3 p =
                    axis_ + Vector3(radius * std::sin(angle), height - axis_.y(), radius * std::cos(angle));
                if (row < fixed_rows)
                    dress.fixed.push_back(static_cast<std::uint32_t>(dress.mesh.positions.size()));
                dress.mesh.positions.push_back(to_vec3(p));
                dress.mesh.texcoords.push_back({0.25f * angle, top_ - height});
            }
        }
        for (std::uint32_t row = 0; row + 1 < rows; ++row) {
            for (std::uint32_t column = 0; column < columns; ++column)
                add_cell(row, column, columns, dress.mesh);
        }
        return dress;
    }

  private:
    static bool is_trunk(const Body& body, std::size_t limb) {
        const std::size_t joint = body.limbs()[limb].a.joint;
        const BodyJoints& joints = body.joints();
        return joint == joints[Part::hips] || joint == joints.spine || joint == joints[Part::left_thigh] ||
               joint == joints[Part::right_thigh];
    }

    [[nodiscard]] float height_of(std::uint32_t row, std::uint32_t rows, std::uint32_t fixed_rows) const {
        const auto r = static_cast<float>(row), last_fixed = static_cast<float>(fixed_rows - 1);
        if (row < fixed_rows) return top_ + (waist_ - top_) * r / last_fixed;
        return waist_ + (hem_ - waist_) * (r - last_fixed) / (static_cast<float>(rows - 1) - last_fixed);
    }

    /// Radius at which a ray from outside first comes within the gap of the trunk; at least 0.02 [m].
    [[nodiscard]] float radius_at(float height, float angle) const {
        const Vector3 out(std::sin(angle), 0, std::cos(angle));
        float radius = 0.6f;
        for (int i = 0; i < 60 && radius > 0.02f; ++i) {
            const Vector3 p = axis_ + radius * out + Vector3(0, height - axis_.y(), 0);
            float nearest = 1;
            for (const TaperedCapsule& capsule : trunk_)
                nearest = std::min(nearest, distance_to(capsule, p).distance);
            if (nearest - gap < 1e-4f) break;
            radius -= nearest - gap;
        }
        return std::max(radius, 0.02f);
    }

    static void add_cell(std::uint32_t row, std::uint32_t column, std::uint32_t columns, Mesh& mesh) {
        const std::uint32_t next = (column + 1) % columns;
        const std::uint32_t a = row * columns + column, b = row * columns + next, c = a + columns,
                            d = b + columns;
        if ((row + column) % 2 == 0) {
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({b, c, d});
        } else {
            mesh.triangles.push_back({a, c, d});
            mesh.triangles.push_back({a, d, b});
        }
    }

    std::vector<TaperedCapsule> trunk_;
    Vector3 axis_;
    float top_ = 0, waist_ = 0, hem_ = 0;  // heights [m]
};

}  // namespace

Garment make_dress(const Body& body, const Pose& pose, std::uint32_t vertices) {
    return DressMaker(body, pose).make(std::max(vertices, 16u));
}

}  // namespace weft::demo
