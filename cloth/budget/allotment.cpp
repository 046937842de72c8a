#include "cloth/budget/allotment.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "cloth/budget/budgeted.h"

namespace weft {

namespace {

/// Fraction of the time within which cloths get rungs that they do not have yet.
constexpr float without_reserve = 0.9f;
/// Factor on the worth of rungs that a cloth has already (hysteresis).
constexpr float loyalty = 1.4f;

/// Limit of a sample over the known cost, and of the inverse. The first step on a rung finds cold memory, and
/// a preempted step may cost anything.
constexpr float most_surprise = 2;
constexpr std::uint32_t samples_to_know = 8;

}  // namespace

RungCosts::RungCosts(float guess) {
    for (std::uint32_t r = 0; r < rung_count; ++r) costs_[r] = guess * ladder[r].cost;
}

// While a rung is new its samples set its own cost alone. Later ones also scale the costs of all known rungs.
void RungCosts::add(std::uint32_t rung, float nanoseconds) {
    float& known = costs_[rung];
    const bool is_first = !known_[rung];
    const float sample =
        is_first ? nanoseconds : std::clamp(nanoseconds, known / most_surprise, known * most_surprise);
    const float before = known;
    const float weight = is_first ? 1.0f : 0.125f;
    known += weight * (sample - known);
    known_[rung] = true;
    const bool is_new = ++samples_ <= samples_to_know;
    for (std::uint32_t r = 0; r < rung_count; ++r) {
        if (r == rung) continue;
        if (!known_[r])
            costs_[r] = known * ladder[r].cost / ladder[rung].cost;
        else if (!is_new && before > 0)
            costs_[r] *= known / before;
    }
}

// Stochastic approximation of a quantile (Robbins, Monro 1951): steady where one ratio of twenty is beyond
// it. A step that the machine interrupted counts no more than any other beyond it.
void Headroom::add(float ratio) noexcept {
    constexpr float up = 0.019f, down = 0.001f, most = 1.5f;
    quantile_ = std::clamp(quantile_ + (ratio > quantile_ ? up : -down), 1.0f, most);
}

void Allotment::reserve(std::size_t claims) {
    claims_.reserve(claims);
    reached_.reserve(claims);
    steps_.reserve(claims * (most_garment_levels * rung_count - 1));
}

void Allotment::allot(float time) {
    steps_.clear();
    reached_.clear();
    float spent = 0;
    for (std::uint32_t c = 0; c < claims_.size(); ++c) {
        const Claim& claim = claims_[c];
        reached_.push_back(claim.last);
        spent += claim.offers[claim.last].cost;
        // A rung cannot be bought before the one below it, so it is worth no more than that one.
        float worth = std::numeric_limits<float>::max();
        for (std::uint32_t from = claim.last; from > claim.first; --from) {
            const std::uint32_t to = from - 1;
            const Offer &better = claim.offers[to], &worse = claim.offers[from];
            const float gain = claim.importance * (worse.error - better.error);
            const float price = std::max(better.cost - worse.cost, 1e-3f * better.cost);
            if (!(gain > 0 && price > 0)) break;
            worth = std::min(worth, (claim.rung <= to ? loyalty : 1.0f) * gain / price);
            steps_.push_back({worth, c, to});
        }
    }
    std::ranges::sort(steps_, [](const Step& a, const Step& b) {
        return std::tuple(-a.worth, a.claim, -static_cast<int>(a.to)) <
               std::tuple(-b.worth, b.claim, -static_cast<int>(b.to));
    });
    for (const Step& step : steps_) {
        const Claim& claim = claims_[step.claim];
        if (reached_[step.claim] != step.to + 1) continue;
        const bool has_it = claim.rung <= step.to;
        const float price = std::max(claim.offers[step.to].cost - claim.offers[step.to + 1].cost, 0.0f);
        if (spent + price > (has_it ? time : without_reserve * time)) continue;
        spent += price;
        reached_[step.claim] = step.to;
    }
    for (std::uint32_t c = 0; c < claims_.size(); ++c) claims_[c].rung = reached_[c];
    spent_ = spent;
}

}  // namespace weft
