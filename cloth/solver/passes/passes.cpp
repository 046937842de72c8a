#include "cloth/solver/passes/passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "cloth/bodies/body_coupling.h"
#include "cloth/equation/pairs/pair_rows.h"
#include "cloth/equation/sparse/vectors.h"
#include "cloth/solver/passes/along_fillings.h"
#include "cloth/solver/passes/along_seams.h"
#include "cloth/solver/passes/small_system.h"

namespace weft {

namespace {

/// The factor of four rows; w stays.
FourRows four_rows_of(double factor) {
    const auto by = static_cast<float>(factor);
    return Eigen::Array4f(by, by, by, 0).replicate<1, 4>();
}

/// Sums over a block: velocities and number of the pinned particles; momenta and mass of the others.
VelocitySums sum_velocities(std::span<const Vec4> positions, const Vec4* velocities,
                            const BlockRange& range) {
    FourRows pinned = FourRows::Zero(), moving = FourRows::Zero();
    for (std::uint32_t i = range.begin; i < range.end; i += 4) {
        FourRows v = load_four(velocities + i);
        v.row(3).setOnes();
        const Eigen::Array<float, 1, 4> w = load_four(&positions[i]).row(3);
        const Eigen::Array<float, 1, 4> is_free = (w != 0).cast<float>();
        const Eigen::Array<float, 1, 4> mass = is_free / (w + (1 - is_free));
        pinned += v.rowwise() * (1 - is_free);
        moving += v.rowwise() * mass;
    }
    VelocitySums sums;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        sums.pinned[k] = pinned.row(row).cast<double>().sum();
        sums.moving[k] = moving.row(row).cast<double>().sum();
    }
    sums.pinned[3] -= (4 - range.end % 4) % 4;  // padding rows are no pins
    return sums;
}

/// The solve of one substep.
class Passes {
  public:
    explicit Passes(std::span<const PassMember> members)
        : members_(members),
          first_(members.front().step),
          parallel_(first_.parallel),
          pairs_(pairs_of(members)),
          bodies_(first_.equation.bodies) {}

    SolveResult operator()();

  private:
    using Vector = ScratchArray<Vec4> PassVectors::*;

    /// The pairs of members that have features; null if no features touch.
    [[nodiscard]] static PairRows* pairs_of(std::span<const PassMember> members);
    [[nodiscard]] bool has_pairs(const PassMember& member) const {
        return pairs_ != nullptr && member.step.equation.pairs != nullptr;
    }
    /// work(member, threads): many members run side by side, few one after the other with all threads.
    template <class Work>
    void for_each_member(const Work& work);
    /// Energy of the change of velocity v of all mass [J], times two.
    [[nodiscard]] double energy_of(double v) const;
    void begin();
    [[nodiscard]] Vec4 frame_velocity() const;
    void linearise();
    void list_for_levels();
    void eliminate_bodies();
    void let_bodies_follow();
    /// Minimises the linearised step over v, the last change and, if it is wanted, a cycle's correction.
    bool minimise(bool with_correction);
    /// Does so again with another cycle, about the same iterate: a step of conjugate gradients.
    bool minimise_further();
    void subtract(const Coefficients& c);
    bool correct();
    void subtract_last_step();
    void find_corrections();
    /// product = W x of all members, unless `product` is null. with(member): what x is dotted with.
    template <class With>
    Products multiply(Vector x, Vector product, const With& with);
    double couple(Vector x, Vector product);
    /// Moves along the directions. Returns false, and does nothing, if a coefficient is not finite.
    bool move(const Coefficients& c);
    [[nodiscard]] bool touches_what_is_held() const;
    void keep_momentum();

    std::span<const PassMember> members_;
    const SolverStep& first_;  // read for what is common to all members
    Parallel& parallel_;
    PairRows* pairs_;  // null: no features touch
    BodyCoupling* bodies_;
    Vec4 frame_{};               // velocity that `motion` is relative to
    int passes_ = 0;             // passes taken so far
    SmallSystem small_;          // of the last cycle
    Coefficients subtracted_{};  // of the last step, what the right side is without
    Coefficients last_{};        // the last step
    double left_ = 0;            // energy that the last cycle found beyond its first two directions [J]
};

}  // namespace

// The energy that is left, b . P b, is the square of Newton's decrement (Deuflhard 2004, "Newton methods for
// nonlinear problems"): a metric in which a stiff spring counts no more than a soft one. Where much is left,
// up to two more passes are taken than asked for, and up to eight where more is left than tolerated, since
// BDF2 extrapolates a third of what a step leaves: flags in high wind were slow, and limp cloth that crumples
// in a vacuum gained energy without end. Where what is left is no small part of the motion, the last pass
// has further cycles: the error of slow cloth lags behind it, and corners flapped for ever. After the last
// pass the springs have turned, so r . v = 0 holds in its linearisation only; where much is left, one more
// minimisation without a cycle restores it.
SolveResult Passes::operator()() {
    constexpr double much = 0.02;    // of the tolerated energy: 5 to 6 m/s^2 by default
    constexpr double small = 0.01;   // of the motion's energy: a tenth of its velocity
    constexpr double still = 1e-4;   // [m/s], rms over the mass: smaller errors are not seen
    constexpr int most_further = 4;  // cycles
    const Multilevel& method = std::get<Multilevel>(first_.settings.method);
    const double tolerated =
        energy_of(static_cast<double>(method.tolerance) * static_cast<double>(first_.equation.gamma));
    const auto much_is_left = [&] { return left_ > much * tolerated; };
    const auto more = [&] { return left_ > tolerated ? 8 : much_is_left() ? 2 : 0; };
    const double unseen = energy_of(still);
    begin();
    while (passes_ < method.passes + more()) {
        linearise();
        if (!minimise(true)) return {.ok = false};
        ++passes_;
    }
    for (int k = 0; k < most_further && left_ > small * small_.g[motion][motion] + unseen; ++k)
        if (!minimise_further()) return {.ok = false};
    if (much_is_left()) {
        linearise();
        if (!minimise(false)) return {.ok = false};
    }
    keep_momentum();
    for_each_member(follow_filling);
    let_bodies_follow();
    return {.unsolved = left_ > tolerated};
}

template <class Work>
void Passes::for_each_member(const Work& work) {
    const auto count = static_cast<std::uint32_t>(members_.size()),
               threads = static_cast<std::uint32_t>(parallel_.width());
    if (count >= 2 * threads)
        parallel_.blocks(count, [&](std::uint32_t k) {
            Parallel alone(1);
            work(members_[k], alone);
        });
    else
        for (std::uint32_t k = 0; k < count; ++k) work(members_[k], parallel_);
}

PairRows* Passes::pairs_of(std::span<const PassMember> members) {
    for (const PassMember& member : members)
        if (PairRows* const pairs = member.step.equation.pairs; pairs != nullptr)
            return pairs->empty() ? nullptr : pairs;
    return nullptr;
}

double Passes::energy_of(double v) const {
    double mass = 0;
    for (const PassMember& member : members_) mass += member.mass;
    return mass * v * v;
}

void Passes::begin() {
    frame_ = frame_velocity();
    for_each_member([&](const PassMember& member, Parallel& threads) {
        copy(threads, member.step.equation.velocities, member.step.velocities);
        write_motion(member, threads, frame_);
    });
}

/// The mean velocity of pinned particles, or else of all mass: the direction `motion` is relative to it.
Vec4 Passes::frame_velocity() const {
    VelocitySums all;
    for (const PassMember& member : members_) {
        const StepEquation& equation = member.step.equation;
        all = parallel_.reduce(
            static_cast<std::uint32_t>(equation.positions.size()), member.vectors.partials.span(), all,
            [&](const BlockRange& range) {
                return sum_velocities(equation.positions, equation.velocities.data(), range);
            },
            std::plus<>{});
    }
    const auto& [x, y, z, weight] = all.pinned[3] > 0 ? all.pinned : all.moving;
    if (!(weight > 0)) return {};
    return {static_cast<float>(x / weight), static_cast<float>(y / weight), static_cast<float>(z / weight),
            0};
}

void Passes::linearise() {
    const bool is_first = passes_ == 0;
    const auto timer = first_.timed(Stage::assemble);
    if (pairs_ != nullptr) {
        for (const PassMember& member : members_)
            if (has_pairs(member))
                pairs_->take(parallel_, member.step.equation.first, member.step.velocities);
        pairs_->linearise(parallel_);
    }
    linearise_seams(members_);
    if (is_first)
        list_for_levels();
    else
        let_bodies_follow();
    for_each_member([&](const PassMember& member, Parallel& threads) {
        if (is_first)
            linearise_filling(member, threads);
        else
            member.step.air.linearise(threads, member.step.velocities);
        member.system.linearise(threads, member.step.equation, member.step.velocities,
                                LinearisedAbout::iterate);
    });
    if (is_first)
        for_each_member([&](const PassMember& member, Parallel& threads) {
            if (!member.levels.is_led_by(member.part)) return;
            const auto levels_timer = member.step.timed(Stage::coarse_operators);
            member.levels.build(threads);
        });
    for (const PassMember& member : members_) {
        if (is_first) member.vectors.begin_later();
        find_response(members_, member, frame_, !is_first);
    }
    eliminate_bodies();
}

void Passes::list_for_levels() {
    for (const PassMember& member : members_) member.levels.leave();
    for (const PassMember& member : members_)
        member.levels.enter(member.part, member.system, member.step.equation);
    for (const PassMember& member : members_) {
        if (!member.levels.is_led_by(member.part)) continue;
        member.levels.see_pins();
        member.levels.list_pairs(pairs_);
    }
}

void Passes::eliminate_bodies() {
    if (bodies_ == nullptr) return;
    for (std::size_t k = 0; k < members_.size(); ++k) bodies_->gather(k, members_[k].step.velocities);
    bodies_->eliminate();
    for (std::size_t k = 0; k < members_.size(); ++k)
        bodies_->add_to_right_side(k, members_[k].system.right_side().span());
}

/// Call this whenever velocities have changed.
void Passes::let_bodies_follow() {
    if (bodies_ == nullptr) return;
    for (std::size_t k = 0; k < members_.size(); ++k) bodies_->look(k, members_[k].step.velocities);
    bodies_->follow();
}

bool Passes::minimise(bool with_correction) {
    const auto timer = first_.timed(Stage::solve);
    const bool has_change = passes_ > 0;
    small_ = {};
    const auto right_side = [](const PassMember& member) { return member.system.right_side().data(); };
    const Products of_motion =
        multiply(&PassVectors::motion, &PassVectors::of_motion,
                 [&](const PassMember& member) -> DottedWith { return {right_side(member)}; });
    small_.b[motion] = of_motion.dots[0];
    small_.g[motion][motion] = of_motion.x_wx;
    if (has_change) {
        const Products of_change = multiply(&PassVectors::change, &PassVectors::of_change,
                                            [&](const PassMember& member) -> DottedWith {
                                                return {right_side(member), member.vectors.of_motion.data()};
                                            });
        small_.b[change] = of_change.dots[0];
        small_.g[motion][change] = of_change.dots[1];
        small_.g[change][change] = of_change.x_wx;
    }
    const Coefficients c = least_energy(small_);
    if (!with_correction) return move(c);
    subtract(c);
    return correct();
}

bool Passes::minimise_further() {
    const auto timer = first_.timed(Stage::solve);
    subtract_last_step();
    return correct();
}

/// b -= W times the step along these directions; w stays.
void Passes::subtract(const Coefficients& c) {
    const FourRows of_motion = four_rows_of(c[motion]), of_change = four_rows_of(c[change]);
    for_each_member([&](const PassMember& member, Parallel& threads) {
        const PassVectors& of = member.vectors;
        Vec4* const b = member.system.right_side().data();
        fill_fours(threads, member.system.right_side().span(), [&](std::uint32_t i) -> FourRows {
            FourRows left = load_four(b + i) - of_motion * load_four(&of.of_motion[i]);
            if (c[change] != 0) left -= of_change * load_four(&of.of_change[i]);
            return left;
        });
    });
    subtracted_ = c;
}

/// Finds a cycle's correction of what the right side has left, and moves by the step of least energy.
bool Passes::correct() {
    find_corrections();
    const Products of_correction = multiply(
        &PassVectors::correction, &PassVectors::of_correction, [&](const PassMember& member) -> DottedWith {
            return {member.system.right_side().data(), member.vectors.of_motion.data(),
                    small_.g[change][change] > 0 ? member.vectors.of_change.data() : nullptr};
        });
    left_ = of_correction.dots[0];
    small_.g[correction] = {of_correction.dots[2], of_correction.dots[1], of_correction.x_wx};
    small_.b[correction] =
        left_ + subtracted_[motion] * of_correction.dots[1] + subtracted_[change] * of_correction.dots[2];
    return std::isfinite(left_) && move(least_energy(small_));
}

// The residual of the last step is orthogonal to motion and change.
void Passes::subtract_last_step() {
    const Coefficients& c = last_;
    small_ = after_step(small_, c);

    const FourRows by_motion = four_rows_of(c[motion]), by_change = four_rows_of(c[change]),
                   by_correction = four_rows_of(c[correction]),
                   less_motion = four_rows_of(c[motion] - subtracted_[motion]),
                   less_change = four_rows_of(c[change] - subtracted_[change]);
    for_each_member([&](const PassMember& member, Parallel& threads) {
        PassVectors& of = member.vectors;
        Vec4* const b = member.system.right_side().data();
        fill_fours(threads, member.system.right_side().span(), [&](std::uint32_t i) -> FourRows {
            const FourRows of_motion = load_four(&of.of_motion[i]),
                           of_correction = by_correction * load_four(&of.of_correction[i]);
            FourRows left = load_four(b + i) - less_motion * of_motion - of_correction;
            FourRows more = by_motion * of_motion + of_correction;
            if (c[change] != 0) {
                const FourRows of_change = load_four(&of.of_change[i]);
                left -= less_change * of_change;
                more += by_change * of_change;
            }
            store_four(more, &of.of_change[i]);
            store_four(of_motion + more, &of.of_motion[i]);
            return left;
        });
    });
    subtracted_ = {};
}

void Passes::find_corrections() {
    for (const PassMember& member : members_)
        member.levels.set_vectors(member.part, std::as_const(member.system).right_side().span(),
                                  member.vectors.correction.span());
    for_each_member([&](const PassMember& member, Parallel& threads) {
        if (!member.levels.is_led_by(member.part)) return;
        const auto timer = member.step.timed(Stage::cycles);
        member.levels.cycle(threads);
    });
    for (const PassMember& member : members_) relieve(member, parallel_, member.vectors.correction.span());
}

template <class With>
Products Passes::multiply(Vector x, Vector product, const With& with) {
    for_each_member([&](const PassMember& member, Parallel& threads) {
        const std::span<const Vec4> of = std::as_const(member.vectors.*x).span();
        const std::span<Vec4> to = product != nullptr ? (member.vectors.*product).span() : std::span<Vec4>();
        member.vectors.products = member.system.multiply_coupled(threads, with(member), of, to);
        member.vectors.products.x_wx += multiply_filling(member, threads, of, to);
    });
    Products sum;
    for (const PassMember& member : members_) sum = sum + member.vectors.products;
    sum.x_wx += couple(x, product);
    return sum;
}

/// Adds the terms of seams, features and bodies to the product, unless it is null. Returns their dot product
/// with x.
double Passes::couple(Vector x, Vector product) {
    double sum = multiply_seams(members_, x, product);
    if (pairs_ != nullptr) {
        for (const PassMember& member : members_)
            if (has_pairs(member))
                pairs_->take(parallel_, member.step.equation.first, std::as_const(member.vectors.*x).span());
        sum += pairs_->multiply(parallel_);
    }
    if (bodies_ != nullptr) {
        for (std::size_t k = 0; k < members_.size(); ++k)
            bodies_->take(k, std::as_const(members_[k].vectors.*x).span());
        sum += bodies_->respond();
    }
    if (product == nullptr) return sum;
    for (std::size_t k = 0; k < members_.size(); ++k) {
        const std::span<Vec4> of = (members_[k].vectors.*product).span();
        if (has_pairs(members_[k])) pairs_->add_products(parallel_, members_[k].step.equation.first, of);
        if (bodies_ != nullptr) bodies_->give(k, of);
    }
    return sum;
}

bool Passes::move(const Coefficients& c) {
    if (!std::isfinite(c[motion] + c[change] + c[correction])) return false;
    const FourRows by_motion = four_rows_of(c[motion]), by_change = four_rows_of(c[change]),
                   by_correction = four_rows_of(c[correction]);
    for_each_member([&](const PassMember& member, Parallel& threads) {
        PassVectors& of = member.vectors;
        Vec4* const v = member.step.velocities.data();
        fill_fours(threads, member.step.velocities, [&](std::uint32_t i) -> FourRows {
            const FourRows before = load_four(&of.motion[i]);
            FourRows more = by_motion * before;
            if (c[change] != 0) more += by_change * load_four(&of.change[i]);
            if (c[correction] != 0) more += by_correction * load_four(&of.correction[i]);
            store_four(more, &of.change[i]);
            store_four(before + more, &of.motion[i]);
            return load_four(v + i) + more;
        });
        follow_filling(member, threads);
    });
    last_ = c;
    return true;
}

/// Whether a stitch, or a pair that pushes, has a corner that is not free: a piece held in whole shows up
/// only so.
bool Passes::touches_what_is_held() const {
    bool any = join_what_is_held(members_);
    if (any || pairs_ == nullptr) return any;
    const auto is_free = [&](std::uint32_t particle) {
        return std::ranges::any_of(members_, [&](const PassMember& member) {
            const StepEquation& equation = member.step.equation;
            const std::uint32_t i = particle - equation.first;
            return equation.pairs != nullptr && i < equation.positions.size() && equation.positions[i].w > 0;
        });
    };
    pairs_->for_each_active([&](const PairRows::ActivePair& active) {
        any = any || !std::ranges::all_of(active.pair.corners, is_free);
    });
    return any;
}

// Free pieces keep their momentum but for gravity and air, whatever their features do to one another. All
// pieces that touch or are joined count as one.
void Passes::keep_momentum() {
    const Vector3 origin = xyz(first_.equation.base_positions[0]);
    PieceSums touching;
    bool is_held = false;
    for (const PassMember& member : members_) {
        member.pieces.weigh(member.step.equation, member.step.velocities, origin);
        is_held |= member.pieces.add_touching(touching);
    }
    is_held = is_held || touches_what_is_held();
    const RigidChange of_touching = is_held ? RigidChange() : RigidChange(touching, first_.equation.gamma);
    for (const PassMember& member : members_)
        member.pieces.move(member.step.equation, of_touching, origin, member.step.velocities);
}

void write_motion(const PassMember& member, Parallel& threads, const Vec4& frame) {
    const std::span<const Vec4> positions = member.step.equation.positions;
    const std::span<const Vec4> velocities = member.step.velocities;
    const FourRows of_frame = load(frame).array().replicate<1, 4>();
    fill_fours(threads, member.vectors.motion.span(), [&](std::uint32_t i) -> FourRows {
        const Eigen::Array<float, 1, 4> is_free = (load_four(&positions[i]).row(3) != 0).cast<float>();
        FourRows motion = (load_four(&velocities[i]) - of_frame).rowwise() * is_free;
        motion.row(3).setZero();
        return motion;
    });
}

SolveResult solve_by_passes(std::span<const PassMember> members, std::span<float> residuals) {
    SolveResult result = Passes(members)();
    for (std::size_t k = 0; k < residuals.size(); ++k)
        residuals[k] = members[k].residual(members[k].step, &members[k].system);
    if (!residuals.empty()) result.residual = *std::ranges::max_element(residuals);
    return result;
}

}  // namespace weft
