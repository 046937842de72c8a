// Cells along borders: a centre at each corner, and others evenly between them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "cloth/proxy/cells.h"

namespace weft {

namespace {

constexpr float cosine_of_corner = 0.6f;  // a border turns by 53 degrees or more

/// A border with the way from its first point to each [m].
class Loop {
  public:
    Loop(const PlainSurface& surface, std::span<const std::uint32_t> points)
        : surface_(surface), points_(points) {
        for (std::size_t k = 0; k < points.size(); ++k) {
            ways_.push_back(length_);
            length_ += (at(k + 1) - at(k)).norm();
        }
    }
    [[nodiscard]] std::size_t size() const { return points_.size(); }
    [[nodiscard]] float length() const { return length_; }
    [[nodiscard]] const Vector3& at(std::size_t k) const { return surface_.points[points_[k % size()]]; }
    /// The way along the border from one point to another.
    [[nodiscard]] float way(std::size_t from, std::size_t to) const {
        const float way = ways_[to % size()] - ways_[from % size()];
        return way < 0 ? way + length_ : way;
    }

    /// Corners, ascending: the sharpest within `edge` along the border.
    [[nodiscard]] std::vector<std::size_t> corners(float edge) const {
        std::vector<std::pair<float, std::size_t>> sharp;
        for (std::size_t k = 0; k < size(); ++k) {
            const float cosine = cosine_at(k, 0.5f * edge);
            if (cosine < cosine_of_corner) sharp.emplace_back(cosine, k);
        }
        std::ranges::sort(sharp);
        std::vector<std::size_t> corners;
        for (const auto& [cosine, k] : sharp)
            if (std::ranges::none_of(
                    corners, [&](std::size_t c) { return std::min(way(c, k), way(k, c)) < 0.7f * edge; }))
                corners.push_back(k);
        std::ranges::sort(corners);
        return corners;
    }

  private:
    /// The cosine of the border's turn at a point, from chords of at least this length.
    [[nodiscard]] float cosine_at(std::size_t k, float chord) const {
        std::size_t before = k + size() - 1, after = k + 1;
        while (before > k + 1 && (at(before) - at(k)).norm() < chord) --before;
        while (after < k + size() - 1 && (at(after) - at(k)).norm() < chord) ++after;
        return (at(k) - at(before)).normalized().dot((at(after) - at(k)).normalized());
    }

    const PlainSurface& surface_;
    std::span<const std::uint32_t> points_;
    std::vector<float> ways_;
    float length_ = 0;
};

/// The points of a border that become centres, in its order: corners, and points between them.
std::vector<std::size_t> centres_on(const Loop& loop, float edge) {
    std::vector<std::size_t> corners = loop.corners(edge);
    if (corners.empty()) corners.push_back(0);
    const int least = corners.size() == 1 ? 3 : corners.size() == 2 ? 2 : 1;
    std::vector<std::size_t> centres;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::size_t from = corners[c];
        const std::size_t to = c + 1 < corners.size() ? corners[c + 1] : corners[0] + loop.size();
        const float length = corners.size() == 1 ? loop.length() : loop.way(from, to);
        const int pieces = std::max(least, static_cast<int>(std::lround(length / edge)));
        std::size_t k = from;
        for (int piece = 0; piece < pieces; ++piece) {
            const float goal = length * static_cast<float>(piece) / static_cast<float>(pieces);
            while (k + 1 < to && loop.way(from, k + 1) <= goal) ++k;
            const bool is_next_nearer = k + 1 < to && loop.way(from, k + 1) - goal < goal - loop.way(from, k);
            centres.push_back((is_next_nearer ? k + 1 : k) % loop.size());
        }
    }
    centres.erase(std::ranges::unique(centres).begin(), centres.end());
    return centres;
}

}  // namespace

void add_borders(const PlainSurface& surface, float edge, SurfaceCells& cells) {
    for (const std::vector<std::uint32_t>& border : borders_of(surface)) {
        const Loop loop(surface, border);
        const std::vector<std::size_t> centres = centres_on(loop, edge);
        const auto first = static_cast<std::uint32_t>(cells.centres.size());
        for (const std::size_t k : centres) cells.centres.push_back(border[k]);
        for (std::size_t c = 0; c < centres.size(); ++c) {
            const std::size_t from = centres[c], to = centres[(c + 1) % centres.size()];
            for (std::size_t k = from; k % loop.size() != to; ++k) {
                const bool is_nearer_to_end = loop.way(k, to) < loop.way(from, k);
                std::uint32_t& cell = cells.of_point[border[k % loop.size()]];
                const std::size_t of = is_nearer_to_end ? (c + 1) % centres.size() : c;
                if (cell == no_cell || k == from) cell = first + static_cast<std::uint32_t>(of);
            }
        }
    }
}

}  // namespace weft
