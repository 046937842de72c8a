#include "collision/shapes/hull.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "collision/shapes/triangles/ranges.h"
#include "engine/error_text.h"

namespace weft {

namespace {

using Vector3d = Eigen::Vector3d;
constexpr std::size_t most_points = 1u << 16;

/// A hull that grows by a point at a time: faces visible from it are removed, and their outline is joined to
/// it (the beneath-beyond method; Kallay 1981).
class Hull {
  public:
    Hull(std::span<const Vec3> points, double tolerance) : tolerance_(tolerance) {
        for (const Vec3& p : points) points_.push_back(to_vector(p).cast<double>());
    }
    /// Makes the first tetrahedron. False if all points lie within the tolerance of a plane.
    [[nodiscard]] bool begin() {
        const auto farthest_by = [&](const auto& measure) {
            std::uint32_t best = 0;
            for (std::uint32_t p = 1; p < points_.size(); ++p)
                if (measure(points_[p]) > measure(points_[best])) best = p;
            return best;
        };
        std::uint32_t a = farthest_by([](const Vector3d& p) { return -p.x(); });
        const std::uint32_t b =
            farthest_by([&](const Vector3d& p) { return (p - points_[a]).squaredNorm(); });
        const Vector3d ab = (points_[b] - points_[a]).normalized();
        const auto c =
            farthest_by([&](const Vector3d& p) { return (p - points_[a]).cross(ab).squaredNorm(); });
        const Vector3d n = ab.cross(points_[c] - points_[a]);
        if (!(n.norm() > tolerance_)) return false;
        const Vector3d unit = n.normalized();
        const auto d = farthest_by([&](const Vector3d& p) { return std::abs(unit.dot(p - points_[a])); });
        const double height = unit.dot(points_[d] - points_[a]);
        if (!(std::abs(height) > tolerance_)) return false;
        std::uint32_t second = b, third = c;
        if (height > 0) std::swap(second, third);
        add_face({a, second, third});
        add_face({a, d, second});
        add_face({second, d, third});
        add_face({third, d, a});
        return true;
    }
    void grow_by(std::uint32_t p) {
        const auto sees = [&](const Face& face) {
            return face.normal.dot(points_[p]) - face.offset > tolerance_;
        };
        if (std::ranges::none_of(faces_, sees)) return;
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (const Face& face : faces_)
            for (std::size_t k = 0; k < 3 && sees(face); ++k)
                edges.emplace(face.corners[k], face.corners[(k + 1) % 3]);
        std::erase_if(faces_, sees);
        for (const auto& [from, to] : edges)
            if (!edges.contains({to, from})) add_face({from, to, p});
    }
    [[nodiscard]] std::size_t points() const { return points_.size(); }
    [[nodiscard]] HullMesh mesh(std::span<const Vec3> points) const {
        HullMesh made;
        std::vector<std::uint32_t> number(points.size(), 0);
        for (const Face& face : faces_) {
            Corners corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                std::uint32_t& of_point = number[face.corners[k]];
                if (of_point == 0) {
                    made.vertices.push_back(points[face.corners[k]]);
                    of_point = static_cast<std::uint32_t>(made.vertices.size());
                }
                corners[k] = of_point - 1;
            }
            made.triangles.push_back(corners);
        }
        return made;
    }

  private:
    struct Face {
        Corners corners;
        Vector3d normal;  // of unit length, outward
        double offset;
    };
    void add_face(const Corners& c) {
        const Vector3d n =
            (points_[c[1]] - points_[c[0]]).cross(points_[c[2]] - points_[c[0]]).stableNormalized();
        faces_.push_back({c, n, n.dot(points_[c[0]])});
    }

    double tolerance_;
    std::vector<Vector3d> points_;
    std::vector<Face> faces_;
};

}  // namespace

Result<HullMesh> hull_of(std::span<const Vec3> points) {
    if (points.size() < 4 || points.size() > most_points)
        return Error{ErrorCode::invalid_argument, "ConvexHull::points has " + std::to_string(points.size()) +
                                                      "; it must have from 4 to 2^16"};
    Eigen::AlignedBox3f box;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (!is_finite(points[p]) || !(to_vector(points[p]).cwiseAbs().maxCoeff() <= farthest_collider))
            return out_of_range("ConvexHull::points[" + std::to_string(p) + "]", points[p],
                                "from -1e5 to 1e5 m on each axis");
        box.extend(to_vector(points[p]));
    }
    const double extent = static_cast<double>(box.sizes().maxCoeff());
    Hull hull(points, 1e-6 + 1e-6 * extent);
    if (!hull.begin())
        return Error{ErrorCode::invalid_argument,
                     "ConvexHull::points lie in a plane, all but; a hull needs points on both sides of any"};
    for (std::uint32_t p = 0; p < hull.points(); ++p) hull.grow_by(p);
    return hull.mesh(points);
}

}  // namespace weft
