#include "demo/learn/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "demo/must.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr int balanced_every = 30;  // steps
/// Passes of the truth's substeps, with which more change less than chaos does; and its substeps in a step of
/// 1/60 s: at least 8, and at least 4 in each of the World's.
constexpr int truth_passes = 4, truth_substeps = 8, truth_finer = 4;

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

void set_substeps(Simulation& simulation, int substeps) {
    for (const SceneCloth& cloth : simulation.content().cloths) {
        auto settings = simulation.world().cloth_settings(cloth.id);
        settings->substeps = substeps;
        (void)simulation.world().set_cloth_settings(cloth.id, *settings);
    }
}

void take_wind(const Simulation& from, Simulation& to) {
    WorldSettings settings = to.world().settings();
    settings.wind = from.world().settings().wind;
    (void)to.world().set_settings(settings);
}

}  // namespace

BothSubsteps balanced_substeps(int least, float shown, float other) {
    constexpr int most = 64;
    constexpr float even = 0.095f;  // logarithm of 1.1
    BothSubsteps best{least, least};
    float least_off = std::numeric_limits<float>::infinity();
    for (int mine = least; mine <= most; ++mine) {
        const float wanted = static_cast<float>(mine) * shown / other;
        const int its = static_cast<int>(std::lround(std::clamp(wanted, 1.0f, static_cast<float>(most))));
        const float off = std::abs(std::log(wanted / static_cast<float>(its)));
        if (off < least_off) best = {mine, its};
        least_off = std::min(least_off, off);
        if (off <= even || (mine >= 4 * least && wanted >= 1)) break;
    }
    return best;
}

Result<Comparison> Comparison::start(Simulation& shown, const Method& other, Fairness fairness) {
    Comparison comparison;
    comparison.method_ = other;
    comparison.fairness_ = fairness;
    comparison.own_substeps_ = must(shown.world().cloth_settings(shown.content().cloths.front().id)).substeps;
    comparison.truth_substeps_ = std::max(truth_finer * comparison.own_substeps_,
                                          truth_substeps / std::max(shown.world().settings().substeps, 1));
    comparison.shown_.substeps = comparison.other_.substeps = comparison.own_substeps_;
    return caught([&] {
        comparison.simulations_.push_back(again(shown, [&](ClothSettings& settings) {
            const bool positional =
                std::holds_alternative<Xpbd>(other) || std::holds_alternative<Fibres>(other);
            if (positional) settings.fabric.stiffening = 0;  // these methods refuse it
            settings.method = other;
            settings.time_scheme = TimeScheme::of_method;
        }));
        comparison.simulations_.push_back(again(shown, [&](ClothSettings& settings) {
            settings.method = Multilevel{.passes = truth_passes};
            settings.time_scheme = TimeScheme::of_method;
            settings.substeps = comparison.truth_substeps_;
        }));
        return std::move(comparison);
    });
}

void Comparison::step(Simulation& shown, float dt) {
    for (Simulation& each : simulations_) take_wind(shown, each);
    const float shown_took = shown.world().report().milliseconds;
    const float other_took = simulations_[0].step(dt).milliseconds;
    milliseconds_ = other_took + simulations_[1].step(dt).milliseconds;
    follow(shown_.milliseconds, shown_took);
    follow(other_.milliseconds, other_took);
    measure(shown, simulations_[1], shown_);
    measure(simulations_[0], simulations_[1], other_);
    if (fairness_ == Fairness::same_time && ++steps_ % balanced_every == 0) balance(shown);
}

/// Sets substeps so that both take the same time, and measures anew.
void Comparison::balance(Simulation& shown) {
    constexpr float within = 0.15f;  // share by which times may differ: timers are no finer
    const float ratio = shown_.milliseconds / std::max(other_.milliseconds, 1e-6f);
    if (!(ratio > 0) || std::abs(ratio - 1) < within) return;
    const BothSubsteps wanted =
        balanced_substeps(own_substeps_, shown_.milliseconds / static_cast<float>(shown_.substeps),
                          other_.milliseconds / static_cast<float>(other_.substeps));
    if (wanted == BothSubsteps{shown_.substeps, other_.substeps}) return;
    set_substeps(shown, wanted.shown);
    set_substeps(simulations_[0], wanted.other);
    constexpr int most = 64;
    set_substeps(simulations_[1],
                 std::clamp(2 * std::max(wanted.shown, wanted.other), truth_substeps_, most));
    shown_.substeps = wanted.shown;
    other_.substeps = wanted.other;
    shown_.milliseconds = other_.milliseconds = 0;
}

void Comparison::end(Simulation& shown) const {
    if (shown_.substeps != own_substeps_) set_substeps(shown, own_substeps_);
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
