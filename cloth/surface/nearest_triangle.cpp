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

Eigen::Vector4f padded(const Vector3& v) {
    return {v.x(), v.y(), v.z(), 0};
}

/// The greatest scalar product of `direction` and a point of the box.
float most_along(const Eigen::Vector4f& direction, const Eigen::AlignedBox4f& box) {
    return direction.cwiseProduct(box.min()).cwiseMax(direction.cwiseProduct(box.max())).sum();
}

/// The squared distance of a point from a box, without branches: they would be mispredicted.
float squared_distance(const Eigen::Vector4f& point, const Eigen::AlignedBox4f& box) {
    return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(Eigen::Vector4f::Zero()).squaredNorm();
}

float squared(float x) {
    return x * x;
}

}  // namespace

NearestTriangle::NearestTriangle(const ClothView& cloth) {
    if (cloth.triangles.empty()) return;
    for (const std::uint32_t t : build(cloth)) {
        const auto x = corners_of(cloth, t);
        faces_.push_back({{}, x, area_normal(x), t});
        for (const Vector3& corner : x) faces_.back().box.extend(padded(corner));
    }
    fit();
}

// Halves each node at the median along the longest side of the box of its triangles' centroids. Equal
// centroids are ordered by number, so that depth is at most log n for any mesh. Returns the triangles by
// leaves.
std::vector<std::uint32_t> NearestTriangle::build(const ClothView& cloth) {
    std::vector<std::uint32_t> order(cloth.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<Vector3> centroids(order.size());
    for (const std::uint32_t t : order) {
        const auto x = corners_of(cloth, t);
        centroids[t] = (x[0] + x[1] + x[2]) / 3;
    }
    nodes_.assign(1, {{}, {}, 0, static_cast<std::uint32_t>(order.size()), 0});
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
        const auto parent = static_cast<std::uint32_t>(n);
        nodes_.push_back({{}, {}, first, count / 2, parent});
        nodes_.push_back({{}, {}, first + count / 2, count - count / 2, parent});
    }
    return order;
}

// Children come after their parents in the list, so boxes are fitted from its end.
void NearestTriangle::fit() {
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        Node& node = nodes_[n];
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
            node.box.extend(faces_[k].box);
            node.normals.extend(padded(faces_[k].area_normal.stableNormalized()));
        }
        if (node.count > 0) continue;
        for (const std::uint32_t child : {node.first, node.first + 1}) {
            node.box.extend(nodes_[child].box);
            node.normals.extend(nodes_[child].normals);
        }
    }
    const Box& all = nodes_[0].box;
    rounding_ = 2e-6f * all.min().cwiseAbs().cwiseMax(all.max().cwiseAbs()).maxCoeff();
}

std::optional<NearestTriangle::Found> NearestTriangle::search(const Vector3& point, const Vector3* normal,
                                                              float reach, std::uint32_t nearby) const {
    std::optional<Found> best;
    const Eigen::Vector4f at = padded(point), facing = padded(normal != nullptr ? *normal : point);
    float bound = squared(reach + rounding_);  // of squared distances from boxes
    const auto look_at = [&](const Face& face, std::uint32_t leaf) {
        if (!(squared_distance(at, face.box) <= bound)) return;
        if (normal != nullptr && !(face.area_normal.dot(*normal) > 0)) return;
        const auto& x = face.corners;
        const std::array<float, 3> weights = nearest_on_triangle(point, x);
        const float second = weights[1], third = weights[2];
        const Vector3 nearest = x[0] + second * (x[1] - x[0]) + third * (x[2] - x[0]);
        const Found found{face.triangle, second, third, (nearest - point).norm(), leaf};
        if (!(found.distance <= reach)) return;
        const bool equal = best && found.distance == best->distance;
        if (best && !(found.distance < best->distance) && !(equal && face.triangle < best->triangle)) return;
        best = found;
        bound = squared(found.distance * (1 + 1e-5f) + rounding_);
    };
    const float least_facing = normal != nullptr ? -1e-5f * normal->lpNorm<1>() : 0;
    const auto may_face = [&](const Node& node) {
        return normal == nullptr || most_along(facing, node.normals) > least_facing;
    };
    struct Open {
        std::uint32_t node;
        float distance;  // squared, of its box from the point
    };
    std::array<Open, 64> open;
    std::size_t count = 0;
    const auto add = [&](std::uint32_t n) {
        const float distance = squared_distance(at, nodes_[n].box);
        if (distance <= bound && may_face(nodes_[n])) open[count++] = {n, distance};
    };
    const auto visit_open = [&] {
        while (count > 0) {
            const auto [n, distance] = open[--count];
            if (!(distance <= bound)) continue;
            const Node& node = nodes_[n];
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k) look_at(faces_[k], n);
            if (node.count > 0) continue;
            const std::size_t before = count;
            add(node.first);
            add(node.first + 1);
            if (count == before + 2 && open[before].distance < open[before + 1].distance)
                std::swap(open[before], open[before + 1]);  // the nearer one is visited first
        }
    };
    if (nodes_.empty()) return best;
    add(nearby);
    visit_open();
    for (std::uint32_t n = nearby; n != 0; n = nodes_[n].parent) {
        add(n % 2 == 1 ? n + 1 : n - 1);  // its sibling
        visit_open();
    }
    return best;
}

std::optional<NearestTriangle::Found> NearestTriangle::to(const Vector3& point, const Vector3& normal,
                                                          float reach, std::uint32_t nearby) const {
    if (!normal.isZero(0))
        if (const auto facing = search(point, &normal, reach, nearby)) return facing;
    return search(point, nullptr, reach, nearby);
}

}  // namespace weft
