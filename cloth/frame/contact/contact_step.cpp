// The part of the frame that features have: which cloths may touch, what is near what, and motion that lets
// nothing through.

#include <algorithm>
#include <limits>
#include <utility>

#include "cloth/frame/advance/advance.h"
#include "cloth/frame/simulation.h"

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
    if (!cloth.has_features()) return box.grown_by(0);
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

/// The box around where the cloth was in the substep.
Bounds swept_box(const Cloth& cloth) {
    GrowingBox box;
    if (!cloth.has_features()) return box.grown_by(0);
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        box.add(xyz(cloth.substep_start[i]));
        box.add(xyz(cloth.state.positions[i]));
    }
    return box.grown_by(cloth.as_body().floor);
}

bool touches_colliders(std::span<Cloth* const> cloths) {
    return std::ranges::any_of(
        cloths, [](const Cloth* cloth) { return cloth->collider_contacts > 0 || cloth->worn.is_holding(); });
}

/// Writes what particles remember of tangles back, unless neither was nor is any: calm cloth costs nothing.
void remember_tangles(FeatureContact& space, std::size_t body, ClothState& state) {
    if (state.may_cross == 0 && !space.may_cross()) return;
    std::ranges::copy(space.memory(body), state.tangles.data());
    state.may_cross = space.may_cross() ? 1 : 0;
}

}  // namespace

// Cloths are solved together whose boxes over the substep overlap, or that may meet the same body.
void Simulation::meet(const Substep& substep) {
    boxes_.clear();
    for (Cloth* cloth : present_) {
        boxes_.push_back(predicted_box(*cloth, to_vector(settings.gravity), substep.h));
        if (cloth->has_features())
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
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        const Cloth& cloth = *cloths[k];
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
    if (!space.uses_zones()) space.detect(worker.parallel, cloths.front()->is_in_crowd);
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
        for (const Schedule::Group& group : islands_.groups()) {
            all.scratch = scratch_.data() + group.scratch;
            cut_strays(all, group.cloths, substep);
        }
    }
}

/// Joins what was solved together with what has come near each other since; or all that has features.
void Simulation::join_solved(bool all) {
    const std::span<const std::uint32_t> near = finder_.first_of();
    const auto first_feature = static_cast<std::uint32_t>(
        std::ranges::find_if(present_, [](const Cloth* cloth) { return cloth->has_features(); }) -
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
            if (all && present_[i]->has_features()) lower(solved_with_[i], first_feature);
        }
    }
}

void Simulation::cut_strays(Worker& worker, std::span<Cloth* const> near, const Substep& substep) {
    Scratch scratch(worker.scratch);
    Group group;
    group.lay_out(scratch, near.size());
    group.add_featured(near);
    const std::span<Cloth* const> cloths = group.all_featured();
    if (cloths.size() < 2) return;
    FeatureContact& space = group.contact;
    space.lay_out(scratch, group.all_bodies(), zones_.get());
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

}  // namespace weft
