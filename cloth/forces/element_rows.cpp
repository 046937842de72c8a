#include "cloth/forces/element_rows.h"

#include <algorithm>
#include <array>

namespace weft {

ElementRows::ElementRows(const CookedCloth& model, std::span<const Hinge> hinges)
    : offsets(model.particle_count + 1) {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
        pairs.push_back({a, b});
        pairs.push_back({b, a});
    };
    for (const Triangle& t : model.triangles)
        for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3]);
    for (const Hinge& hinge : hinges) add(hinge.particles[2], hinge.particles[3]);
    std::ranges::sort(pairs);
    pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());

    neighbours.reserve(pairs.size());
    for (const auto& [particle, neighbour] : pairs) {
        ++offsets[particle + 1];
        neighbours.push_back(neighbour);
    }
    for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
}

std::size_t ElementRows::half_edge(std::uint32_t particle, std::uint32_t neighbour) const {
    const auto row =
        std::span(neighbours).subspan(offsets[particle], offsets[particle + 1] - offsets[particle]);
    return offsets[particle] +
           static_cast<std::size_t>(std::ranges::lower_bound(row, neighbour) - row.begin());
}

}  // namespace weft
