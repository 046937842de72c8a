#include "demo/study/stability/stability_verdict.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace weft::study {

namespace {

constexpr std::array<const char*, verdict_count> words{"stable", "wrong", "diverged", "nan"};

/// Whether a value is at most the limit; false for not-a-number.
bool is_within(double value, double limit) {
    return value <= limit;
}

}  // namespace

std::string word(Verdict verdict) {
    return words[static_cast<std::size_t>(verdict)];
}

Verdict verdict_of(const std::string& word) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (word == words[i]) return static_cast<Verdict>(i);
    throw std::runtime_error("no verdict is called " + word);
}

std::string Judgement::broken() const {
    std::string text;
    const auto add = [&](bool is_broken, const char* name) {
        if (is_broken) text += (text.empty() ? "" : "+") + std::string(name);
    };
    add(energy, "energy");
    add(stretch, "stretch");
    add(height, "height");
    return text;
}

Judgement judge(const RunMeasures& run, const Tolerance& tolerance) {
    if (run.not_a_number) return {Verdict::not_a_number};
    if (run.ran_away) return {Verdict::diverged};
    Judgement judgement{Verdict::stable};
    judgement.energy = !is_within(run.energy_rise(), tolerance.energy_rise);
    judgement.stretch = !is_within(std::abs(run.stretch - run.hang_stretch), tolerance.stretch);
    judgement.height = !is_within(std::abs(run.height - run.hang_height), tolerance.height);
    if (!is_within(run.energy_gain(), 1) && !is_within(run.stretch - run.hang_stretch, torn_stretch))
        judgement.verdict = Verdict::diverged;
    else if (judgement.energy || judgement.stretch || judgement.height)
        judgement.verdict = Verdict::wrong;
    return judgement;
}

}  // namespace weft::study
