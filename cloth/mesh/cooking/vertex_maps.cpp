#include "cloth/mesh/cooking/vertex_maps.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/error_text.h"

namespace weft {

namespace {

Result<void> check(const VertexMap& map, std::size_t vertices) {
    if (map.values.size() != vertices)
        return Error{ErrorCode::invalid_argument,
                     std::string(map.name) + " has " + std::to_string(map.values.size()) +
                         " values; it must have one per vertex (" + std::to_string(vertices) + ") or none"};
    const auto text = [](float value) { return number_text(static_cast<double>(value)); };
    for (std::size_t i = 0; i < vertices; ++i) {
        const float value = map.values[i];
        if (!(value >= map.least && value <= map.greatest))  // not-a-number, too
            return out_of_range(std::string(map.name) + "[" + std::to_string(i) + "]",
                                static_cast<double>(value),
                                "from " + text(map.least) + " to " + text(map.greatest));
        if (map.where_welded == WhereWelded::any_bit && value != std::floor(value))
            return out_of_range(std::string(map.name) + "[" + std::to_string(i) + "]",
                                static_cast<double>(value), "a whole number");
    }
    return {};
}

void store_means(const VertexMap& map, std::span<const std::uint32_t> vertex_to_particle,
                 std::span<float> result) {
    std::vector<double> sums(result.size(), 0.0);
    std::vector<std::uint32_t> counts(result.size(), 0);
    for (std::size_t i = 0; i < vertex_to_particle.size(); ++i) {
        sums[vertex_to_particle[i]] += static_cast<double>(map.values[i]);
        ++counts[vertex_to_particle[i]];
    }
    for (std::size_t p = 0; p < result.size(); ++p) result[p] = static_cast<float>(sums[p] / counts[p]);
}

void join_bits(const VertexMap& map, std::span<const std::uint32_t> vertex_to_particle,
               std::span<float> result) {
    const auto bits = [](float value) { return static_cast<std::uint32_t>(value); };
    std::ranges::fill(result, 0.0f);
    for (std::size_t i = 0; i < vertex_to_particle.size(); ++i) {
        float& of_particle = result[vertex_to_particle[i]];
        of_particle = static_cast<float>(bits(of_particle) | bits(map.values[i]));
    }
}

}  // namespace

Result<AlignedBuffer<float>> remap_to_particles(const VertexMap& map,
                                                std::span<const std::uint32_t> vertex_to_particle,
                                                std::uint32_t particles) {
    AlignedBuffer<float> result(particles);
    if (map.values.empty()) {
        std::ranges::fill(result.span(), map.otherwise);
        return result;
    }
    if (Result<void> good = check(map, vertex_to_particle.size()); !good) return good.error();
    if (map.where_welded == WhereWelded::mean) {
        store_means(map, vertex_to_particle, result.span());
        return result;
    }
    if (map.where_welded == WhereWelded::any_bit) {
        join_bits(map, vertex_to_particle, result.span());
        return result;
    }
    const bool least = map.where_welded == WhereWelded::least;
    std::ranges::fill(result.span(), least ? map.greatest : map.least);
    for (std::size_t i = 0; i < vertex_to_particle.size(); ++i) {
        float& of_particle = result[vertex_to_particle[i]];
        of_particle = least ? std::min(of_particle, map.values[i]) : std::max(of_particle, map.values[i]);
    }
    return result;
}

}  // namespace weft
