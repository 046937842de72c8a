// The part of the frame that features have: what is near what, cloths that touch solved together, and motion
// that lets nothing through.

#include <algorithm>
#include <limits>
#include <utility>

#include "cloth/frame/advance/advance.h"
#include "cloth/frame/simulation.h"
#include "cloth/solvers/multigrid/multilevel.h"

namespace weft {

namespace {

/// Boxes around points, of which one that is not finite has no part in.
class GrowingBox {
  public:
    void add(const Vector3& point) {
        lower_ = lower_.cwiseMin(point);
        upper_ = upper_.cwiseMax(point);
    }
    [[nodiscard]] Bounds grown_by(float reach) const {
        const Vector3 margin = Vector3::Constant(reach);
        return {to_vec3(lower_ - margin), to_vec3(upper_ + margin)};
    }

  private:
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    Vector3 lower_ = Vector3::Constant(infinity), upper_ = -lower_;
};

/// Where the cloth is and, if it goes on as it does, where it will be when the substep ends.
Bounds predicted_box(const Cloth& cloth, const Vector3& gravity, float h) {
    GrowingBox box;
    if (!cloth.features) return box.grown_by(0);
    const Vector3 fall = h * h * gravity;
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vector3 here = xyz(cloth.state.positions[i]);
        const Vector3 there = here + h * xyz(cloth.state.velocities[i]);
        box.add(here);
        box.add(there);
        box.add(there + fall);
    }
    return box.grown_by(cloth.as_body().radius);
}

/// Where the cloth has gone in the substep.
Bounds swept_box(const Cloth& cloth) {
    GrowingBox box;
    if (!cloth.features) return box.grown_by(0);
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        box.add(xyz(cloth.substep_start[i]));
        box.add(xyz(cloth.state.positions[i]));
    }
    return box.grown_by(cloth.as_body().floor);
}

/// Whether it can be in one equation with other cloths.
bool can_be_together(const Cloth& cloth) {
    return cloth.solver->joins() && !has_zones(cloth.settings.self_collision);
}

/// Parts of a substep, by their settings, that the island's cloths take together: those of the first that can
/// be in one equation with others.
int substeps_of(std::span<Cloth* const> island) {
    const auto first =
        std::ranges::find_if(island, [](const Cloth* cloth) { return can_be_together(*cloth); });
    return first != island.end() ? (*first)->settings.substeps : 1;
}

bool meets_bodies(std::span<Cloth* const> cloths) {
    return std::ranges::any_of(cloths, &Cloth::meets_bodies);
}

bool touches_colliders(std::span<Cloth* const> cloths) {
    return std::ranges::any_of(
        cloths, [](const Cloth* cloth) { return cloth->collider_contacts > 0 || cloth->worn.is_holding(); });
}

/// Of cloths that take their next step by one equation, which has one gamma: the largest of theirs.
float common_gamma(std::span<Cloth* const> cloths, float h) {
    float most = 0;
    for (const Cloth* cloth : cloths) most = std::max(most, cloth->bdf_of(h).gamma);
    return most;
}

/// Calm cloth costs nothing.
void remember_tangles(const FeatureContact& space, std::size_t body, ClothState& state) {
    if (state.may_cross == 0 && !space.may_cross()) return;
    std::ranges::copy(space.memory(body), state.tangles.data());
    state.may_cross = space.may_cross() ? 1 : 0;
}

}  // namespace

// Where layers come together by many distances in a step there are more pairs than a list holds, and what is
// cut leaves knots. Half the motion has half as many.
bool Simulation::was_cut_much(std::span<Cloth* const> featured) {
    if (featured.empty()) return false;
    constexpr std::uint32_t most = 400;  // of so many particles one may have been
    std::uint32_t particles = 0;
    for (const Cloth* cloth : featured) particles += cloth->state.size();
    const FeatureCounts& counts = featured.front()->feature_counts;
    if (counts.unresolved > 0) return false;  // by zones, which cut nothing
    // What comes apart would be pushed twice a step, and fly.
    const bool is_tangled = counts.tangles.crossings > 0;
    return counts.overflowed || (!is_tangled && most * counts.truncated > particles);
}

int Simulation::parts_of_step(std::span<Cloth* const> island) {
    return std::ranges::any_of(island, [](const Cloth* cloth) { return cloth->state.halved > 0; }) ? 2 : 1;
}

void Simulation::count_halved_steps(std::span<Cloth* const> island, bool cut_much) {
    constexpr std::uint32_t more = 10;
    for (Cloth* cloth : island) {
        std::uint32_t& halved = cloth->state.halved;
        halved = cut_much ? more : halved - std::min(halved, 1u);
    }
}

// Cloths are solved together whose boxes over the substep overlap, or that may meet the same body.
void Simulation::meet(const Substep& substep) {
    boxes_.clear();
    for (Cloth* cloth : present_) {
        boxes_.push_back(predicted_box(*cloth, to_vector(settings.gravity), substep.h));
        if (cloth->features)
            std::ranges::copy(std::as_const(cloth->state.positions).span(), cloth->substep_start.data());
    }
    finder_.find(boxes_,
                 [&](std::uint32_t i, std::uint32_t j) { return may_meet(*present_[i], *present_[j]); });
    if (bodies_) finder_.join(bodies_->sharing.first_of());
    islands_.plan(present_, finder_.first_of(), parallel.width());
    solved_with_.assign(finder_.first_of().begin(), finder_.first_of().end());
}

/// Places the cloths at the positions that start_of(cloth) returns.
template <class StartOf>
void Simulation::place_features(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                                const StartOf& start_of, float h) const {
    space.begin();
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        const Cloth& cloth = *cloths[k];
        space.add(cloth.as_body());
        space.place(worker.parallel, k, start_of(cloth),
                    {.velocities = cloth.state.velocities.span(), .h = h});
        if (cloth.state.may_cross != 0) space.recall(k, cloth.state.tangles.span());
    }
}

void Simulation::find_features(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                               float h) {
    const auto timer = timed(Stage::self_search);
    place_features(
        worker, space, cloths, [](const Cloth& cloth) { return cloth.state.positions.span(); }, h);
    if (!space.uses_zones()) space.detect(worker.parallel);
}

/// Before the rows are made: the cloth's equation is to have them.
void Simulation::join_features(Worker& worker, FeatureContact& space, std::size_t body, Cloth& cloth,
                               StepEquation& equation) {
    space.set_base(worker.parallel, body, equation.base_positions);
    equation.pairs = &space.rows();
    equation.first = space.first(body);
    cloth.contacts->join(*equation.pairs, equation.first);
}

std::span<Cloth* const> Simulation::with_features(std::span<Cloth* const> cloths) {
    featured_.clear();
    for (Cloth* cloth : cloths)
        if (cloth->features) featured_.push_back(cloth);
    return featured_;
}

void Simulation::solve_island(Worker& worker, std::span<Cloth* const> island, float dt,
                              const Substep& substep) {
    const std::span<Cloth* const> featured = with_features(island);
    const bool with_bodies = meets_bodies(island);
    int parts = parts_of_step(island);
    if (with_bodies) take_bodies(island, substep.h);
    for (Cloth* cloth : island) parts = std::max(parts, parts_to_meet(worker, *cloth, substep));
    parts *= substeps_of(island);
    bool cut_much = false;
    for (int k = 0; k < parts; ++k) {
        if (k > 0 && air_is_on())
            for (Cloth* cloth : island) air_forces(worker, *cloth, true);
        solve_together(worker, island, dt, substep.part(k, parts, dt));
        cut_much |= was_cut_much(featured);
        if (with_bodies)  // the next part goes on from there
            for (std::size_t b = 0; b < bodies_->moving.size(); ++b)
                bodies_->begins[b] = {bodies_->moving[b].start, bodies_->moving[b].velocity};
    }
    if (with_bodies) load_bodies();
    count_halved_steps(featured, cut_much);
}

// Cloths that cannot be in an equation with others go before, alone. Those without features are an equation
// of their own, since pairs have no rows for them. Whoever has gone is for the others where it then is.
void Simulation::solve_together(Worker& worker, std::span<Cloth* const> island, float dt,
                                const Substep& substep) {
    const std::span<Cloth* const> featured = featured_;
    const bool features_meet = featured.size() > 1;
    if (features_meet) find_features(worker, *together_, featured, substep.h);
    const std::size_t plain = choose_joined(island, substep.h);
    const auto is_joined = [&](Cloth* cloth) { return std::ranges::find(joined_, cloth) != joined_.end(); };
    for (Cloth* cloth : island)
        if (!is_joined(cloth)) solve(worker, *cloth, dt, substep);
    const std::span<Cloth* const> joined = joined_;
    solve_joined(worker, joined.first(plain), {}, substep);
    if (!features_meet) return;
    for (std::size_t k = 0; k < featured.size(); ++k)
        if (!is_joined(featured[k]))
            together_->set_fixed_base(worker.parallel, k, featured[k]->state.positions.span());
    solve_joined(worker, joined.subspan(plain), featured, substep);
}

/// Fills joined_ with the island's cloths that are solved as one equation with others: first those without
/// features, whose number is returned, then those with features.
std::size_t Simulation::choose_joined(std::span<Cloth* const> island, float h) {
    const int substeps = substeps_of(island);
    // There is one list of colliders with which bodies move.
    const auto can_join = [&](const Cloth& cloth) {
        return can_be_together(cloth) && cloth.settings.substeps == substeps && !(bodies_ && cloth.carried);
    };
    const auto first = std::ranges::find_if(island, [&](const Cloth* cloth) { return can_join(*cloth); });
    const auto add = [&](bool with_features) {
        for (Cloth* cloth : island)
            if (cloth->features.has_value() == with_features && can_join(*cloth) &&
                cloth->bdf_of(h).is_second_order() == (*first)->bdf_of(h).is_second_order())
                joined_.push_back(cloth);
    };
    joined_.clear();
    add(false);
    if (joined_.size() == 1) joined_.clear();
    const std::size_t plain = joined_.size();
    if (featured_.size() > 1) add(true);
    return plain;
}

/// Solves cloths as one equation and moves them; then sees to it that features, of these and of others, do
/// not cross.
void Simulation::solve_joined(Worker& worker, std::span<Cloth* const> cloths,
                              std::span<Cloth* const> featured, const Substep& substep) {
    if (cloths.empty() && featured.empty()) return;
    const bool with_bodies = meets_bodies(cloths);
    const float gamma = common_gamma(cloths, substep.h);
    if (with_bodies) {
        for (Cloth* cloth : cloths) cloth->meets_bodies = true;
        take_bodies(cloths, substep.h);
        start_part_of_bodies(cloths, substep.h, gamma);
    }
    std::uint32_t mask = 0;
    for (const Cloth* cloth : cloths) mask |= cloth->settings.collider_mask;
    for (const Cloth* cloth : featured) mask |= cloth->settings.collider_mask;
    move_colliders(worker, mask, substep);
    if (with_bodies) add_carried_motions(worker.motions, mask, substep);
    make_equations(worker, cloths, featured, substep, gamma);
    if (!cloths.empty()) solve_equations(worker, cloths, substep);
    if (!featured.empty()) settle_features(worker, *together_, featured, substep);
    if (with_bodies) finish_part_of_bodies(cloths);
}

void Simulation::make_equations(Worker& worker, std::span<Cloth* const> cloths,
                                std::span<Cloth* const> featured, const Substep& substep, float gamma) {
    equations_.clear();
    steps_.clear();
    members_.clear();
    for (Cloth* cloth : cloths) {
        StepEquation& equation =
            equations_.emplace_back(equation_of(worker, *cloth, substep.h, cloth->bdf_of(substep.h, gamma)));
        if (cloth->carried) see_colliders(worker, *cloth, substep);
        begin_contacts(worker, *cloth, substep);
        if (const auto at = std::ranges::find(featured, cloth); at != featured.end())
            join_features(worker, *together_, static_cast<std::size_t>(at - featured.begin()), *cloth,
                          equation);
        if (cloth->meets_bodies) carry_bodies(*cloth, equation);
        steps_.push_back({.parallel = worker.parallel,
                          .profiler = profiler,
                          .model = cloth->model,
                          .settings = cloth->stepped_settings(),
                          .equation = equation,
                          .velocities = cloth->next_velocities.span()});
        members_.push_back(static_cast<MultilevelSolver&>(*cloth->solver).member(steps_.back()));
    }
    if (!cloths.empty() && !featured.empty()) together_->make_rows(worker.parallel, equations_.front().gamma);
}

void Simulation::solve_equations(Worker& worker, std::span<Cloth* const> cloths, const Substep& substep) {
    residuals_.assign(members_.size(), 0.0f);
    const SolveResult result = solve_by_passes(members_, residuals_);
    if (reports_contacts()) find_joined_impulses(worker, cloths);
    for (std::size_t m = 0; m < cloths.size(); ++m) {
        Cloth& cloth = *cloths[m];
        take_result(worker, cloth, equations_[m], {residuals_[m], result.ok, result.unsolved}, true);
        collect_from_equation(cloth, equations_[m]);
        advance(worker, cloth, equations_[m], substep.is_first());
        settle(worker, cloth, substep);
    }
    if (cloths.front()->meets_bodies) place_attached(cloths);
}

void Simulation::find_joined_impulses(Worker& worker, std::span<Cloth* const> cloths) {
    for (std::size_t m = 0; m < cloths.size(); ++m) {
        if (equations_[m].pairs == nullptr) continue;
        equations_[m].pairs->take(worker.parallel, equations_[m].first,
                                  std::as_const(cloths[m]->next_velocities).span());
        find_missing_impulses(steps_[m], *cloths[m]);
    }
}

// The last that moves particles in a substep.
void Simulation::settle_features(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                                 const Substep& substep) {
    const auto timer = timed(Stage::self_response);
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        if (cloths[k]->impulse_ratio > 0)
            std::ranges::copy(std::as_const(cloths[k]->state.velocities).span(),
                              cloths[k]->next_velocities.data());
        if (substep.is_last()) cloths[k]->place_pins();
        space.arrive(worker.parallel, k, cloths[k]->state.positions.span());
        cloths[k]->feature_counts = {};
    }
    FeatureCounts& counts = cloths.front()->feature_counts;
    counts = space.settle(worker.parallel, touches_colliders(cloths));
    keep_cut_out_of_colliders(worker, space, cloths, substep.h);
    if constexpr (looks_for_new_crossings) counts.crossed = space.crosses_anew(worker.parallel);
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        hand_back(worker, space, k, *cloths[k], substep.h);
        if (space.uses_zones()) keep_out_of_colliders(worker, *cloths[k], substep.h);
        remember_tangles(space, k, cloths[k]->state);
    }
    if (reports_contacts() && !space.uses_zones()) log_pairs(worker, space, cloths);
}

/// Writes a body's settled motion to its cloth.
void Simulation::hand_back(Worker& worker, const FeatureContact& space, std::size_t body, Cloth& cloth,
                           float h) {
    space.hand_back(worker.parallel, body, h, cloth.state.positions.span(), cloth.state.velocities.span());
    limit_speeds(worker.parallel, settings.max_speed, cloth.state.velocities.span());
}

// Zones pass momentum on to what lies on a collider, which has the last word (Huh, Metaxas, Badler 2001,
// section 2: cloth against rigid bodies on top of cloth against cloth).
void Simulation::keep_out_of_colliders(Worker& worker, Cloth& cloth, float h) {
    if (colliders_of(worker, cloth).empty() || !meets_in_equation(cloth.settings)) return;
    cloth.collider_contacts = std::max(cloth.collider_contacts, collide(worker, cloth, h, {}));
}

// Cloth can go another way than it was going when islands were found. Where it came near cloth of another
// island, both are cut; that may bring them near a third, and in the last round all are taken for one.
void Simulation::part_strays(const Substep& substep) {
    constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round) {
        boxes_.clear();
        for (const Cloth* cloth : present_) boxes_.push_back(swept_box(*cloth));
        const bool is_last = round + 1 == rounds;
        bool any = false;
        finder_.find(boxes_, [&](std::uint32_t i, std::uint32_t j) {
            const bool meet = may_meet(*present_[i], *present_[j]);
            any = any || (meet && solved_with_[i] != solved_with_[j]);
            return meet;
        });
        if (!any) return;
        join_solved(is_last);
        islands_.plan(present_, solved_with_, 1);
        Worker all{parallel, motions_[0], contact_reports_.of_thread(0)};
        for (const Schedule::Group& group : islands_.in_turn())
            if (const auto featured = with_features(group.cloths); featured.size() > 1)
                cut_strays(all, featured, substep);
    }
}

/// Joins what was solved together with what has come near each other since; or all that has features.
void Simulation::join_solved(bool all) {
    const std::span<const std::uint32_t> near = finder_.first_of();
    const auto first_feature = static_cast<std::uint32_t>(
        std::ranges::find_if(present_, [](const Cloth* cloth) { return cloth->features.has_value(); }) -
        present_.begin());
    for (bool changed = true; changed;) {
        changed = false;
        const auto lower = [&](std::uint32_t& label, std::uint32_t to) {
            if (to >= label) return;
            label = to;
            changed = true;
        };
        for (std::uint32_t i = 0; i < solved_with_.size(); ++i) {
            for (const std::uint32_t other : {near[i], solved_with_[i]}) {
                lower(solved_with_[i], solved_with_[other]);
                lower(solved_with_[other], solved_with_[i]);
            }
            if (all && present_[i]->features) lower(solved_with_[i], first_feature);
        }
    }
}

void Simulation::cut_strays(Worker& worker, std::span<Cloth* const> cloths, const Substep& substep) {
    FeatureContact& space = *together_;
    place_features(
        worker, space, cloths, [](const Cloth& cloth) { return cloth.substep_start.span(); }, substep.h);
    for (std::size_t k = 0; k < cloths.size(); ++k)
        space.arrive(worker.parallel, k, std::as_const(cloths[k]->state.positions).span());
    const FeatureCounts counts = space.cut(worker.parallel, touches_colliders(cloths));
    FeatureCounts& sum = cloths.front()->feature_counts;
    sum.truncated += counts.truncated;
    sum.overflowed |= counts.overflowed;
    if constexpr (looks_for_new_crossings) sum.crossed |= space.crosses_anew(worker.parallel);
    for (std::size_t k = 0; k < cloths.size(); ++k) hand_back(worker, space, k, *cloths[k], substep.h);
}

// Where it is made anew there is room for an eighth more, of such cloths as there are: so of n that are added
// one after the other few make it, and it is hardly larger than it has to be.
std::optional<Simulation::Together> Simulation::make_together(const Cloth* changed, const SelfCollision& of,
                                                              const ContactMesh* mesh) {
    std::vector<ContactCloth> bodies;
    cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        if (cloth.get() != changed && cloth->features)
            bodies.push_back(
                {.mesh = cloth->contact_mesh.get(), .by_zones = has_zones(cloth->settings.self_collision)});
    });
    if (mesh != nullptr) bodies.push_back({.mesh = mesh, .by_zones = has_zones(of)});
    if (bodies.size() < 2) return Together();
    if (together_ && together_->has_room_for(bodies)) return std::nullopt;
    bodies.reserve(bodies.size() + bodies.size() / 8);
    for (std::size_t k = 7, count = bodies.size(); k < count; k += 8) bodies.push_back(bodies[k]);
    return std::make_unique<FeatureContact>(bodies);
}

}  // namespace weft
