#include "demo/learn/comparison.h"

#include <algorithm>
#include <cmath>

#include "demo/must.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr int balanced_every = 30;  // steps

/// The scene from its start, with the shown one's settings. Throws Refusal; `change` alters those of its
/// cloths.
template <class Change>
Simulation again(Simulation& shown, const Change& change) {
    Overrides overrides;
    overrides.threads = shown.world().settings().threads;
    Simulation made = must(Simulation::create(shown.entry(), shown.options(), overrides));
    must(made.world().set_settings(shown.world().settings()));
    for (std::size_t i = 0; i < made.content().cloths.size(); ++i) {
        ClothSettings settings = must(shown.world().cloth_settings(shown.content().cloths[i].id));
        change(settings);
        must(made.world().set_cloth_settings(made.content().cloths[i].id, settings));
    }
    return made;
}

void follow(float& mean, float value) {
    mean = mean == 0 ? value : mean + (value - mean) / 60;
}

}  // namespace

int balanced_substeps(int substeps, float shown, float other) {
    if (!(shown > 0) || !(other > 0)) return substeps;
    const float wanted = std::min(static_cast<float>(substeps) * shown / other, 64.0f);
    return std::max(static_cast<int>(std::lround(wanted)), 1);
}

Result<Comparison> Comparison::start(Simulation& shown, const Method& other, Fairness fairness) {
    Comparison comparison;
    comparison.method_ = other;
    comparison.fairness_ = fairness;
    return caught([&] {
        comparison.simulations_.push_back(again(shown, [&](ClothSettings& settings) {
            const bool positional =
                std::holds_alternative<Xpbd>(other) || std::holds_alternative<Fibres>(other);
            if (positional) settings.fabric.stiffening = 0;  // these methods refuse it
            settings.method = other;
            settings.time_scheme = TimeScheme::of_method;
        }));
        comparison.simulations_.push_back(again(shown, [](ClothSettings& settings) {
            settings.method = Multilevel{.passes = 20};
            settings.time_scheme = TimeScheme::of_method;
            settings.substeps = 8;
        }));
        return std::move(comparison);
    });
}

void Comparison::step(const Simulation& shown, float dt) {
    const float shown_took = shown.world().report().milliseconds;
    const float other_took = simulations_[0].step(dt).milliseconds;
    simulations_[1].step(dt);
    follow(shown_.milliseconds, shown_took);
    follow(other_.milliseconds, other_took);
    measure(shown, simulations_[1], shown_);
    measure(simulations_[0], simulations_[1], other_);
    if (fairness_ == Fairness::same_time && ++steps_ % balanced_every == 0) balance();
}

/// Sets the other's substeps so that both take the same time.
void Comparison::balance() {
    const int substeps = balanced_substeps(other_.substeps, shown_.milliseconds, other_.milliseconds);
    if (substeps == other_.substeps) return;
    for (const SceneCloth& cloth : simulations_[0].content().cloths) {
        auto settings = simulations_[0].world().cloth_settings(cloth.id);
        settings->substeps = substeps;
        (void)simulations_[0].world().set_cloth_settings(cloth.id, *settings);
    }
    other_.substeps = substeps;
    other_.milliseconds = 0;  // measured anew
}

void Comparison::measure(const Simulation& of, const Simulation& exact, Side& side) {
    double sum = 0;
    float most = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < of.content().cloths.size(); ++i) {
        const auto mine = of.world().cloth(of.content().cloths[i].id);
        const auto its = exact.world().cloth(exact.content().cloths[i].id);
        if (!mine || !its || mine->positions.size() != its->positions.size()) continue;
        for (std::size_t p = 0; p < mine->positions.size(); ++p) {
            const float away = (xyz(mine->positions[p]) - xyz(its->positions[p])).norm();
            sum += static_cast<double>(away) * static_cast<double>(away);
            most = std::max(most, away);
        }
        count += mine->positions.size();
    }
    side.usual = count > 0 ? 1e3f * static_cast<float>(std::sqrt(sum / static_cast<double>(count))) : 0;
    side.farthest = 1e3f * most;
}

}  // namespace weft::demo
