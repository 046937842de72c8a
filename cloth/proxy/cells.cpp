#include "cloth/proxy/cells.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace weft {

namespace {

constexpr int rounds = 12;  // of moving centres; further ones change the longest edge by less than 2 %

/// The points that share an edge with each.
class Neighbours {
  public:
    explicit Neighbours(const PlainSurface& surface) : offsets_(surface.points.size() + 1) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (const auto& [a, b, c] : surface.triangles)
            pairs.insert(pairs.end(), {{a, b}, {b, a}, {b, c}, {c, b}, {c, a}, {a, c}});
        std::ranges::sort(pairs);
        pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
        for (const auto& [point, other] : pairs) {
            ++offsets_[point + 1];
            others_.push_back(other);
        }
        for (std::size_t p = 1; p < offsets_.size(); ++p) offsets_[p] += offsets_[p - 1];
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t point) const {
        return std::span(others_).subspan(offsets_[point], offsets_[point + 1] - offsets_[point]);
    }

  private:
    std::vector<std::uint32_t> offsets_, others_;
};

/// Cells that grow over a surface. Those of border points are given and stay.
class Growth {
  public:
    Growth(const PlainSurface& surface, SurfaceCells& cells)
        : surface_(surface),
          cells_(cells),
          neighbours_(surface),
          at_border_(cells.of_point),
          distances_(surface.points.size(), std::numeric_limits<float>::infinity()) {
        for (std::uint32_t p = 0; p < at_border_.size(); ++p)
            if (at_border_[p] != no_cell) open(p, at_border_[p]);
        grow();
    }

    /// Adds a centre at the point that is farthest from all, as often as wanted.
    void spread(std::size_t count) {
        std::priority_queue<std::pair<float, std::uint32_t>> farthest;  // the last of equals
        for (std::uint32_t p = 0; p < distances_.size(); ++p) farthest.emplace(distances_[p], p);
        while (count > 0 && farthest.top().first > 0) {
            const auto [distance, point] = farthest.top();
            farthest.pop();
            if (at_border_[point] != no_cell) continue;
            if (distances_[point] < distance) {
                farthest.emplace(distances_[point], point);
                continue;
            }
            cells_.centres.push_back(point);
            open(point, static_cast<std::uint32_t>(cells_.centres.size() - 1));
            grow();
            --count;
        }
    }

    /// Moves each centre that is not on a border to the middle of its cell, and grows the cells anew.
    void centre(std::size_t first_free) {
        std::vector<Vector3> sums(cells_.centres.size(), Vector3::Zero());
        std::vector<float> areas(cells_.centres.size());
        for (const Triangle& t : surface_.triangles) {
            const float area = area_of(surface_, t);
            for (const std::uint32_t p : t) {
                sums[cells_.of_point[p]] += area * surface_.points[p];
                areas[cells_.of_point[p]] += area;
            }
        }
        std::vector<float> least(cells_.centres.size(), std::numeric_limits<float>::infinity());
        for (std::uint32_t p = 0; p < distances_.size(); ++p) {
            const std::uint32_t cell = cells_.of_point[p];
            if (cell < first_free || at_border_[p] != no_cell) continue;
            const float distance = (surface_.points[p] - sums[cell] / areas[cell]).squaredNorm();
            if (!(distance < least[cell])) continue;
            least[cell] = distance;
            cells_.centres[cell] = p;
        }
        std::ranges::fill(distances_, std::numeric_limits<float>::infinity());
        for (std::uint32_t p = 0; p < at_border_.size(); ++p)
            if (at_border_[p] != no_cell) open(p, at_border_[p]);
        for (std::size_t c = first_free; c < cells_.centres.size(); ++c)
            open(cells_.centres[c], static_cast<std::uint32_t>(c));
        grow();
    }

  private:
    /// Gives a point to a cell if its centre is nearer than that of the point's own.
    void open(std::uint32_t point, std::uint32_t cell) {
        const float distance = (surface_.points[point] - surface_.points[cells_.centres[cell]]).norm();
        if (!(distance < distances_[point]) || (at_border_[point] != no_cell && at_border_[point] != cell))
            return;
        distances_[point] = distance;
        cells_.of_point[point] = cell;
        front_.emplace(distance, point, cell);
    }
    void grow() {
        while (!front_.empty()) {
            const auto [distance, point, cell] = front_.top();
            front_.pop();
            if (cells_.of_point[point] != cell || distances_[point] != distance) continue;
            for (const std::uint32_t other : neighbours_.of(point)) open(other, cell);
        }
    }

    const PlainSurface& surface_;
    SurfaceCells& cells_;
    const Neighbours neighbours_;
    const std::vector<std::uint32_t> at_border_;  // border points' cells
    std::vector<float> distances_;                // from the centre of each point's cell
    using Reached = std::tuple<float, std::uint32_t, std::uint32_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front_;  // nearest first
};

}  // namespace

SurfaceCells cut_into_cells(const PlainSurface& surface, float edge, std::uint32_t wanted) {
    SurfaceCells cells;
    cells.of_point.assign(surface.points.size(), no_cell);
    add_borders(surface, edge, cells);
    const std::size_t at_borders = cells.centres.size();
    Growth growth(surface, cells);
    growth.spread(wanted - std::min<std::size_t>(wanted, at_borders));
    for (int round = 0; round < rounds; ++round) growth.centre(at_borders);
    return cells;
}

PlainSurface triangles_between(const PlainSurface& surface, const SurfaceCells& cells) {
    PlainSurface made;
    for (const std::uint32_t centre : cells.centres) made.points.push_back(surface.points[centre]);
    std::set<std::pair<std::uint32_t, std::uint32_t>> ways;  // of edges, from corner to corner
    for (const Triangle& t : surface.triangles) {
        const std::uint32_t a = cells.of_point[t[0]], b = cells.of_point[t[1]], c = cells.of_point[t[2]];
        if (a == b || b == c || c == a) continue;
        const std::array<std::pair<std::uint32_t, std::uint32_t>, 3> sides{{{a, b}, {b, c}, {c, a}}};
        if (std::ranges::any_of(sides, [&](const auto& side) { return ways.contains(side); })) continue;
        ways.insert(sides.begin(), sides.end());
        made.triangles.push_back({a, b, c});
    }
    return kept_of(made, std::vector<bool>(made.triangles.size(), true));
}

}  // namespace weft
