#pragma once
// Random pairs as rows of an equation.

#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include "cloth/equation/pairs/pair_rows.h"
#include "tests/cloth/as_for_threads.h"
#include "tests/laid_out.h"

namespace weft::test {

constexpr float pair_gamma = 0.01f;  // [s]

/// Pairs of particles near the origin, some pinned, some pairs without a radius, some at rest, some far
/// apart.
struct PairScene {
    std::vector<Vec4> positions, velocities;
    LaidOut<PairList> pairs;
    std::vector<PairLaw> laws;

    explicit PairScene(std::uint32_t particles, std::uint32_t count, std::uint32_t pinned_every = 7)
        : positions(particles), velocities(particles), pairs(count), laws(count) {
        std::mt19937 random(3);
        std::uniform_real_distribution<float> in_box(-1, 1);
        const auto point = [&](float size) -> Vector3 {
            return size * Vector3(in_box(random), in_box(random), in_box(random));
        };
        for (std::uint32_t i = 0; i < particles; ++i) {
            positions[i] = to_vec4(point(0.01f), i % pinned_every == 0 ? 0 : 1 + 500 * (1 + in_box(random)));
            velocities[i] = to_vec4(point(0.3f), 0);
        }
        std::vector<std::uint32_t> numbers(particles);
        for (std::uint32_t i = 0; i < particles; ++i) numbers[i] = i;
        pairs.size = count;
        pairs.vertex_triangle = count / 3;
        for (std::uint32_t k = 0; k < count; ++k) {
            std::ranges::shuffle(numbers, random);
            std::copy_n(numbers.begin(), 4, pairs.pairs[k].corners.begin());
            const float s = 0.5f + 0.5f * in_box(random), t = (1 - s) * (0.5f + 0.5f * in_box(random));
            pairs.shapes[k] = {
                k < pairs.vertex_triangle ? Vec4{1, s + t - 1, -s, -t} : Vec4{1 - s, s, t - 1, -t},
                to_vec4(point(1).normalized(), 0.001f)};
            laws[k] = {.radius = k % 5 == 2 ? 0 : 0.004f, .friction = k % 4 == 1 ? 0 : 0.3f};
        }
    }
};

/// Rows that were linearised at the scene's velocities.
struct Linearised {
    Parallel parallel;
    LaidOut<PairRows> rows;

    explicit Linearised(const PairScene& scene, int threads = 1)
        : Linearised(scene, threads, scene.pairs.size) {}
    Linearised(const PairScene& scene, int threads, std::size_t room_for_rows)
        : parallel(as_for_threads(threads)) {
        rows.reserve(PairRows::Room{scene.positions.size(), scene.pairs.size, room_for_rows});
        rows.begin(parallel, scene.pairs, scene.laws, scene.positions, pair_gamma);
        rows.take(parallel, 0, scene.velocities);
        rows.linearise(parallel);
    }
    std::vector<Vec4> impulses(std::size_t particles) const {
        std::vector<Vec4> all(particles);
        rows.for_each_particle(0, static_cast<std::uint32_t>(particles), [&](const PairRows::AtParticle& at) {
            all[at.particle] = to_vec4(at.impulse, 0);
        });
        return all;
    }
    double multiply(std::span<const Vec4> x, std::span<Vec4> product) {
        rows.take(parallel, 0, x);
        const double sum = rows.multiply(parallel);
        rows.add_products(parallel, 0, product);
        return sum;
    }
};

}  // namespace weft::test
