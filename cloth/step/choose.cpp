// The budget's choice of each cloth's level of detail, and cloths that take long steps.

#include <algorithm>
#include <array>
#include <utility>

#include "cloth/step/choose.h"

namespace weft {

namespace {

// Steps that a cloth stays on a rung at least: what one rung has left unsolved, the next would solve at once,
// visibly. A cloth does not rise soon after it fell, or its rung would oscillate.
constexpr std::uint32_t steps_to_fall = 4, steps_to_rise = 10;
// The same before another level of its garment takes over: what is drawn changes, and blends for a while.
constexpr std::uint32_t steps_to_coarsen = 30, steps_to_refine = 60;

/// A cloth may take long steps where nothing that it meets or wears changes before one ends.
bool can_stride(const Simulation& world, const Cloth& cloth) {
    return !world.body_stage && !cloth.is_disturbed && !cloth.has_features() && !cloth.state.frame &&
           !cloth.worn.has_limits() && cloth.attached.empty() && cloth.seams.empty();
}

/// The cloth of a level of its garment; that cloth itself, if it is in none.
const Cloth& level_of(const Simulation& world, const Cloth& cloth, std::uint32_t level) {
    if (cloth.garment == no_garment) return cloth;
    return **world.cloths.find(world.garments[cloth.garment].levels[level]);
}

/// Returns the cost of a cloth on each rung. That of a level that was never stepped is guessed by its size
/// beside the present one's.
std::array<float, rung_count> costs_of(const Cloth& level, const Cloth& present) {
    std::array<float, rung_count> costs = level.budgeted->costs.all();
    if (&level == &present || level.budgeted->costs.are_measured()) return costs;
    costs = present.budgeted->costs.all();
    for (float& cost : costs)
        cost *=
            static_cast<float>(level.model.particle_count) / static_cast<float>(present.model.particle_count);
    return costs;
}

/// The claim of a cloth whose rungs, and those of each level of its garment, are `rungs`. The error of a
/// coarser mesh grows with the square of its edges, and is above that of the finest one's last rung.
Claim claim_of(const Simulation& world, const Cloth& cloth, std::uint32_t rungs) {
    const bool has_levels = cloth.garment != no_garment;
    const Garment* const garment = has_levels ? &world.garments[cloth.garment] : nullptr;
    const std::uint32_t levels = has_levels ? static_cast<std::uint32_t>(garment->levels.size()) : 1;
    const auto finest = static_cast<float>(level_of(world, cloth, 0).model.particle_count);
    Claim claim{.importance = cloth.settings.importance * finest};
    for (std::uint32_t k = 0; k < levels; ++k) {
        const Cloth& level = level_of(world, cloth, k);
        const std::array<float, rung_count> costs = costs_of(level, cloth);
        const float coarse = k == 0 ? 0 : finest / static_cast<float>(level.model.particle_count);
        for (std::uint32_t r = 0; r < rungs; ++r)
            claim.offers[k * rungs + r] = {costs[r], coarse + ladder[r].error};
    }
    const std::uint32_t end = levels * rungs - 1, best = has_levels ? garment->least * rungs : 0;
    const DetailState& detail = *cloth.state.detail;
    claim.rung = cloth.level * rungs + std::min(detail.rung, rungs - 1);
    const std::uint32_t unchanged = static_cast<std::uint32_t>(world.state.steps) - detail.since;
    const bool refines = claim.rung % rungs == 0, coarsens = (claim.rung + 1) % rungs == 0;
    const bool may_rise = unchanged >= (refines ? steps_to_refine : steps_to_rise) && detail.rung < rungs;
    const bool may_fall = unchanged >= (coarsens ? steps_to_coarsen : steps_to_fall);
    claim.first = claim.rung - (may_rise && claim.rung > best ? 1 : 0);
    claim.last = std::min(end, claim.rung + (may_fall ? 1 : 0));
    return claim;
}

void choose_rungs(Simulation& world) {
    std::vector<Claim>& claims = world.allotment.claims();
    claims.clear();
    const auto rungs_of = [&](const Cloth& cloth) {
        return can_stride(world, cloth) ? rung_count : last_of_rate_1 + 1;
    };
    for (const Cloth* cloth : world.present) claims.push_back(claim_of(world, *cloth, rungs_of(*cloth)));
    world.allotment.allot(world.headroom.within(1e6f * world.settings.budget) / world.overhead);
    for (std::size_t i = 0; i < world.present.size(); ++i) {
        Cloth& cloth = *world.present[i];
        const std::uint32_t level = claims[i].rung / rungs_of(cloth), rung = claims[i].rung % rungs_of(cloth);
        if (level == cloth.level) {
            if (rung == cloth.state.detail->rung) continue;
            cloth.state.detail->go_to(rung, static_cast<std::uint32_t>(world.state.steps));
            cloth.budgeted->costs.change_rung();
        } else {
            world.garments[cloth.garment].next = {level, rung};
        }
        world.choices.push_back({cloth.id, level * rung_count + rung});
    }
}

/// Gives each cloth that begins to take long steps the phase in which the fewest particles take theirs.
void spread_long_steps(Simulation& world) {
    std::array<std::uint64_t, greatest_rate> loads{};
    const auto load = [&](const Cloth& cloth) {
        loads[cloth.state.detail->phase % greatest_rate] += cloth.model.particle_count;
    };
    for (Cloth* cloth : world.present) {
        std::uint32_t& phase = cloth->state.detail->phase;
        if (rate_of(cloth->state.detail->rung) == 1) phase = DetailState::no_phase;
        if (phase != DetailState::no_phase) load(*cloth);
    }
    for (Cloth* cloth : world.present) {
        DetailState& detail = *cloth->state.detail;
        if (rate_of(detail.rung) == 1 || detail.phase != DetailState::no_phase) continue;
        detail.phase = static_cast<std::uint32_t>(std::ranges::min_element(loads) - loads.begin());
        load(*cloth);
    }
}

/// Sets the length of each cloth's step. A cloth that may take no more long steps ends its last where it is.
void choose_rates(Simulation& world) {
    spread_long_steps(world);
    for (Cloth* cloth : world.present) {
        DetailState& detail = *cloth->state.detail;
        const bool may_stride = can_stride(world, *cloth);
        if (!may_stride) cloth->land();
        if (detail.left > 0) continue;
        const std::uint32_t rate = may_stride ? rate_of(detail.rung) : 1;
        detail.rate = rate > 1 && world.state.steps % rate == detail.phase % rate ? rate : 1;
    }
}

}  // namespace

void choose_details(Simulation& world) {
    world.began = world.clock();
    world.choices.clear();
    if (!world.has_given_choices) choose_rungs(world);
    choose_rates(world);
    for (Cloth* cloth : world.present) {
        if (cloth->is_gliding()) continue;
        const DetailState& detail = *cloth->state.detail;
        cloth->budgeted->settings = cloth->settings;
        cloth->budgeted->settings.method = reduced(cloth->settings.method, detail.rung, detail.rate);
    }
}

/// Stores the end of a long step, and begins the even interpolation from its start.
void begin_stride(Simulation& world, Worker& worker, Cloth& cloth) {
    if (!cloth.state.detail || cloth.state.detail->rate == 1) return;
    ClothState& now = cloth.state;
    if (cloth.restored) {
        now.detail->rate = 1;
        return;
    }
    std::ranges::copy(std::as_const(now.positions).span(), now.ahead.data());
    std::ranges::copy(std::as_const(now.previous_positions).span(), now.positions.data());
    now.detail->left = now.detail->rate;
    glide(world, worker, cloth);
}

void glide(Simulation& world, Worker& worker, Cloth& cloth) {
    const auto timer = world.timed(Stage::advance);
    ClothState& now = cloth.state;
    const std::uint32_t left = now.detail->left--;
    const float part = 1 / static_cast<float>(left);
    worker.parallel.ranges(now.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vec4 from = now.positions[i];
            const Vector3 to = xyz(now.ahead[i]), here = xyz(from);
            now.previous_positions[i] = from;
            set_xyz(now.positions[i], left == 1 ? to : Vector3(here + part * (to - here)));
        }
    });
    cloth.extent = survey(worker.parallel, now, cloth.partial_surveys.span());
    cloth.restored = false;
    world.update_normals(worker.parallel, cloth);
}

void Cloth::land() noexcept {
    if (!is_gliding()) return;
    state.detail->left = 0;
    state.record.h = 0;
}

BudgetBuffers Cloth::make_budget(bool on) const {
    BudgetBuffers made;
    if (!on) return made;
    made.budgeted = std::make_unique<Budgeted>(settings, model.particle_count);
    made.ahead = AlignedBuffer<Vec4>(model.particle_count);
    return made;
}

void Cloth::take_budget(BudgetBuffers&& made) noexcept {
    land();
    budgeted = std::move(made.budgeted);
    state.ahead = std::move(made.ahead);
    state.detail.reset();
    if (budgeted) state.detail.emplace();
}

void learn_costs(Simulation& world) {
    float took = 0;
    for (Cloth* cloth : world.present) {
        Budgeted& of = *cloth->budgeted;
        const DetailState& detail = *cloth->state.detail;
        const auto cost =
            static_cast<float>(world.cost_of != nullptr ? world.cost_of(*cloth) : cloth->nanoseconds);
        took += cost;
        of.spent += cost;
        ++of.steps;
        if (detail.left > 0) continue;
        // A cloth that was to take long steps, and could not, says nothing about their cost.
        if (detail.rate == rate_of(detail.rung))
            of.costs.add(detail.rung, of.spent / static_cast<float>(of.steps));
        of.spent = 0;
        of.steps = 0;
    }
    if (!(took > 0)) return;
    const float ratio =
        world.cost_of != nullptr ? 1.0f : static_cast<float>(world.clock() - world.began) / took;
    if (const float known = world.allotment.spent(); known > 0)
        world.headroom.add(ratio * took / (world.overhead * known));
    world.overhead += (std::clamp(ratio, 0.5f * world.overhead, 2 * world.overhead) - world.overhead) / 32;
}

}  // namespace weft
