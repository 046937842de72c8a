#include "demo/character/figure/surface_nets.h"

#include <algorithm>
#include <cmath>

namespace weft::demo {
namespace {

constexpr std::uint32_t no_vertex = ~0u;

/// Adds two triangles along the shorter diagonal of a quad.
void add_quad(const std::array<std::uint32_t, 4>& quad, bool turned, Mesh& mesh) {
    const auto at = [&](std::size_t k) { return to_vector(mesh.positions[quad[k]]); };
    const std::size_t first = (at(0) - at(2)).squaredNorm() <= (at(1) - at(3)).squaredNorm() ? 0 : 1;
    for (const std::size_t k : {first, first + 2}) {
        const std::uint32_t a = quad[k % 4], b = quad[(k + 1) % 4], c = quad[(k + 2) % 4];
        mesh.triangles.push_back(turned ? Triangle{a, c, b} : Triangle{a, b, c});
    }
}

}  // namespace

CornerGrid::CornerGrid(const Eigen::AlignedBox3f& box, float cell, float outside)
    : origin_(box.min() - Vector3::Constant(1.5f * cell)), cell_(cell) {
    for (int axis = 0; axis < 3; ++axis)
        corners_[static_cast<std::size_t>(axis)] =
            static_cast<std::size_t>(std::ceil(box.sizes()[axis] / cell)) + 4;
    values_.assign(corners_[0] * corners_[1] * corners_[2], outside);
}

std::array<std::size_t, 3> CornerGrid::corner_before(const Vector3& point) const {
    std::array<std::size_t, 3> found{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        const float cells = std::clamp((point[k] - origin_[k]) / cell_, 0.0f, 1e6f);
        found[axis] = std::min(static_cast<std::size_t>(cells), corners_[axis] - 1);
    }
    return found;
}

/// The mean over the edges of the cell above this corner.
Vector3 CornerGrid::middle_of_crossings(std::size_t x, std::size_t y, std::size_t z, int& crossings) const {
    Vector3 sum = Vector3::Zero();
    crossings = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if ((corner >> axis & 1) != 0) continue;
            const std::size_t other = corner | std::size_t{1} << axis;
            const auto value = [&](std::size_t c) {
                return values_[index(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))];
            };
            const float a = value(corner), b = value(other);
            if ((a < 0) == (b < 0)) continue;
            Vector3 p = place(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
            p[static_cast<Eigen::Index>(axis)] += cell_ * a / (a - b);
            sum += p;
            ++crossings;
        }
    return crossings > 0 ? Vector3(sum / static_cast<float>(crossings)) : sum;
}

Mesh CornerGrid::surface() const {
    Mesh mesh;
    std::vector<std::uint32_t> vertex(values_.size(), no_vertex);  // of the cell above each corner
    const std::array<std::size_t, 3> step{1, corners_[0], corners_[0] * corners_[1]};
    const auto for_cells = [&](const auto& f) {
        for (std::size_t z = 0; z + 1 < corners_[2]; ++z)
            for (std::size_t y = 0; y + 1 < corners_[1]; ++y)
                for (std::size_t x = 0; x + 1 < corners_[0]; ++x) f(x, y, z);
    };
    for_cells([&](std::size_t x, std::size_t y, std::size_t z) {
        int crossings = 0;
        const Vector3 place = middle_of_crossings(x, y, z, crossings);
        if (crossings == 0) return;
        vertex[index(x, y, z)] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(to_vec3(place));
    });
    for_cells([&](std::size_t x, std::size_t y, std::size_t z) {
        const std::size_t here = index(x, y, z);
        const std::array<std::size_t, 3> at{x, y, z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
            const bool is_inside = values_[here] < 0;
            if (at[second] == 0 || at[third] == 0 || is_inside == (values_[here + step[axis]] < 0)) continue;
            const std::array<std::uint32_t, 4> quad{vertex[here - step[second] - step[third]],
                                                    vertex[here - step[third]], vertex[here],
                                                    vertex[here - step[second]]};
            add_quad(quad, !is_inside, mesh);
        }
    });
    return mesh;
}

}  // namespace weft::demo
