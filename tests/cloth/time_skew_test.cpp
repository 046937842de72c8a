// Sweeps in one pass over memory against sweeps one after another.

#include "cloth/implicit/time_skew.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <random>
#include <vector>

#include "as_for_threads.h"
#include "cloth/forces/spring_system.h"
#include "cloth/forces/triangle_system.h"
#include "fixtures.h"
#include "meshes.h"

namespace weft::test {
namespace {

struct Sizes {
    std::uint32_t rows, reach;
};
constexpr Sizes sizes[] = {{1, 1},        {17, 3},       {256, 16},    {1000, 1},
                           {5000, 20},    {5000, 300},   {5003, 4999}, {16384, 272},
                           {40'007, 130}, {40'007, 500}, {65536, 1026}};

TEST(TimeSkew, EveryRowIsSweptOnceInEverySweepAndNotBeforeWhatItReads) {
    for (const Sizes& size : sizes) {
        const std::uint32_t rows = size.rows, reach = size.reach;
        for (std::uint32_t sweeps = 1; sweeps <= most_skewed_sweeps; ++sweeps) {
            for (const int threads : {1, 2, 3, 8}) {
                SCOPED_TRACE(testing::Message() << rows << " rows, reach " << reach << ", " << sweeps
                                                << " sweeps, " << threads << " threads");
                Parallel parallel = as_for_threads(threads);  // done[i]: sweeps of row i so far
                std::vector<std::uint32_t> done(rows, 0);
                int faults = 0;
                GridWindows none;
                skewed_sweeps(
                    parallel, rows, reach, sweeps, none,
                    [&](std::uint32_t k, const BlockRange& range, GridWindow*) {
                        faults += range.begin % Stencil::lanes != 0;
                        faults += range.end % Stencil::lanes != 0 && range.end != rows;
                        const std::uint32_t first = range.begin - std::min(range.begin, reach);
                        const std::uint32_t last = std::min(rows, range.end + reach);
                        for (std::uint32_t i = range.begin; i < range.end; ++i) faults += done[i] != k;
                        // Of two buffers, what sweep k reads must be there: written by sweep k - 1,
                        // not yet by k
                        // + 1.
                        for (std::uint32_t i = first; i < last; ++i) faults += done[i] < k || done[i] > k + 1;
                        for (std::uint32_t i = range.begin; i < range.end; ++i) done[i] = k + 1;
                    },
                    0);
                EXPECT_EQ(faults, 0);
                for (const std::uint32_t count : done) ASSERT_EQ(count, sweeps);
            }
        }
    }
}

TEST(TimeSkew, AsksForAllSweepsInFewEvenPasses) {
    for (std::size_t sweeps = 1; sweeps <= 40; ++sweeps) {
        std::size_t passes = 0, most = 0, least = most_skewed_sweeps;
        for (std::size_t left = sweeps; left > 0; ++passes) {
            const std::size_t now = next_sweeps(left);
            most = std::max(most, now);
            least = std::min(least, now);
            left -= now;
        }
        EXPECT_EQ(passes, (sweeps + most_skewed_sweeps - 1) / most_skewed_sweeps);
        EXPECT_LE(most, most_skewed_sweeps);
        EXPECT_LE(most - least, 1u);
    }
}

/// The iterates after `steps` of relaxation, one at a time or all at once.
std::vector<Vec4> relaxed(ImplicitSystem& system, Parallel& parallel, std::span<const Relaxation> steps,
                          bool at_once) {
    const std::span<const Vec4> b = system.right_side().span();
    AlignedBuffer<Vec4> x(b.size()), next(b.size());
    system.precondition(parallel, b, 1, x.span());
    if (at_once) {
        system.relax(parallel, b, steps, x.span(), next.span());
        if (steps.size() % 2 == 1) std::swap(x, next);
    } else {
        for (const Relaxation& step : steps) {
            system.relax(parallel, b, x.span(), step, next.span());
            std::swap(x, next);
        }
    }
    std::vector<Vec4> iterates(x.data(), x.data() + x.size());
    iterates.insert(iterates.end(), next.data(), next.data() + next.size());
    return iterates;
}

TEST(TimeSkew, RelaxationGivesTheSameBytesAsOneStepAfterAnother) {
    constexpr Relaxation steps[] = {{.step = 0.9f, .momentum = 0},
                                    {.step = 0.8f, .momentum = 0.1f},
                                    {.step = 0.7f, .momentum = 0.2f},
                                    {.step = 0.6f, .momentum = 0.3f}};
    ClothSettings settings;
    settings.finite_elements.bending = 1e-5f;  // couples particles beyond those of a triangle
    const CookedCloth model = must(cook(sheet(160, 160)));
    AlignedBuffer<Vec4> positions(model.particle_count), velocities(model.particle_count);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> noise(-0.002f, 0.002f);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        positions[i] = model.positions[i];
        positions[i].x += noise(random);
        positions[i].y += noise(random);
        positions[i].z += noise(random);
        positions[i].w = 1e5f;
    }
    const StepEquation equation{.settings = settings,
                                .h = 1.0f / 60,
                                .gamma = 1.0f / 60,
                                .positions = positions.span(),
                                .velocities = velocities.span(),
                                .base_positions = positions.span(),
                                .base_velocities = velocities.span(),
                                .external = {}};
    SpringSystem springs(model);
    TriangleSystem elements(model, settings);
    for (ImplicitSystem* system : std::initializer_list<ImplicitSystem*>{&springs, &elements}) {
        Parallel serial(1);
        system->linearise(serial, equation, velocities.span(), LinearisedAbout::base);
        for (std::size_t count = 1; count <= std::size(steps); ++count) {
            const std::vector<Vec4> expected = relaxed(*system, serial, std::span(steps).first(count), false);
            for (const int threads : {1, 2, 3}) {
                Parallel parallel(threads);
                const std::vector<Vec4> iterates =
                    relaxed(*system, parallel, std::span(steps).first(count), true);
                ASSERT_GT(model.particle_count, cached_rows * static_cast<std::uint32_t>(threads));
                EXPECT_EQ(std::memcmp(expected.data(), iterates.data(), expected.size() * sizeof(Vec4)), 0)
                    << count << " steps, " << threads << " threads";
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
