#include "demo/character/garment/wear.h"

#include "demo/character/garment/garment_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace weft::demo {
namespace {

constexpr int excused = 5;  // steps after a squeeze
constexpr int parts = 4;    // of a triangle's sides, between sample points
constexpr int long_ago = -1000;

/// Penetration depth of a point [m], and whether two parts of the body press it from opposite sides.
struct Depth {
    float depth = 0;
    bool squeezed = false;
};

/// Samples how deep a triangle is inside the capsules that are near.
class TriangleDepth {
  public:
    TriangleDepth(const std::vector<TaperedCapsule>& body, const std::array<Vector3, 3>& corners, float kept)
        : corners_(corners), kept_(kept) {
        const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        float radius = 0;
        for (const Vector3& corner : corners) radius = std::max(radius, (corner - middle).norm());
        for (const TaperedCapsule& capsule : body) {
            if (distance_to(capsule, middle).distance < radius + 2 * kept) near_.push_back(&capsule);
        }
    }
    [[nodiscard]] Depth deepest() const {
        Depth found;
        if (near_.empty()) return found;
        for (int i = 0; i <= parts; ++i) {
            for (int j = 0; i + j <= parts; ++j) {
                const float u = static_cast<float>(i) / parts, v = static_cast<float>(j) / parts;
                const Depth at =
                    at_point(corners_[0] + u * (corners_[1] - corners_[0]) + v * (corners_[2] - corners_[0]));
                found.depth = std::max(found.depth, at.depth);
                found.squeezed |= at.squeezed;
            }
        }
        return found;
    }

  private:
    [[nodiscard]] Depth at_point(const Vector3& point) const {
        Depth found;
        for (std::size_t i = 0; i < near_.size(); ++i) {
            const SurfaceDistance first = distance_to(*near_[i], point);
            found.depth = std::max(found.depth, -first.distance);
            for (std::size_t j = 0; j < i && first.distance < 2 * kept_; ++j) {
                const SurfaceDistance second = distance_to(*near_[j], point);
                found.squeezed |= second.distance < 2 * kept_ && first.normal.dot(second.normal) < 0;
            }
        }
        return found;
    }

    std::array<Vector3, 3> corners_;
    float kept_;
    std::vector<const TaperedCapsule*> near_;
};

}  // namespace

WearMeter::WearMeter(const Mesh& mesh, float kept)
    : mesh_(mesh), kept_(kept), squeezed_at_(mesh.triangles.size(), long_ago) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, float> edges;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto edge = std::minmax(t[c], t[(c + 1) % 3]);
            edges[edge] = rest_length(mesh, edge.first, edge.second);
        }
    }
    for (const auto& [edge, rest] : edges) edges_.push_back({edge.first, edge.second, rest});
}

WearMeter::Wear WearMeter::measure(const ClothView& cloth, const std::vector<TaperedCapsule>& body) {
    Wear wear;
    const auto particle = [&](std::uint32_t vertex) {
        return cloth.positions[cloth.vertex_to_particle[vertex]];
    };
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh_.triangles[t];
        if (particle(a).w == 0 && particle(b).w == 0 && particle(c).w == 0) continue;
        const Depth found =
            TriangleDepth(body, {xyz(particle(a)), xyz(particle(b)), xyz(particle(c))}, kept_).deepest();
        wear.deepest = std::max(wear.deepest, found.depth);
        wear.squeezed += found.squeezed;
        if (found.squeezed) squeezed_at_[t] = step_;
        if (found.depth <= kept_ || step_ - squeezed_at_[t] <= excused) continue;
        ++wear.inside;
        wear.deepest_of_these = std::max(wear.deepest_of_these, found.depth);
    }
    ratios_.clear();
    for (const auto& [a, b, rest] : edges_) {
        if (particle(a).w == 0 && particle(b).w == 0) continue;
        ratios_.push_back((xyz(particle(a)) - xyz(particle(b))).norm() / rest);
    }
    if (!ratios_.empty()) {
        wear.stretch = std::ranges::max(ratios_);
        const auto at =
            ratios_.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(ratios_.size() - 1));
        std::ranges::nth_element(ratios_, at);
        wear.stretch_99 = *at;
    }
    ++step_;
    return wear;
}

}  // namespace weft::demo
