// The ends of substeps, what BDF2 remembers of them and the survey, on every kind of vector that this machine
// has, against one particle at a time.

#include "cloth/motion/advance.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "cloth/motion/survey.h"
#include "hwy/targets.h"
#include "tests/cloth/fixtures.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

constexpr float max_speed = 1.5f;

/// A cloth of 23 * 29 = 667 particles, the last group not full, after one substep.
struct Substep {
    Substep(Parallel& parallel, bool second_order)
        : cloth(crumpled(sheet(23, 29), 0.1f, 10)),
          start(cloth.model.particle_count),
          solved(random_rows(start.size(), 1.5f, 5)),
          history(start.size()) {
        cloth.pin(17);
        if (second_order) cloth.state.record = StepRecord(start.size());
        std::ranges::copy(cloth.state.positions.span(), start.positions.data());
        std::ranges::copy(cloth.state.velocities.span(), start.velocities.data());
        StepEquation equation = equation_of(cloth, h);
        advance(parallel, equation,
                {.solved = solved.span(),
                 .max_speed = max_speed,
                 .velocities = cloth.state.velocities.span(),
                 .positions = cloth.state.positions.span(),
                 .record = second_order ? &cloth.state.record : nullptr});
    }
    Cloth cloth;
    ClothState start;
    AlignedBuffer<Vec4> solved;
    LaidOut<History> history;
};

class AdvanceKernels : public testing::TestWithParam<std::int64_t> {
  protected:
    void SetUp() override { hwy::SetSupportedTargetsForTest(GetParam()); }
    void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
    Parallel serial{1};
};

TEST_P(AdvanceKernels, HoldTheSpeedAndMove) {
    const Substep substep(serial, false);
    const ClothState &start = substep.start, &end = substep.cloth.state;
    int held = 0;
    for (std::uint32_t i = 0; i < end.size(); ++i) {
        Vector3 v = xyz(substep.solved[i]);
        if (v.norm() > max_speed) {
            v *= max_speed / v.norm();
            ++held;
        }
        EXPECT_LE((xyz(end.velocities[i]) - v).norm(), 1e-6f) << "particle " << i;
        EXPECT_LE((xyz(end.positions[i]) - (xyz(start.positions[i]) + h * v)).norm(), 2e-7f);
        EXPECT_EQ(end.positions[i].w, start.positions[i].w);
        EXPECT_EQ(end.velocities[i].w, 0);
    }
    EXPECT_GT(held, 10);
    for (const AlignedBuffer<Vec4>* rows : {&end.positions, &end.velocities})
        for (std::uint32_t i = end.size(); i % 16 != 0; ++i)
            EXPECT_EQ(load(rows->data()[i]), Vector4(0, 0, 0, 0));
}

// BDF2's bases: x + (x - x_before) / 3 and v + (v - v_before) / 3, but for what is pinned or was moved since.
TEST_P(AdvanceKernels, HistoryLeadsToTheNextBases) {
    Substep substep(serial, true);
    ClothState& now = substep.cloth.state;
    ASSERT_EQ(now.record.h, h);
    for (std::uint32_t i = 3; i < now.size(); i += 7) now.positions[i].y += 0.01f;
    now.velocities[40] = {1, 2, 3, 0};  // no longer what the substep left
    substep.history.begin(serial, now, 3);
    for (std::uint32_t i = 0; i < now.size(); ++i) {
        const Vector3 x = xyz(now.positions[i]), v = xyz(now.velocities[i]);
        const bool pinned = i == 17, moved = i % 7 == 3;
        const Vector3 came = pinned || moved ? Vector3(h * v) : Vector3(x - xyz(substep.start.positions[i]));
        const Vector3 change =
            i == 40 ? Vector3(xyz(now.record.velocity_changes[i]))
                    : (pinned ? Vector3(Vector3::Zero()) : Vector3(v - xyz(substep.start.velocities[i])));
        EXPECT_LE((xyz(substep.history.base_positions()[i]) - (x + came / 3)).norm(), 2e-7f) << i;
        EXPECT_LE((xyz(substep.history.base_velocities()[i]) - (v + change / 3)).norm(), 1e-6f) << i;
        EXPECT_EQ(substep.history.base_positions()[i].w, now.positions[i].w);
    }
}

TEST_P(AdvanceKernels, SurveyFindsWhatAPlainLoopFinds) {
    for (const auto& [rows, columns] : {std::pair(2u, 2u), {4u, 4u}, {5u, 7u}, {23u, 29u}}) {
        Cloth cloth = crumpled(sheet(rows, columns), 0.1f, 10);
        for (Vec4& x : cloth.state.positions.span()) x.y += 3;  // so that a row of zeros would be seen
        expect_like(survey(serial, cloth.state, cloth.partial_surveys.span()), plain_survey(cloth.state));
    }
}

bool same_state(const ClothState& a, const ClothState& b) {
    return std::memcmp(a.positions.data(), b.positions.data(), a.positions.bytes()) == 0 &&
           std::memcmp(a.velocities.data(), b.velocities.data(), a.velocities.bytes()) == 0;
}

TEST_P(AdvanceKernels, SameBytesForAnyNumberOfThreads) {
    const Substep expected(serial, true);
    for (int threads = 2; threads <= 8; ++threads) {
        Parallel parallel(threads);
        EXPECT_TRUE(same_state(Substep(parallel, true).cloth.state, expected.cloth.state)) << threads;
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, AdvanceKernels, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& info) { return std::string(hwy::TargetName(info.param)); });

}  // namespace
}  // namespace weft::test
