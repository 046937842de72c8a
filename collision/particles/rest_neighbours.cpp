#include "collision/particles/rest_neighbours.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/error_text.h"

namespace weft {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

/// Finds the particles near a given one. Its memory is kept from search to search.
class Search {
  public:
    Search(const RestGraph& graph, double limit)
        : graph_(graph), limit_(limit), ways_(graph.offsets.size() - 1, unreached) {}

    /// The particles joined to `from`, or within the limit of it, ascending; `from` is among them.
    const std::vector<std::uint32_t>& near(std::uint32_t from) {
        near_.clear();
        reach(from, 0);
        while (!front_.empty()) {
            std::ranges::pop_heap(front_, std::greater<>{});
            const auto [way, particle] = front_.back();
            front_.pop_back();
            if (way > ways_[particle]) continue;  // a shorter path was found since
            for (std::uint32_t k = graph_.offsets[particle]; k < graph_.offsets[particle + 1]; ++k) {
                const double longer = way + static_cast<double>(graph_.lengths[k]);
                if (longer < limit_) reach(graph_.neighbours[k], longer);
            }
        }
        for (const std::uint32_t particle : near_) ways_[particle] = unreached;
        const auto joined =
            graph_.neighbours.subspan(graph_.offsets[from], graph_.offsets[from + 1] - graph_.offsets[from]);
        near_.insert(near_.end(), joined.begin(), joined.end());
        std::ranges::sort(near_);
        near_.erase(std::ranges::unique(near_).begin(), near_.end());
        return near_;
    }

  private:
    void reach(std::uint32_t particle, double way) {
        if (!(way < ways_[particle])) return;
        if (ways_[particle] == unreached) near_.push_back(particle);
        ways_[particle] = way;
        front_.emplace_back(way, particle);
        std::ranges::push_heap(front_, std::greater<>{});
    }

    const RestGraph& graph_;
    double limit_;
    std::vector<double> ways_;                             // length of the path to each particle
    std::vector<std::pair<double, std::uint32_t>> front_;  // a heap, the nearest first
    std::vector<std::uint32_t> near_;
};

Error too_far(float distance) {
    return out_of_range("SelfCollision::distance", static_cast<double>(distance),
                        "so small that a particle has at most " +
                            std::to_string(RestNeighbours::most_per_particle) +
                            " others within it along the cloth on average: some seven edges of the mesh [m]");
}

}  // namespace

Result<RestNeighbours> RestNeighbours::find(const RestGraph& graph, float distance) {
    RestNeighbours result;
    result.distance_ = distance;
    if (graph.offsets.empty()) return result;
    const auto particles = static_cast<std::uint32_t>(graph.offsets.size() - 1);
    Search search(graph, detour * static_cast<double>(distance));

    // Sums of lengths differ in rounding from one end of a path to the other: the end with the lower number
    // decides for both, so that each is in the other's list or neither is.
    std::vector<std::uint32_t> higher, ends(particles), counts(particles, 0);
    for (std::uint32_t i = 0; i < particles; ++i) {
        for (const std::uint32_t j : search.near(i)) {
            if (j <= i) continue;
            higher.push_back(j);
            ++counts[i];
            ++counts[j];
        }
        ends[i] = static_cast<std::uint32_t>(higher.size());
        if (2 * higher.size() > most_per_particle * std::size_t{particles}) return too_far(distance);
    }

    result.offsets_ = SharedBuffer<std::uint32_t>(std::size_t{particles} + 1);
    for (std::uint32_t i = 0; i < particles; ++i) result.offsets_[i + 1] = result.offsets_[i] + counts[i];
    result.neighbours_ = SharedBuffer<std::uint32_t>(result.offsets_[particles]);
    // Pairs in order of their lower ends: each list then has its lower neighbours before its higher ones.
    std::vector<std::uint32_t> next(result.offsets_.data(), result.offsets_.data() + particles);
    for (std::uint32_t i = 0, k = 0; i < particles; ++i) {
        for (; k < ends[i]; ++k) {
            result.neighbours_[next[i]++] = higher[k];
            result.neighbours_[next[higher[k]]++] = i;
        }
    }
    return result;
}

}  // namespace weft
