#include "cloth/surface/nearest_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/colliders/nearest_on_triangle.h"

namespace weft {
namespace {

using CellIndex = Eigen::Matrix<std::int64_t, 3, 1>;

constexpr std::int64_t half_range = 1 << 20;  // cells along an axis, to each side of the origin
constexpr float most_cells = 64;              // along the longest side of a triangle

CellIndex cell_of(const Vector3& point, float cell) {
    const auto clamped = [&](float x) {
        const float bound = static_cast<float>(half_range - 1);
        return static_cast<std::int64_t>(std::floor(std::clamp(x / cell, -bound, bound)));
    };
    return {clamped(point.x()), clamped(point.y()), clamped(point.z())};
}

std::uint64_t key_of(const CellIndex& at) {
    const auto part = [](std::int64_t i) {
        return static_cast<std::uint64_t>(i + half_range) & (2 * half_range - 1);
    };
    return part(at.x()) << 42 | part(at.y()) << 21 | part(at.z());
}

/// f(cell) for all whose greatest distance from `middle` along an axis is `ring` cells.
template <class F>
void for_ring(const CellIndex& middle, std::int64_t ring, const F& f) {
    for (std::int64_t x = -ring; x <= ring; ++x) {
        for (std::int64_t y = -ring; y <= ring; ++y) {
            const bool whole = std::abs(x) == ring || std::abs(y) == ring;
            const std::int64_t step = whole || ring == 0 ? 1 : 2 * ring;
            for (std::int64_t z = -ring; z <= ring; z += step) f(CellIndex(middle + CellIndex(x, y, z)));
        }
    }
}

}  // namespace

NearestTriangle::NearestTriangle(const ClothView& cloth) : cloth_(cloth) {
    const auto corner = [&](const Triangle& t, std::size_t c) { return xyz(cloth.positions[t[c]]); };
    double sum = 0;
    float longest = 0;
    for (const Triangle& t : cloth.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float length = (corner(t, c) - corner(t, (c + 1) % 3)).norm();
            sum += static_cast<double>(length);
            longest = std::max(longest, length);
        }
    }
    const auto mean =
        static_cast<float>(sum / std::max(1.0, 3.0 * static_cast<double>(cloth.triangles.size())));
    cell_ = std::max({mean, longest / most_cells, 1e-4f});
    for (std::uint32_t t = 0; t < cloth.triangles.size(); ++t) {
        const Triangle& triangle = cloth.triangles[t];
        const Vector3 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
        const CellIndex low = cell_of(a.cwiseMin(b).cwiseMin(c), cell_),
                        high = cell_of(a.cwiseMax(b).cwiseMax(c), cell_);
        for (std::int64_t x = low.x(); x <= high.x(); ++x) {
            for (std::int64_t y = low.y(); y <= high.y(); ++y) {
                for (std::int64_t z = low.z(); z <= high.z(); ++z) entries_.push_back({key_of({x, y, z}), t});
            }
        }
    }
    std::ranges::sort(entries_);
}

void NearestTriangle::look(std::uint64_t cell, const Vector3& point, const Vector3& normal,
                           std::optional<Found>& facing, std::optional<Found>& any) const {
    for (auto entry = std::ranges::lower_bound(entries_, Entry{cell, 0});
         entry != entries_.end() && entry->cell == cell; ++entry) {
        const Triangle& t = cloth_.triangles[entry->triangle];
        const Vector3 a = xyz(cloth_.positions[t[0]]), b = xyz(cloth_.positions[t[1]]),
                      c = xyz(cloth_.positions[t[2]]);
        const std::array<float, 3> weights = nearest_on_triangle(point, {a, b, c});
        const float second = weights[1], third = weights[2];
        const float distance = (a + second * (b - a) + third * (c - a) - point).norm();
        const Found found{entry->triangle, second, third, distance};
        const auto take = [&](std::optional<Found>& best) {
            const bool nearer = !best || distance < best->distance;
            if (nearer || (distance == best->distance && found.triangle < best->triangle)) best = found;
        };
        take(any);
        if ((b - a).cross(c - a).dot(normal) > 0) take(facing);
    }
}

std::optional<NearestTriangle::Found> NearestTriangle::to(const Vector3& point, const Vector3& normal,
                                                          float reach) const {
    std::optional<Found> facing, any;
    const CellIndex middle = cell_of(point, cell_);
    const auto rings = static_cast<std::int64_t>(std::ceil(reach / cell_));
    for (std::int64_t ring = 0; ring <= rings; ++ring) {
        for_ring(middle, ring, [&](const CellIndex& at) { look(key_of(at), point, normal, facing, any); });
        // What is not in these rings is further than they reach.
        if (facing && facing->distance <= static_cast<float>(ring) * cell_) break;
    }
    const std::optional<Found>& found = facing && facing->distance <= reach ? facing : any;
    if (!found || found->distance > reach) return std::nullopt;
    return found;
}

}  // namespace weft
