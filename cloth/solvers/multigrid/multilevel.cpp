#include "cloth/solvers/multigrid/multilevel.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "cloth/system/bodies/body_coupling.h"
#include "cloth/system/pair_rows.h"
#include "cloth/system/sparse/vectors.h"

namespace weft {

namespace {

double rest_area(const ClothModel& model) {
    double area = 0;
    for (const float a : model.rest_area.span()) area += static_cast<double>(a);
    return area;
}

}  // namespace

MultilevelSolver::MultilevelSolver(const ClothModel& model, const ClothSettings& settings,
                                   std::span<const Vec4> positions, SavedLevels* saved)
    : model_(&model),
      kind_(settings),
      system_(saved != nullptr && saved->springs
                  ? std::make_unique<SpringSystem>(model, std::move(*saved->springs))
                  : make_system(model, settings)),
      multigrid_(make_levels(model, *system_, saved)),
      vectors_(saved != nullptr ? CgVectors(model.particle_count, unmade) : CgVectors(model.particle_count)),
      sums_(block_count(model.particle_count)),
      rest_area_(rest_area(model)),
      residual_(model, settings) {
    multigrid_->set_pins(positions);
}

MultilevelSolver::MultilevelSolver(const MultilevelSolver& other, const ClothModel& model)
    : model_(&model),
      kind_(other.kind_),
      system_(other.system_->clone(model)),
      multigrid_(std::make_unique<Multigrid>(*other.multigrid_, *system_)),
      vectors_(model.particle_count),
      sums_(block_count(model.particle_count)),
      rest_area_(other.rest_area_),
      residual_(other.residual_, model) {}

bool MultilevelSolver::serves(const ClothSettings& settings) const {
    return std::holds_alternative<Multilevel>(settings.method) && SystemKind(settings) == kind_;
}

void MultilevelSolver::reserve_pins(std::size_t count) {
    multigrid_->reserve_pins(count);
}

void MultilevelSolver::inverse_mass_changed(std::uint32_t particle,
                                            std::span<const Vec4> positions) noexcept {
    if (positions[particle].w == 0)
        multigrid_->pin(particle);
    else
        multigrid_->unpin(particle);
}

void MultilevelSolver::inverse_masses_changed(std::span<const Vec4> positions) noexcept {
    multigrid_->set_pins(positions);
}

// About where inertia leads, x + gamma v: springs have turned there as far as they will in the step, which at
// the present positions they have not. One linearisation there is three times as accurate as Kang's on a
// hanging sheet.
void MultilevelSolver::linearise(const SolverStep& step) {
    system_->linearise(step.parallel, step.equation, step.velocities, LinearisedAbout::iterate);
}

void MultilevelSolver::build_levels(const SolverStep& step) {
    const auto timer = step.timed(Stage::coarse_operators);
    multigrid_->build(step.parallel, *system_, step.equation.pairs, step.equation.first);
}

void MultilevelSolver::cycle(const SolverStep& step, std::span<const Vec4> right_side, std::span<Vec4> x) {
    const auto timer = step.timed(Stage::cycles);
    multigrid_->cycle(step.parallel, *system_, right_side, x);
}

/// One solve of one or more cloths.
class MultilevelSolve {
  public:
    explicit MultilevelSolve(std::span<const MultilevelSolver::Member> members)
        : members_(members),
          step_(*members.front().step),
          pairs_(step_.equation.pairs),
          bodies_(step_.equation.bodies),
          method_(method_of(step_, pairs_, bodies_)),
          effort_(method_, mass_of(members), static_cast<double>(step_.equation.gamma),
                  pairs_ == nullptr && bodies_ == nullptr) {}

    SolveResult operator()();

  private:
    using Member = MultilevelSolver::Member;

    static double mass_of(std::span<const Member> members);
    static Multilevel method_of(const SolverStep& step, const PairRows* pairs, const BodyCoupling* bodies);
    /// The members as conjugate gradients see them.
    [[nodiscard]] auto parts() const {
        return members_ | std::views::transform([](const Member& member) {
                   return CgPart{*member.solver->system_, member.solver->vectors_, member.step->velocities};
               });
    }
    /// Takes a vector of each member over for the pairs; vector_of(member).
    template <class VectorOf>
    void give_pairs(const VectorOf& vector_of);
    void linearise_pairs();
    void linearise_bodies();
    void let_bodies_follow();
    double couple(bool wants_products);
    double couple_pairs(bool wants_products);
    double couple_bodies(bool wants_products);
    CgResult take_pass();
    /// If the last step went too far along direction_of(member), takes part of it back. residual_of(member)
    /// is the equation's where the step ended.
    template <class ResidualOf, class DirectionOf>
    bool shorten_last_step(const ResidualOf& residual_of, const DirectionOf& direction_of,
                           bool a_pass_follows);
    void go_back();
    void look_at_whole_way();
    void check_last_step();
    [[nodiscard]] bool is_free(std::uint32_t particle) const;
    [[nodiscard]] bool touches_what_is_held() const;
    void keep_momentum();

    std::span<const Member> members_;
    const SolverStep& step_;  // of the first: what all share is taken from it
    PairRows* pairs_;
    BodyCoupling* bodies_;
    Multilevel method_;
    Effort effort_;
};

double MultilevelSolve::mass_of(std::span<const Member> members) {
    double mass = 0;
    for (const Member& member : members)
        mass += member.solver->rest_area_ * static_cast<double>(member.step->settings.fabric.areal_density);
    return mass;
}

// A sheet that lies on a hammock comes to rest by four passes of two iterations, and by three of three goes
// on: which features touch is found with each linearisation. Where none do, three iterations calm stiff
// fabric that four passes of two leave trembling.
Multilevel MultilevelSolve::method_of(const SolverStep& step, const PairRows* pairs,
                                      const BodyCoupling* bodies) {
    Multilevel method = std::get<Multilevel>(step.settings.method);
    const bool features_touch = pairs != nullptr && !pairs->empty();
    if (step.in_one_pass && !features_touch && bodies == nullptr && method.effort > 1)
        return in_one_pass(method);
    if (features_touch && method.iterations > 1) {
        ++method.passes;
        --method.iterations;
    }
    return method;
}

template <class VectorOf>
void MultilevelSolve::give_pairs(const VectorOf& vector_of) {
    for (const Member& member : members_)
        pairs_->take(step_.parallel, member.step->equation.first, vector_of(member));
}

void MultilevelSolve::linearise_pairs() {
    if (pairs_ == nullptr || pairs_->empty()) return;
    give_pairs([](const Member& member) -> std::span<const Vec4> { return member.step->velocities; });
    pairs_->linearise(step_.parallel);
}

double MultilevelSolve::couple(bool wants_products) {
    return couple_pairs(wants_products) + couple_bodies(wants_products);
}

/// Once the cloths are.
void MultilevelSolve::linearise_bodies() {
    if (bodies_ == nullptr) return;
    for (std::size_t k = 0; k < members_.size(); ++k) bodies_->gather(k, members_[k].step->velocities);
    bodies_->eliminate();
    for (std::size_t k = 0; k < members_.size(); ++k)
        bodies_->add_to_right_side(k, members_[k].solver->system_->right_side().span());
}

/// Since velocities have changed.
void MultilevelSolve::let_bodies_follow() {
    if (bodies_ == nullptr) return;
    for (std::size_t k = 0; k < members_.size(); ++k) bodies_->look(k, members_[k].step->velocities);
    bodies_->follow();
}

double MultilevelSolve::couple_bodies(bool wants_products) {
    if (bodies_ == nullptr) return 0;
    for (std::size_t k = 0; k < members_.size(); ++k)
        bodies_->take(k, std::as_const(members_[k].solver->vectors_.direction).span());
    const double sum = bodies_->respond();
    for (std::size_t k = 0; k < members_.size(); ++k)
        if (wants_products) bodies_->give(k, members_[k].solver->vectors_.product.span());
    return sum;
}

double MultilevelSolve::couple_pairs(bool wants_products) {
    if (pairs_ == nullptr || pairs_->empty()) return 0;
    give_pairs([](const Member& member) { return std::as_const(member.solver->vectors_.direction).span(); });
    const double sum = pairs_->multiply(step_.parallel);
    for (const Member& member : members_)
        if (wants_products)
            pairs_->add_products(step_.parallel, member.step->equation.first,
                                 member.solver->vectors_.product.span());
    return sum;
}

// Newton's method as far as the passes go. The coarse operators are those of the first pass: the springs'
// directions, which change most, are the finest level's. All passes but the last need only be on the way, so
// one iteration each serves them.
//
// A direction's first product b . P b is the square of Newton's decrement (Deuflhard 2004, "Newton methods
// for nonlinear problems"): what energy is left, in a metric in which a stiff spring counts no more than a
// soft one. It is known for nothing. Where it grows from pass to pass, the last step went too far; where it
// is high after some passes, the equation is hard: all is solved anew by one linearisation, as Baraff and
// Witkin do, or, where there is no room for that, more passes follow.
SolveResult MultilevelSolve::operator()() {
    do {
        {
            const auto timer = step_.timed(Stage::assemble);
            linearise_pairs();
            if (!effort_.is_at_start()) let_bodies_follow();
            for (const Member& member : members_) {
                member.solver->linearise(*member.step);
                if (effort_.is_at_start()) member.solver->build_levels(*member.step);
            }
            linearise_bodies();
        }
        const auto timer = step_.timed(Stage::solve);
        const CgResult pass = take_pass();
        if (!pass.ok) return {.ok = false};
        effort_.add(pass);
        if (effort_.goes_back()) go_back();
    } while (effort_.wants_another_pass());
    if (effort_.is_whole()) look_at_whole_way();
    if (effort_.is_hard()) check_last_step();
    keep_momentum();
    let_bodies_follow();
    return {.unsolved = effort_.is_unsolved()};
}

CgResult MultilevelSolve::take_pass() {
    const auto precondition = [&](std::size_t k, std::span<const Vec4> r, std::span<Vec4> z) {
        members_[k].solver->cycle(*members_[k].step, r, z);
    };
    const auto iterations_for = [&](double decrement) {
        const bool went_too_far = effort_.has_grown(decrement) &&
                                  shorten_last_step(
                                      [](const Member& member) {
                                          return std::as_const(member.solver->system_->right_side()).span();
                                      },
                                      [](const Member& member) {
                                          return std::as_const(member.solver->vectors_.preconditioned).span();
                                      },
                                      true);
        return went_too_far ? 0 : effort_.iterations_for(decrement);
    };
    return conjugate_gradients(
        step_.parallel, parts(), effort_.most_iterations(), precondition,
        [&](bool wants_products) { return couple(wants_products); }, iterations_for);
}

// A line search along the last direction, by the equation's residual where the last step ended.
template <class ResidualOf, class DirectionOf>
bool MultilevelSolve::shorten_last_step(const ResidualOf& residual_of, const DirectionOf& direction_of,
                                        bool a_pass_follows) {
    double slope = 0;
    for (const Member& member : members_)
        slope += dot(step_.parallel, residual_of(member), direction_of(member), member.solver->sums_.span());
    const float back = effort_.step_back(slope, a_pass_follows);
    if (back == 0) return false;
    for (const Member& member : members_)
        scale_and_add(step_.parallel, -back, direction_of(member), 1.0f, member.step->velocities);
    return true;
}

void MultilevelSolve::go_back() {
    for (const Member& member : members_)
        copy(step_.parallel, member.step->equation.velocities, member.step->velocities);
}

// The line search then is along all that the solve has changed.
void MultilevelSolve::look_at_whole_way() {
    double slope = 0;
    for (const Member& member : members_) {
        const std::span<Vec4> way = member.solver->vectors_.direction.span();
        copy(step_.parallel, member.step->velocities, way);
        scale_and_add(step_.parallel, -1.0f, member.step->equation.velocities, 1.0f, way);
        slope += dot(step_.parallel, std::as_const(member.solver->system_->right_side()).span(), way,
                     member.solver->sums_.span());
    }
    effort_.look_at_whole_way(slope);
}

// No pass follows that would see where the last one went.
void MultilevelSolve::check_last_step() {
    constexpr int most = 3;
    const auto timer = step_.timed(Stage::solve);
    for (int k = 0; k < most; ++k) {
        linearise_pairs();
        let_bodies_follow();
        for (const Member& member : members_) {
            const StepEquation& equation = member.step->equation;
            if (pairs_ != nullptr) equation.contacts->renew_pairs(step_.parallel);
            member.solver->system_->residual(step_.parallel, equation, member.step->velocities,
                                             member.solver->vectors_.residual.span());
        }
        if (!shorten_last_step(
                [](const Member& member) { return std::as_const(member.solver->vectors_.residual).span(); },
                [](const Member& member) { return std::as_const(member.solver->vectors_.direction).span(); },
                false))
            return;
    }
}

/// A particle of the pairs, which may be of no member: then it is where it will be.
bool MultilevelSolve::is_free(std::uint32_t particle) const {
    return std::ranges::any_of(members_, [&](const Member& member) {
        const StepEquation& equation = member.step->equation;
        const std::uint32_t i = particle - equation.first;
        return i < equation.positions.size() && equation.positions[i].w > 0;
    });
}

/// Such a piece has no row of its own where all of it is held.
bool MultilevelSolve::touches_what_is_held() const {
    bool any = false;
    pairs_->for_each_active([&](const PairRows::ActivePair& active) {
        any = any || !std::ranges::all_of(active.pair.corners, [&](std::uint32_t i) { return is_free(i); });
    });
    return any;
}

// What nothing holds keeps its momentum but for gravity and air, whatever its features do to each other; few
// iterations leave a part of that unsolved. All pieces that touch are as one.
void MultilevelSolve::keep_momentum() {
    if (pairs_ == nullptr) return;
    MultilevelSolver::Piece touching;
    for (const Member& member : members_) {
        member.solver->weigh_pieces(*member.step);
        for (const MultilevelSolver::Piece& piece : member.solver->pieces_) {
            if (!piece.touches) continue;
            touching.is_held |= piece.is_held;
            touching.missing += piece.missing;
            touching.inertia += piece.inertia;
        }
    }
    touching.is_held = touching.is_held || touches_what_is_held();
    for (const Member& member : members_)
        member.solver->move_free_pieces(*member.step, MultilevelSolver::shift_of(touching));
}

SolveResult MultilevelSolver::solve(const SolverStep& step) {
    const Member member{this, &step};
    float residual = 0;
    return solve(std::span(&member, 1), std::span(&residual, 1));
}

SolveResult MultilevelSolver::solve(std::span<const Member> members, std::span<float> residuals) {
    for (const Member& member : members)
        copy(member.step->parallel, member.step->equation.velocities, member.step->velocities);
    SolveResult result = MultilevelSolve(members)();
    for (std::size_t k = 0; k < residuals.size(); ++k) {
        MultilevelSolver& solver = *members[k].solver;
        residuals[k] = solver.residual_(*members[k].step, solver.system_.get());
    }
    if (!residuals.empty()) result.residual = *std::ranges::max_element(residuals);
    return result;
}

std::span<const Vec4> MultilevelSolver::left_to_contact(const SolverStep& step) {
    StepEquation without = step.equation;
    without.contacts = nullptr;
    without.pairs = nullptr;
    system_->residual(step.parallel, without, step.velocities, vectors_.residual.span());
    return std::as_const(vectors_.residual).span();
}

std::size_t MultilevelSolver::bytes() const noexcept {
    return system_->bytes() + multigrid_->bytes() + vectors_.bytes() + sums_.bytes() + residual_.bytes() +
           component_of_.size() * sizeof(std::uint32_t) + pieces_.size() * sizeof(Piece);
}

}  // namespace weft
