#include "demo/panels/panels.h"

#include <algorithm>

namespace weft::demo {

void StageHistory::add(std::span<const StageTime> stages) {
    if (stages.size() != stages_) {
        clear();
        stages_ = stages.size();
        times_.assign(length * stages_, 0.0f);
    }
    for (std::size_t s = 0; s < stages_; ++s) times_[next_ * stages_ + s] = stages[s].last;
    next_ = (next_ + 1) % length;
    size_ = std::min(size_ + 1, length);
}

void StageHistory::clear() {
    size_ = next_ = 0;
}

float StageHistory::at(std::size_t stage, std::size_t age) const {
    const std::size_t row = (next_ + length - 1 - age) % length;
    return times_[row * stages_ + stage];
}

void Panels::forget() {
    history_.clear();
    message.clear();
}

void Panels::record(const World& world) {
    history_.add(world.profile());
}

PanelRequests Panels::draw(Simulation& simulation, WindControl& wind, Playback& playback,
                           const render::OrbitCamera& camera) {
    PanelRequests requests;
    if (!visible) return requests;
    scene_panel(simulation, pictures_, message, playback, requests);
    note(wind_panel(simulation, wind, camera));
    note(method_panel(simulation));
    note(cloth_panel(simulation));
    profiler_panel(simulation, history_, playback);
    return requests;
}

void Panels::note(const Result<void>& set) {
    if (!set) message = set.error().message;
}

Result<void> set_all_cloths(Simulation& simulation, const ClothSettings& settings) {
    for (const SceneCloth& each : simulation.content().cloths) {
        if (auto set = simulation.world().set_cloth_settings(each.id, settings); !set) return set;
    }
    return {};
}

}  // namespace weft::demo
