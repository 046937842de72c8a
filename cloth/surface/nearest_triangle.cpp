#include "cloth/surface/nearest_triangle.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "collision/geometry/nearest_on_triangle.h"

namespace weft {
namespace {

constexpr std::uint32_t most_in_leaf = 4;

std::array<Vector3, 3> corners_of(const ClothView& cloth, std::uint32_t triangle) {
    const Triangle& t = cloth.triangles[triangle];
    return {xyz(cloth.positions[t[0]]), xyz(cloth.positions[t[1]]), xyz(cloth.positions[t[2]])};
}

Vector3 area_normal(const std::array<Vector3, 3>& x) {
    return (x[1] - x[0]).cross(x[2] - x[0]);
}

/// The greatest scalar product of `direction` and a point of the box.
float most_along(const Vector3& direction, const Eigen::AlignedBox3f& box) {
    return direction.cwiseProduct(box.min()).cwiseMax(direction.cwiseProduct(box.max())).sum();
}

}  // namespace

NearestTriangle::NearestTriangle(const ClothView& cloth) : cloth_(cloth) {
    if (cloth.triangles.empty()) return;
    std::vector<std::uint32_t> order(cloth.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    build(std::move(order));
    fit();
}

// Halves each node at the median along the longest side of the box of its triangles' centroids. Equal
// centroids are ordered by number, so that depth is at most log n for any mesh.
void NearestTriangle::build(std::vector<std::uint32_t> order) {
    std::vector<Vector3> centroids(order.size());
    for (const std::uint32_t t : order) {
        const auto x = corners_of(cloth_, t);
        centroids[t] = (x[0] + x[1] + x[2]) / 3;
    }
    nodes_.assign(1, {{}, {}, 0, static_cast<std::uint32_t>(order.size())});
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const std::uint32_t first = nodes_[n].first, count = nodes_[n].count;
        if (count <= most_in_leaf) continue;
        Eigen::AlignedBox3f middles;
        for (std::uint32_t k = first; k < first + count; ++k) middles.extend(centroids[order[k]]);
        int axis = 0;
        middles.sizes().maxCoeff(&axis);
        const auto begin = order.begin() + first;
        std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
            const float at_a = centroids[a][axis], at_b = centroids[b][axis];
            return at_a != at_b ? at_a < at_b : a < b;
        });
        nodes_[n].first = static_cast<std::uint32_t>(nodes_.size());
        nodes_[n].count = 0;
        nodes_.push_back({{}, {}, first, count / 2});
        nodes_.push_back({{}, {}, first + count / 2, count - count / 2});
    }
    order_ = std::move(order);
}

// Children come after their parents in the list, so boxes are fitted from its end.
void NearestTriangle::fit() {
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        Node& node = nodes_[n];
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
            const auto x = corners_of(cloth_, order_[k]);
            for (const Vector3& corner : x) node.box.extend(corner);
            node.normals.extend(area_normal(x).stableNormalized());
        }
        if (node.count > 0) continue;
        for (const std::uint32_t child : {node.first, node.first + 1}) {
            node.box.extend(nodes_[child].box);
            node.normals.extend(nodes_[child].normals);
        }
    }
    const Eigen::AlignedBox3f& all = nodes_[0].box;
    rounding_ = 2e-6f * all.min().cwiseAbs().cwiseMax(all.max().cwiseAbs()).maxCoeff();
}

std::optional<NearestTriangle::Found> NearestTriangle::search(const Vector3& point, const Vector3* normal,
                                                              float reach) const {
    std::optional<Found> best;
    float bound = reach + rounding_;
    const auto look_at = [&](std::uint32_t triangle) {
        const auto x = corners_of(cloth_, triangle);
        if (normal != nullptr && !(area_normal(x).dot(*normal) > 0)) return;
        const std::array<float, 3> weights = nearest_on_triangle(point, x);
        const float second = weights[1], third = weights[2];
        const Vector3 nearest = x[0] + second * (x[1] - x[0]) + third * (x[2] - x[0]);
        const Found found{triangle, second, third, (nearest - point).norm()};
        if (!(found.distance <= reach)) return;
        const bool equal = best && found.distance == best->distance;
        if (best && !(found.distance < best->distance) && !(equal && triangle < best->triangle)) return;
        best = found;
        bound = found.distance * (1 + 1e-5f) + rounding_;
    };
    const float least_facing = normal != nullptr ? -1e-5f * normal->lpNorm<1>() : 0;
    const auto may_face = [&](const Node& node) {
        return normal == nullptr || most_along(*normal, node.normals) > least_facing;
    };
    std::array<std::pair<std::uint32_t, float>, 64> open;  // nodes, and their distances from the point
    std::size_t count = 0;
    const auto add = [&](std::uint32_t n) {
        const float distance = nodes_[n].box.exteriorDistance(point);
        if (distance <= bound && may_face(nodes_[n])) open[count++] = {n, distance};
    };
    if (!nodes_.empty()) add(0);
    while (count > 0) {
        const auto [n, distance] = open[--count];
        if (!(distance <= bound)) continue;
        const Node& node = nodes_[n];
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) look_at(order_[k]);
        if (node.count > 0) continue;
        const std::size_t before = count;
        add(node.first);
        add(node.first + 1);
        if (count == before + 2 && open[before].second < open[before + 1].second)
            std::swap(open[before], open[before + 1]);  // the nearer one is visited first
    }
    return best;
}

std::optional<NearestTriangle::Found> NearestTriangle::to(const Vector3& point, const Vector3& normal,
                                                          float reach) const {
    if (!normal.isZero(0))
        if (const auto facing = search(point, &normal, reach)) return facing;
    return search(point, nullptr, reach);
}

}  // namespace weft
