// Every vector target takes the step that the narrowest one takes.

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

#include "tests/collision/contact/crumpled_sheet.h"
#include "tests/guarantees/method_cases.h"
#include "tests/targets/targets.h"

namespace weft::test {
namespace {

constexpr std::uint32_t side = 17;  // so that the last group of 16 is not full
constexpr int steps_before = 25;

struct State {
    std::vector<Vec4> positions, velocities;
    float change = 0;  ///< largest of a velocity in the last step [m/s]
    std::uint64_t hash = 0;
};

float largest_difference(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
    float largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const float apart =
            std::max({std::abs(a[i].x - b[i].x), std::abs(a[i].y - b[i].y), std::abs(a[i].z - b[i].z)});
        if (!(apart <= largest)) largest = apart;  // what is not a number, too
    }
    return largest;
}

/// After `steps_before` steps under the widest target, and one more under `target`.
State state_after_a_step_of(const MethodCase& method_case, std::int64_t target) {
    use_target(vector_targets().front());
    LoweredSheet run(method_case, 1, side);
    State state;
    for (int step = 0; step <= steps_before; ++step) {
        if (step == steps_before) use_target(target);
        const std::vector<Vec4> before = state.velocities;
        run.before_step();
        EXPECT_FALSE(has(run.step().flags, StepFlags::state_restored)) << "in step " << step;
        const ClothView view = run.world().cloth(run.cloth()).value();
        state.positions.assign(view.positions.begin(), view.positions.end());
        state.velocities.assign(view.velocities.begin(), view.velocities.end());
        if (step == steps_before) state.change = largest_difference(state.velocities, before);
    }
    state.hash = run.world().state_hash();
    return state;
}

class Targets : public testing::TestWithParam<MethodCase> {
  protected:
    void TearDown() override { use_target(vector_targets().front()); }
};

/// Of a velocity, relative to the largest change of one in the step. What goes wrong in a lane goes wrong by
/// all of it.
///
/// Springs have the matrix of an implicit step in half precision. Without F16C Highway cuts halves off where
/// AVX2 rounds them, which moves the matrix by 2^-10, and iterations that stop early pass on up to 130 times
/// that (Chebyshev's, where the cloth lies on colliders). All else is computed in floats: 2^-24, times the
/// condition of the step, which here is some thousands.
float tolerance(const MethodCase& method_case) {
    const bool has_halves =
        is_implicit(method_case.cloth.method) && !method_case.cloth.finite_elements.enabled;
    return has_halves ? 160 * 0x1p-10f : 0x1p13f * 0x1p-24f;
}

TEST_P(Targets, TakeTheStepOfTheNarrowest) {
    const State narrow = state_after_a_step_of(GetParam(), reference_target());
    std::uint64_t fused_hash = 0;
    for (const std::int64_t target : vector_targets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        const State found = state_after_a_step_of(GetParam(), target);
        if (!is_fused(target)) {
            EXPECT_EQ(found.hash, narrow.hash) << "the same operations, in the same order";
            continue;
        }
        if (fused_hash == 0) fused_hash = found.hash;
        EXPECT_EQ(found.hash, fused_hash) << "the same operations as of wider vectors";
        EXPECT_LT(largest_difference(found.velocities, narrow.velocities),
                  tolerance(GetParam()) * narrow.change);
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Targets, testing::ValuesIn(method_cases()),
                         [](const auto& info) { return info.param.name; });

std::vector<std::vector<std::uint32_t>> self_contacts(const Sheet& sheet, float distance) {
    Parallel serial(1);
    SelfContacts contacts(sheet.rest);
    contacts.find(serial, sheet.positions, {}, distance, SelfCollisionSearch::exact);
    std::vector<std::vector<std::uint32_t>> lists;
    for (std::uint32_t i = 0; i < sheet.positions.size(); ++i)
        lists.emplace_back(contacts.contacts(i).begin(), contacts.contacts(i).end());
    return lists;
}

TEST(SelfContactTargets, FindTheContactsThatTheNarrowestFinds) {
    constexpr std::uint32_t n = 47;  // so that the last patch is not full
    const Sheet sheet = crumpled_sheet(n);
    for (const float distance : {0.75f / n, 2.5f / n}) {  // the second is crowded
        use_target(reference_target());
        const auto expected = self_contacts(sheet, distance);
        for (const std::int64_t target : vector_targets()) {
            use_target(target);
            EXPECT_EQ(self_contacts(sheet, distance), expected) << hwy::TargetName(target);
        }
    }
    use_target(vector_targets().front());
}

}  // namespace
}  // namespace weft::test
