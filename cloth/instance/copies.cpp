#include "cloth/instance/copies.h"

#include <algorithm>

#include "cloth/mesh/topology/topology.h"

namespace weft {

std::optional<JoinsWithCopies> joins_with_copies(const ClothModel& model) {
    std::vector<Vec3> places;
    places.reserve(model.particle_count);
    for (const Vec4& p : model.positions) places.push_back({p.x, p.y, p.z});
    const std::vector<std::uint32_t> place_of = weld(places);
    const std::uint32_t places_taken = std::ranges::max(place_of) + 1;
    if (places_taken == model.particle_count) return std::nullopt;

    std::vector<std::vector<std::uint32_t>> at_place(places_taken);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) at_place[place_of[i]].push_back(i);
    JoinsWithCopies joins;
    joins.offsets.push_back(0);
    std::vector<std::pair<std::uint32_t, float>> row;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        row.clear();
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            row.emplace_back(model.neighbours[e], model.rest_lengths[e]);
        for (const std::uint32_t copy : at_place[place_of[i]])
            if (copy != i) row.emplace_back(copy, 0.0f);
        std::ranges::sort(row);
        for (const auto& [neighbour, length] : row) {
            joins.neighbours.push_back(neighbour);
            joins.lengths.push_back(length);
        }
        joins.offsets.push_back(static_cast<std::uint32_t>(joins.neighbours.size()));
    }
    return joins;
}

}  // namespace weft
