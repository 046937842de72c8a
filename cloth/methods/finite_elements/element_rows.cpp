#include "cloth/methods/finite_elements/element_rows.h"

#include <algorithm>
#include <utility>

#include "cloth/mesh/rest/bending.h"

namespace weft {

ElementRows::ElementRows(std::uint32_t particles, std::vector<Pair> pairs) : offsets(particles + 1) {
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    neighbours.reserve(pairs.size());
    for (const auto& [particle, neighbour] : pairs) {
        ++offsets[particle + 1];
        neighbours.push_back(neighbour);
    }
    for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
}

ElementRows ElementRows::of_triangles(const ClothModel& model, std::span<const Hinge> hinges) {
    std::vector<Pair> pairs;
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
        pairs.push_back({a, b});
        pairs.push_back({b, a});
    };
    for (const Triangle& t : model.triangles)
        for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3]);
    for (const Hinge& hinge : hinges) add(hinge.particles[2], hinge.particles[3]);
    return {model.particle_count, std::move(pairs)};
}

ElementRows ElementRows::of_quadratic_bending(const ClothModel& model, const Bending& bending) {
    std::vector<Pair> pairs;
    for_each_quadratic_term(bending, [&](std::uint32_t i, std::uint32_t j, float) {
        pairs.push_back({i, j});
    });
    return {model.particle_count, std::move(pairs)};
}

std::size_t ElementRows::half_edge(std::uint32_t particle, std::uint32_t neighbour) const {
    const auto row =
        std::span(neighbours).subspan(offsets[particle], offsets[particle + 1] - offsets[particle]);
    return offsets[particle] +
           static_cast<std::size_t>(std::ranges::lower_bound(row, neighbour) - row.begin());
}

}  // namespace weft
