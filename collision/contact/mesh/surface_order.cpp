#include "collision/contact/mesh/surface_order.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "collision/search/patches.h"

namespace weft {

namespace {

constexpr double far_off = std::numeric_limits<double>::infinity();

/// Halves parts of a surface, each across its longest path, until patches are left.
class SurfaceCut {
  public:
    SurfaceCut(std::size_t particles, std::span<const std::array<std::uint32_t, 2>> edges,
               std::span<const Vec4> positions)
        : starts_(particles + 1), neighbours_(2 * edges.size()), place_(particles), part_of_(particles) {
        for (const auto& edge : edges)
            for (const std::uint32_t i : edge) ++starts_[i + 1];
        for (std::size_t i = 0; i < particles; ++i) starts_[i + 1] += starts_[i];
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (const auto& [a, b] : edges) {
            const double length = std::hypot(double{positions[a].x} - double{positions[b].x},
                                             double{positions[a].y} - double{positions[b].y},
                                             double{positions[a].z} - double{positions[b].z});
            neighbours_[next[a]++] = {b, length};
            neighbours_[next[b]++] = {a, length};
        }
    }

    /// As in patches.cpp, the first half is whole blocks or, in a smaller part, whole patches.
    void cut(std::span<std::uint32_t> part) {
        if (part.size() <= patch_size) return;
        const std::size_t whole = part.size() > block_size ? block_size : patch_size;
        const std::size_t half = (part.size() / 2 + whole - 1) / whole * whole;
        find_places(part);
        std::ranges::nth_element(part, part.begin() + static_cast<std::ptrdiff_t>(half),
                                 [&](std::uint32_t i, std::uint32_t j) {
                                     return std::pair(place_[i], i) < std::pair(place_[j], j);
                                 });
        cut(part.first(half));
        cut(part.subspan(half));
    }

  private:
    struct Neighbour {
        std::uint32_t vertex;
        double length;
    };
    /// The connected piece of a vertex, and its place on the way from one end of the piece to the other.
    struct Place {
        std::uint32_t piece;
        double along;
        auto operator<=>(const Place&) const = default;
    };

    void find_places(std::span<const std::uint32_t> part) {
        ++part_;
        for (const std::uint32_t i : part) {
            part_of_[i] = part_;
            place_[i].piece = none;
        }
        std::uint32_t piece = 0;
        for (const std::uint32_t i : part) {
            if (place_[i].piece != none) continue;
            const std::uint32_t one_end = walk(i, [](std::uint32_t, double) {});
            const std::uint32_t other_end = walk(one_end, [&](std::uint32_t j, double way) {
                place_[j] = {piece, way};
            });
            walk(other_end, [&](std::uint32_t j, double way) { place_[j].along -= way; });
            ++piece;
        }
    }

    /// Calls visit(vertex, length of the path along edges within the part) for all vertices connected to
    /// `from`, the nearest first (Dijkstra 1959). Returns the last.
    template <class Visit>
    std::uint32_t walk(std::uint32_t from, const Visit& visit) {
        using Front = std::pair<double, std::uint32_t>;
        std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
        way_.resize(part_of_.size(), far_off);
        std::vector<std::uint32_t> reached;
        std::uint32_t last = from;
        const auto reach = [&](std::uint32_t i, double way) {
            if (way_[i] == far_off) reached.push_back(i);
            way_[i] = way;
            front.emplace(way, i);
        };
        reach(from, 0);
        while (!front.empty()) {
            const auto [way, i] = front.top();
            front.pop();
            if (way > way_[i]) continue;
            visit(i, way);
            last = i;
            for (std::uint32_t k = starts_[i]; k < starts_[i + 1]; ++k) {
                const auto& [j, length] = neighbours_[k];
                if (part_of_[j] == part_ && way + length < way_[j]) reach(j, way + length);
            }
        }
        for (const std::uint32_t i : reached) way_[i] = far_off;
        return last;
    }

    static constexpr std::uint32_t none = ~0u;

    std::vector<std::uint32_t> starts_;  // by particle, into neighbours_
    std::vector<Neighbour> neighbours_;
    std::vector<Place> place_;
    std::vector<std::uint32_t> part_of_;
    std::vector<double> way_;
    std::uint32_t part_ = 0;
};

}  // namespace

void order_along_surface(std::span<std::uint32_t> vertices,
                         std::span<const std::array<std::uint32_t, 2>> edges,
                         std::span<const Vec4> rest_positions) {
    SurfaceCut(rest_positions.size(), edges, rest_positions).cut(vertices);
    // The vertices of a patch ascend, as they lie in memory.
    for (std::size_t at = 0; at < vertices.size(); at += patch_size)
        std::ranges::sort(vertices.subspan(at, std::min<std::size_t>(patch_size, vertices.size() - at)));
}

}  // namespace weft
