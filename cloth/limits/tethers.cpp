#include "cloth/limits/tethers.h"

#include <algorithm>
#include <array>

#include "engine/vector.h"

namespace weft {

namespace {

/// Pins and their holds: those that structural springs join are one. Precondition: pins ascend.
std::vector<GeodesicSource> group_pins(const ClothModel& model, std::span<const std::uint32_t> pins) {
    std::vector<GeodesicSource> sources;
    for (const std::uint32_t pin : pins) sources.push_back({pin, GeodesicReach::none});
    std::vector<std::size_t> reached;
    for (std::size_t first = 0; first < sources.size(); ++first) {
        if (sources[first].group != GeodesicReach::none) continue;
        const auto group = static_cast<std::uint32_t>(first);
        sources[first].group = group;
        reached.assign({first});
        while (!reached.empty()) {
            const std::uint32_t i = sources[reached.back()].particle;
            reached.pop_back();
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                if (model.kinds[e] != SpringKind::structural) continue;
                const auto at =
                    std::ranges::lower_bound(sources, model.neighbours[e], {}, &GeodesicSource::particle);
                if (at == sources.end() || at->particle != model.neighbours[e] || at->group == group)
                    continue;
                at->group = group;
                reached.push_back(static_cast<std::size_t>(at - sources.begin()));
            }
        }
    }
    return sources;
}

std::size_t count_groups(std::span<const GeodesicSource> sources) {
    std::vector<std::uint32_t> groups;
    for (const GeodesicSource& source : sources) groups.push_back(source.group);
    std::ranges::sort(groups);
    return static_cast<std::size_t>(std::unique(groups.begin(), groups.end()) - groups.begin());
}

}  // namespace

void LongRangeAttachments::prepare(const ClothModel& model, std::span<const std::uint32_t> pins) {
    const std::vector<GeodesicSource> sources = group_pins(model, pins);
    geodesics_.march(model, sources);
    std::vector<Layer> layers(std::min(count_groups(sources), Geodesics::most_reached));
    for (Layer& layer : layers) {
        layer.pins = AlignedBuffer<std::uint32_t>(model.particle_count);
        layer.lengths = AlignedBuffer<float>(model.particle_count);
    }
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        std::array<GeodesicReach, Geodesics::most_reached> ways;
        std::ranges::copy(geodesics_.from(i), ways.begin());
        std::ranges::sort(ways, {}, &GeodesicReach::group);
        for (std::size_t k = 0; k < layers.size(); ++k) {
            layers[k].pins[i] = ways[k].source;
            layers[k].lengths[i] = static_cast<float>(ways[k].distance);
        }
    }
    prepared_ = std::move(layers);
}

void LongRangeAttachments::hold(Parallel& parallel, float slack, std::span<Vec4> positions,
                                std::span<Vec4> velocities) const {
    const auto hold_particle = [&](const Layer& layer, std::uint32_t i) {
        if (layer.pins[i] == none || positions[i].w == 0) return;
        const Vector3 pin = xyz(positions[layer.pins[i]]), apart = xyz(positions[i]) - pin;
        const float limit = slack * layer.lengths[i], squared = apart.squaredNorm();
        if (!(squared > limit * limit)) return;
        const Vector3 away = apart / std::sqrt(squared);
        set_xyz(positions[i], pin + limit * away);
        const Vector3 velocity = xyz(velocities[i]);
        const float leaving = away.dot(velocity - xyz(velocities[layer.pins[i]]));
        if (leaving > 0) set_xyz(velocities[i], velocity - leaving * away);
    };
    // Pins are not moved, so that each particle's tethers are its own affair.
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& range) {
        for (const Layer& layer : layers_)
            for (std::uint32_t i = range.begin; i < range.end; ++i) hold_particle(layer, i);
    });
}

std::size_t LongRangeAttachments::bytes() const noexcept {
    std::size_t sum = geodesics_.bytes();
    for (const Layer& layer : layers_) sum += layer.pins.bytes() + layer.lengths.bytes();
    return sum;
}

}  // namespace weft
