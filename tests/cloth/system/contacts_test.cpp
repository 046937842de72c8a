// Colliders as forces in the implicit step.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "cloth/equation/contacts.h"
#include "cloth/methods/linear/jacobi.h"
#include "cloth/methods/linear/mean_motion.h"
#include "cloth/solver/levels/multigrid.h"
#include "cloth/solver/make_system.h"
#include "dense_algebra.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

/// A crumpled cloth that lies half in a floor which rises, and slides on it.
struct LyingCloth {
    explicit LyingCloth(bool elements = false)
        : cloth(crumpled(sheet(6, 7), 0.04f, 60.0f)),
          contacts(cloth.model.particle_count),
          held(cloth.model.particle_count) {
        if (elements) {
            ClothSettings settings = cloth.settings;
            settings.finite_elements = {.enabled = true};
            settings.fabric.warp = 60;
            settings.fabric.weft = 40;
            cloth.apply(settings);
        }
        cloth.pin(1);
        cloth.pin(9);
        float middle = 0;
        for (const Vec4& x : cloth.state.positions.span())
            middle += x.y / static_cast<float>(cloth.model.particle_count);
        const auto floor = [&](float y) {
            return Collider{.shape = Plane{{0.1f, 1, 0}, middle + y}, .friction = 0.7f};
        };
        motions = {{floor(0), floor(0.002f)}};
    }
    StepEquation equation() {
        StepEquation result = equation_of(cloth, h);
        result.contacts = &contacts;
        contacts.begin(motions, cloth.side(), held);
        return result;
    }
    [[nodiscard]] std::uint32_t touching() const {
        return static_cast<std::uint32_t>(std::ranges::count_if(
            held.normals.span(), [](const Vec4& n) { return xyz(n).squaredNorm() > 0; }));
    }
    /// How hard particles press is known from a step before, which made them `faster` times as fast.
    void press(float faster = 1) {
        Parallel serial(1);
        const auto system = make_system(cloth.model, cloth.settings);
        const StepEquation present = equation();
        system->linearise(serial, present, cloth.state.velocities.span(), LinearisedAbout::base);
        AlignedBuffer<Vec4> velocities(cloth.model.particle_count);
        for (std::uint32_t i = 0; i < velocities.size(); ++i)
            set_xyz(velocities[i], faster * xyz(cloth.state.velocities[i]));
        contacts.finish(serial, present, velocities.span());
    }

    Cloth cloth;
    Contacts contacts;
    HeldContacts held;
    std::vector<ColliderMotion> motions;
};

/// The stated law, one particle at a time, in double precision.
struct Law {
    Eigen::Matrix3d g = Eigen::Matrix3d::Zero();
    Eigen::Vector3d at_velocity = Eigen::Vector3d::Zero();  // c - G v
    bool corrected_twice = false;
};
Law law_of(const LyingCloth& lying, std::uint32_t i, double stored, const Vec4& kept, double took,
           double gravity_fall) {
    const double load = static_cast<double>(kept.w);
    const Plane start = std::get<Plane>(lying.motions[0].start.shape),
                end = std::get<Plane>(lying.motions[0].end.shape);
    const Eigen::Vector3d n = to_vector(end.normal).cast<double>().normalized();
    const Eigen::Vector3d x = xyz(lying.cloth.state.positions[i]).cast<double>(),
                          v = xyz(lying.cloth.state.velocities[i]).cast<double>();
    const double w = static_cast<double>(lying.cloth.state.positions[i].w), step = static_cast<double>(h);
    const double thickness = static_cast<double>(lying.cloth.settings.thickness);
    double gap = n.dot(x + step * v) - static_cast<double>(end.offset) - thickness;
    const double found = static_cast<double>(start.offset) + thickness - n.dot(x), least = 0.1 * step;
    if (gap < -least && found > least) gap += found;  // where it began, it may stay
    const double stretch = static_cast<double>(lying.cloth.settings.fabric.warp);
    const double spring = 50 / w + 0.005 * step * step * stretch;
    const double near = gap;
    gap -= step * load / spring;
    Law law;
    const bool presses = gap + gravity_fall * n.y() < 0 || (stored > 0 && near < 4e-3);
    if (w == 0 || !presses) return law;
    const double impulse = spring / step * (stored > 0 ? -gap : std::max(0.0, -gap));
    const double limit = static_cast<double>(lying.cloth.settings.friction) * 0.7 *
                         (stored + std::max(stored - load, 0.0) / (w * spring));
    const Eigen::Vector3d surface = n * static_cast<double>(end.offset - start.offset) / step;
    const Eigen::Vector3d sliding = (Eigen::Matrix3d::Identity() - n * n.transpose()) * (v - surface);
    const Eigen::Vector3d kept_friction = xyz(kept).cast<double>();
    const Eigen::Vector3d sticking = kept_friction - n.dot(kept_friction) * n - 10 * spring * sliding;
    double share = 1;
    if (limit < sticking.norm()) {
        law.corrected_twice = took > limit;
        share = limit / sticking.norm() * (law.corrected_twice ? std::max(limit / took, 0.25) : 1.0);
    }
    const double damper = 10 * spring * share;
    law.g = damper * Eigen::Matrix3d::Identity() + (spring - damper) * n * n.transpose();
    law.at_velocity = impulse * n + share * sticking;
    return law;
}

TEST(Contacts, RowsAreThoseOfTheLaw) {
    for (const LinearisedAbout about : {LinearisedAbout::base, LinearisedAbout::iterate}) {
        for (const bool pressed_before : {false, true}) {
            SCOPED_TRACE(pressed_before);
            LyingCloth lying;
            if (pressed_before) {
                lying.press();
                lying.press(2.5f);  // so that the damper takes more than the limit
            }
            const AlignedBuffer<Vec4>& velocities = lying.cloth.state.velocities;
            std::vector<double> stored, took(velocities.size(), 0.0);
            const std::vector<Vec4> loads(lying.held.loads.span().begin(), lying.held.loads.span().end());
            for (const Vec4& normal : lying.held.normals.span())
                stored.push_back(static_cast<double>(normal.w));
            for (std::uint32_t i = 0; pressed_before && i < took.size(); ++i)
                if (stored[i] > 0) took[i] = static_cast<double>(lying.held.rubbed[i]);

            Parallel serial(1);
            const auto system = make_system(lying.cloth.model, lying.cloth.settings);
            system->linearise(serial, lying.equation(), velocities.span(), about);
            const ContactRows& rows = lying.contacts.rows();
            int in_contact = 0, sticking = 0, corrected_twice = 0;
            for (std::uint32_t i = 0; i < lying.cloth.model.particle_count; ++i) {
                const Law law = law_of(lying, i, stored[i], loads[i], took[i], -9.81 / 3600);
                const Eigen::Matrix3d g = rows.touches(i) ? rows.block(i).full() : Eigen::Matrix3d::Zero();
                Eigen::Vector3d c = Eigen::Vector3d::Zero();
                if (rows.touches(i)) c = xyz(rows.impulses[i]).cast<double>();
                const Eigen::Vector3d v = xyz(velocities[i]).cast<double>();
                const double size = law.g.norm() * v.norm() + law.at_velocity.norm() + 1e-12;
                EXPECT_LT((g - law.g).norm(), 1e-5 * law.g.norm() + 1e-12) << i;
                EXPECT_LT((c - g * v - law.at_velocity).norm(), 1e-4 * size) << i;
                in_contact += law.g.norm() > 0 ? 1 : 0;
                sticking += law.g.determinant() > 0 ? 1 : 0;
                corrected_twice += law.corrected_twice ? 1 : 0;
            }
            EXPECT_GT(in_contact, 8);
            EXPECT_EQ(sticking > 0, pressed_before);
            EXPECT_EQ(corrected_twice > 0, pressed_before);
        }
    }
}

TEST(Contacts, FarFromCollidersThereAreNone) {
    LyingCloth lying;
    const Collider far{.shape = Plane{{0, 1, 0}, -9}};
    lying.motions = {{far, far}};
    Parallel serial(1);
    const auto system = make_system(lying.cloth.model, lying.cloth.settings);
    system->linearise(serial, lying.equation(), lying.cloth.state.velocities.span(), LinearisedAbout::base);
    EXPECT_EQ(lying.touching(), 0u);
}

TEST(Contacts, SystemIsSymmetricAndItsDiagonalServesRelaxation) {
    for (const bool elements : {false, true}) {
        LyingCloth lying(elements);
        lying.press();
        Parallel serial(1);
        const auto system = make_system(lying.cloth.model, lying.cloth.settings);
        system->linearise(serial, lying.equation(), lying.cloth.state.velocities.span(),
                          LinearisedAbout::iterate);
        const Eigen::MatrixXd w = dense(*system).matrix;
        EXPECT_LT((w - w.transpose()).norm(), 1e-5 * w.norm());
        EXPECT_GT(eigenvalues(w)(0), 0);
        // 2 D - W is positive definite.
        const Eigen::MatrixXd inverse = dense_preconditioner(*system);
        EXPECT_EQ(inverse, inverse.transpose());
        EXPECT_LT(largest_eigenvalue_of_product(inverse, w), elements ? 2.01 : 2.0);
    }
}

TEST(Contacts, HoldCoarseNodesByTheirShareOfParticles) {
    LyingCloth lying;
    lying.press();
    Parallel serial(1);
    const auto system = make_system(lying.cloth.model, lying.cloth.settings);
    const auto linearise = [&](const StepEquation& equation) {
        system->linearise(serial, equation, lying.cloth.state.velocities.span(), LinearisedAbout::iterate);
    };
    linearise(equation_of(lying.cloth, h));
    Multigrid without(serial, *system, lying.cloth.state.positions.span());
    without.build(serial);
    Multigrid with(serial, *system, lying.cloth.state.positions.span());
    linearise(lying.equation());
    with.build(serial);
    const ContactRows& rows = lying.contacts.rows();
    const Interpolation& p = with.level(0).interpolation();
    double held = 0;
    for (std::uint32_t c = 0; c < p.coarse; ++c) {
        Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
        for (std::uint32_t e = p.offsets[c]; e < p.offsets[c + 1]; ++e)
            if (const std::uint32_t i = p.entries[e] / Interpolation::width; rows.touches(i))
                expected += static_cast<double>(p.weights[p.entries[e]]) * rows.block(i).full();
        const Eigen::Matrix3d found = with.level(0).matrix().ground_rows[c].full();
        const Eigen::Matrix3d added = found - without.level(0).matrix().ground_rows[c].full();
        EXPECT_LT((added - expected).norm(), 1e-5 * found.norm()) << c;
        held += expected.norm();
    }
    EXPECT_GT(held, 0);
    // And they let go of them again.
    linearise(equation_of(lying.cloth, h));
    with.build(serial);
    for (std::uint32_t c = 0; c < p.coarse; ++c)
        EXPECT_EQ(with.level(0).matrix().ground_rows[c].full(),
                  without.level(0).matrix().ground_rows[c].full());
}

TEST(Contacts, SolversConvergeToTheDenseSolution) {
    const Method methods[] = {Jacobi{.iterations = 6000}, Chebyshev{.iterations = 800},
                              ConjugateGradient{.iterations = 600}};
    for (const bool elements : {false, true}) {
        for (const Method& method : methods) {
            LyingCloth lying(elements);
            lying.press();
            const HeldContacts pressed = lying.held;
            Cloth& cloth = lying.cloth;
            Parallel serial(1);
            const auto system = make_system(cloth.model, cloth.settings);
            system->linearise(serial, lying.equation(), cloth.state.velocities.span(), LinearisedAbout::base);
            const DenseSystem expected = dense(*system);
            const Eigen::VectorXd exact = solution(expected.matrix, expected.right_side);

            ClothSettings settings = cloth.settings;
            settings.method = method;
            cloth.apply(settings);
            lying.held = pressed;
            Profiler profiler(stage_names);
            cloth.solver->lay_out_alone();
            cloth.solver->solve({.parallel = serial,
                                 .profiler = profiler,
                                 .model = cloth.model,
                                 .settings = cloth.settings,
                                 .equation = lying.equation(),
                                 .velocities = cloth.scratch_velocities.span()});
            EXPECT_LT((velocity_change(cloth) - exact).norm(), 1e-4 * exact.norm())
                << method.index() << (elements ? " elements" : " springs");
        }
    }
}

/// How much of the sum of all rows is left after mean motion and three sweeps of Jacobi, over the sum of b.
double mean_left(LyingCloth& lying, bool in_contact) {
    Parallel serial(1);
    const auto system = make_system(lying.cloth.model, lying.cloth.settings);
    const StepEquation equation = in_contact ? lying.equation() : equation_of(lying.cloth, h);
    system->linearise(serial, equation, lying.cloth.state.velocities.span(), LinearisedAbout::base);
    const DenseSystem whole = dense(*system);
    MeanMotion mean_motion(lying.cloth.model);
    AlignedBuffer<Vec4> dv(lying.cloth.model.particle_count), scratch(dv.size());
    const AlignedBuffer<Vec4> at_rest(dv.size());
    mean_motion.take_out(serial, system->contacts(), system->right_side().span());
    solve_jacobi(serial, *system, 3, scratch.span(), dv.span());
    mean_motion.put_back(serial, system->contacts(), system->right_side().span(), at_rest.span(), dv.span());
    const Eigen::VectorXd left = whole.right_side - whole.matrix * flat(dv.span());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), all = sum;
    for (Eigen::Index i = 0; i < left.size(); i += 3) {
        sum += left.segment<3>(i);
        all += whole.right_side.segment<3>(i);
    }
    return sum.norm() / all.norm();
}

TEST(Contacts, MeanMotionLeavesNothingOfTheRowsSum) {
    LyingCloth lying;
    lying.cloth.unpin(std::array{1u, 9u});
    lying.press();
    EXPECT_LT(mean_left(lying, false), 1e-4);
    EXPECT_LT(mean_left(lying, true), 1e-4);
    EXPECT_GT(lying.touching(), 8u);
}

/// One particle, at `position` at the substep's start, that meets one collider.
class OneParticle {
  public:
    OneParticle(const Vector3& position, const Collider& collider)
        : cloth_(cook(sheet(2, 2)).value(), {}), contacts_(4), held_(4), motions_{{collider, collider}} {
        for (Vec4& x : cloth_.state.positions.span()) x.y = 50;  // the others are far from all
        set_xyz(cloth_.state.positions[0], position);
        contacts_.begin(motions_, cloth_.side(), held_);
    }
    /// Whether another linearisation, about this velocity, finds it in contact.
    bool touches_at(const Vector3& velocity) {
        AlignedBuffer<Vec4> velocities(4);
        set_xyz(velocities[0], velocity);
        contacts_.begin_pass();
        contacts_.linearise(equation_of(cloth_, h), velocities.span(), {0, 4, 0});
        return xyz(held_.normals[0]).squaredNorm() > 0;
    }
    [[nodiscard]] float thickness() const { return cloth_.settings.thickness; }
    /// What the last linearisation holds it by, across the normal that it is given along +Y [kg].
    [[nodiscard]] float damper() const { return contacts_.rows().block(0).xx; }

  private:
    Cloth cloth_;
    Contacts contacts_;
    HeldContacts held_;
    std::vector<ColliderMotion> motions_;
};

TEST(ContactRows, OnlyTheFirstPassAddsGravitysFall) {
    // Later velocities hold it already: what they leave above the surface does not touch it.
    const float fall = h * h * 9.81f, above = 0.4f * fall;
    const Collider floor{Plane{{0, 1, 0}, 0}, 0};
    const float thickness = OneParticle({0, 9, 0}, floor).thickness();
    OneParticle first({0, thickness + above, 0}, floor);
    EXPECT_TRUE(first.touches_at(Vector3::Zero())) << "it is going to fall in";

    OneParticle later({0, thickness + 3 * fall, 0}, floor);
    EXPECT_FALSE(later.touches_at(Vector3::Zero()));
    EXPECT_FALSE(later.touches_at({0, -(3 * fall - above) / h, 0})) << "it fell to just above the surface";
    EXPECT_TRUE(later.touches_at({0, -4 * fall / h, 0})) << "it fell in";
}

TEST(ContactRows, LaterPassesReleaseWhatDoesNotTouchAnyMore) {
    // By the first pass's plane a particle that goes sideways stays in; the sphere curves away below it.
    const float radius = 0.1f, deep = 1e-5f, sideways = 8e-3f;
    const Collider ball{Sphere{{0, -radius, 0}, radius}, 0};
    OneParticle particle({0, OneParticle({0, 9, 0}, ball).thickness() - deep, 0}, ball);
    EXPECT_TRUE(particle.touches_at(Vector3::Zero()));
    EXPECT_TRUE(particle.touches_at(Vector3::Zero()));
    EXPECT_FALSE(particle.touches_at({sideways / h, 0, 0}));
}

TEST(ContactRows, LaterPassesRubByWhatTheOneBeforePressed) {
    const Collider floor{Plane{{0, 1, 0}, 0}, 0.5f};
    OneParticle particle({0, OneParticle({0, 9, 0}, floor).thickness(), 0}, floor);
    const Vector3 sliding(2, 0, 0), deeper(2, -0.3f, 0);
    ASSERT_TRUE(particle.touches_at(sliding));
    EXPECT_EQ(particle.damper(), 0) << "nothing is known to press yet";
    ASSERT_TRUE(particle.touches_at(deeper));
    const float first = particle.damper();
    EXPECT_GT(first, 0) << "it presses at the velocity that was found";
    ASSERT_TRUE(particle.touches_at(0.5f * sliding + Vector3(0, -0.3f, 0)));
    EXPECT_GT(particle.damper(), first) << "friction's limit over half the speed";
}

}  // namespace
}  // namespace weft::test
