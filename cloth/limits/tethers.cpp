#include "cloth/limits/tethers.h"

#include <algorithm>
#include <array>

#include "engine/vector.h"

namespace weft {

namespace {

/// Pins and their holds: pins that structural springs join form one. Precondition: pins ascend.
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

/// Fills the layers with each particle's pins and their distances.
void LongRangeAttachments::measure(const ClothModel& model, std::span<const GeodesicSource> sources,
                                   std::span<Layer> layers) {
    if (layers.empty()) return;
    geodesics_.march(model, sources);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        std::array<GeodesicReach, Geodesics::most_reached> ways;
        std::ranges::copy(geodesics_.from(i), ways.begin());
        std::ranges::sort(ways, {}, &GeodesicReach::group);
        for (std::size_t k = 0; k < layers.size(); ++k) {
            layers[k].pins[i] = ways[k].source;
            layers[k].lengths[i] = static_cast<float>(ways[k].distance);
        }
    }
}

void LongRangeAttachments::prepare(const ClothModel& model, std::span<const std::uint32_t> pins) {
    Prepared next{.sources = group_pins(model, pins), .is_outdated = has_changed_};
    next.layer_count = std::min(count_groups(next.sources), Geodesics::most_reached);
    for (std::size_t k = has_changed_ ? layer_count_ : 0; k < next.layer_count; ++k)
        next.layers[k] = {AlignedBuffer<std::uint32_t>(model.particle_count),
                          AlignedBuffer<float>(model.particle_count)};
    geodesics_.reserve();
    if (!next.is_outdated) measure(model, next.sources, std::span(next.layers).first(next.layer_count));
    prepared_ = std::move(next);
}

std::unique_ptr<Limit> LongRangeAttachments::clone() const {
    auto copy = std::make_unique<LongRangeAttachments>(*this);
    if (is_outdated_) copy->geodesics_.reserve();
    return copy;
}

void LongRangeAttachments::commit() noexcept {
    const std::size_t before = layer_count_;
    layer_count_ = prepared_.layer_count;
    for (std::size_t k = 0; k < layers_.size(); ++k)
        if (k >= layer_count_ || prepared_.layers[k].pins.size() > 0)
            layers_[k] = std::move(prepared_.layers[k]);
    sources_ = std::move(prepared_.sources);
    is_outdated_ = prepared_.is_outdated;
    has_changed_ = has_changed_ || before > 0 || layer_count_ > 0;
    prepared_ = {};
}

void LongRangeAttachments::update(const ClothModel& model) noexcept {
    if (is_outdated_) measure(model, sources_, std::span(layers_).first(layer_count_));
    is_outdated_ = has_changed_ = false;
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
    // Pins are not moved, so that the tethers of different particles are independent.
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& range) {
        for (const Layer& layer : layers())
            for (std::uint32_t i = range.begin; i < range.end; ++i) hold_particle(layer, i);
    });
}

std::size_t LongRangeAttachments::bytes() const noexcept {
    std::size_t sum = geodesics_.bytes() + sources_.capacity() * sizeof(GeodesicSource);
    for (const Layer& layer : layers()) sum += layer.pins.bytes() + layer.lengths.bytes();
    return sum;
}

}  // namespace weft
