// Geodesics against closed forms, and what tethers do with them.

#include "cloth/limits/tethers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

/// The largest relative error of the distances from `source`, signed: too short and too long.
struct Errors {
    double shortest = 0, longest = 0;
};
template <class Exact>
Errors errors_from(const ClothModel& model, std::uint32_t source, const Exact& exact) {
    Geodesics geodesics(model);
    geodesics.march(model, std::array{GeodesicSource{source, 0}});
    Errors errors;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        if (i == source) continue;
        const double distance = exact(xyz(model.positions[i]).cast<double>());
        errors.shortest = std::min(errors.shortest, geodesics.from(i)[0].distance / distance - 1);
        errors.longest = std::max(errors.longest, geodesics.from(i)[0].distance / distance - 1);
    }
    return errors;
}

/// A flat sheet whose inner vertices are displaced in its plane: thin and obtuse triangles.
Mesh irregular_sheet(std::uint32_t side) {
    Mesh mesh = loose_sheet(side, side);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> offset(-0.45f, 0.45f);
    const float spacing = 1.0f / static_cast<float>(side - 1);
    for (std::uint32_t row = 1; row + 1 < side; ++row) {
        for (std::uint32_t column = 1; column + 1 < side; ++column) {
            mesh.positions[row * side + column].x += spacing * offset(random);
            mesh.positions[row * side + column].z += spacing * 0.5f * offset(random);
        }
    }
    return mesh;
}

TEST(Geodesics, AreStraightLinesOnAFlatSheet) {
    for (const Mesh& mesh : {sheet(30, 40), loose_sheet(30, 30), irregular_sheet(30)}) {
        const ClothModel model = must(cook(mesh));
        for (const std::uint32_t source : {0u, model.particle_count / 2}) {
            const Eigen::Vector3d from = xyz(model.positions[source]).cast<double>();
            const Errors errors =
                errors_from(model, source, [&](const auto& x) { return (x - from).norm(); });
            EXPECT_GT(errors.shortest, -1e-4);
            EXPECT_LT(errors.longest, 1e-4);
        }
    }
}

TEST(Geodesics, GoAroundATube) {
    const std::uint32_t columns = 48;
    const ClothModel model = must(cook(tube(30, columns)));
    const std::uint32_t source = model.vertex_to_particle[10 * (columns + 1)];
    const double height = static_cast<double>(model.positions[source].y);
    const double chord_per_angle =
        columns * 2 * std::sin(std::numbers::pi / columns) / (2 * std::numbers::pi);
    const Errors errors = errors_from(model, source, [&](const Eigen::Vector3d& x) {
        return std::hypot(chord_per_angle * std::abs(std::atan2(x.z(), x.x())), x.y() - height);
    });
    EXPECT_GT(errors.shortest, -0.01);
    EXPECT_LT(errors.longest, 0.01);
}

TEST(Geodesics, GoAroundAHole) {
    Mesh mesh = loose_sheet(41, 41);
    const auto in_hole = [&](std::uint32_t vertex) {
        const Vec3& p = mesh.positions[vertex];
        return std::max(std::abs(p.x), std::abs(p.z)) < 0.2501f;
    };
    std::erase_if(mesh.triangles,
                  [&](const Triangle& t) { return in_hole(t[0]) && in_hole(t[1]) && in_hole(t[2]); });
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
        return std::max(std::abs(a.x + b.x + c.x), std::abs(a.z + b.z + c.z)) / 3 < 0.25f;
    });
    const ClothModel model = must(cook(mesh));
    Geodesics geodesics(model);
    const auto at = [&](std::uint32_t row, std::uint32_t column) {
        return model.vertex_to_particle[row * 41 + column];
    };
    geodesics.march(model,
                    std::array{GeodesicSource{
                        at(20, 2), 0}});  // 0.45 m left of the middle; the hole's corners are 0.25 m from it
    const double to_corner = std::hypot(0.2, 0.25);
    EXPECT_NEAR(geodesics.from(at(20, 38))[0].distance, 2 * to_corner + 0.5, 0.02 * (2 * to_corner + 0.5));
    EXPECT_NEAR(geodesics.from(at(20, 30))[0].distance, to_corner + 0.5 + 0.25, 0.02 * (to_corner + 0.75));
    EXPECT_NEAR(geodesics.from(at(2, 2))[0].distance, 0.45, 1e-4) << "not in the hole's shadow";
    EXPECT_EQ(geodesics.from(at(20, 20))[0].source, GeodesicReach::none) << "cut out";
}

ClothSettings settings_of(const Method& method, bool tethers, float slack = 1) {
    ClothSettings settings;
    settings.method = method;
    settings.tethers = {.enabled = tethers, .slack = slack};
    return settings;
}

LongRangeAttachments attached(const ClothModel& model, std::span<const std::uint32_t> pins) {
    LongRangeAttachments tethers(model);
    tethers.prepare(model, pins);
    tethers.commit();
    tethers.update(model);
    return tethers;
}

/// A Simulation of one sheet that is hung by two corners.
struct HungSheet {
    explicit HungSheet(const ClothSettings& settings, std::uint32_t side = 32)
        : simulation({}),
          id(simulation.add(std::make_unique<Cloth>(must(cook(sheet(side, side))), settings))) {
        simulation.settings.wind.air_density = 0;
        simulation.prepare(cloth());
        cloth().pin(0);
        cloth().pin(side - 1);
    }
    [[nodiscard]] Cloth& cloth() { return **simulation.cloths.find(id); }
    void step() { simulation.step(1.0f / 60); }

    [[nodiscard]] double mean_stretch() {
        const ClothModel& model = cloth().model;
        double sum = 0;
        std::uint32_t count = 0;
        for (std::uint32_t i = 0; i < model.particle_count; ++i) {
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                if (model.kinds[e] != SpringKind::structural) continue;
                const Vec4 &a = cloth().state.positions[i], &b = cloth().state.positions[model.neighbours[e]];
                sum +=
                    std::max(0.0, static_cast<double>((xyz(a) - xyz(b)).norm() / model.rest_lengths[e] - 1));
                ++count;
            }
        }
        return sum / count;
    }

    Simulation simulation;
    ClothId id;
};

const LongRangeAttachments& tethers_of(HungSheet& sheet) {
    return static_cast<const LongRangeAttachments&>(*sheet.cloth().limits.front());
}

/// By how much the particles exceed a layer's limit at most, as a part of it.
double excess(HungSheet& sheet, std::size_t layer, float slack) {
    const LongRangeAttachments::Layer& tethers = tethers_of(sheet).layers()[layer];
    const auto x = sheet.cloth().state.positions.span();
    double most = 0;
    for (std::uint32_t i = 0; i < x.size(); ++i) {
        if (x[i].w == 0) continue;
        const float distance = (xyz(x[i]) - xyz(x[tethers.pins[i]])).norm();
        most = std::max(most, static_cast<double>(distance / (slack * tethers.lengths[i]) - 1));
    }
    return most;
}

TEST(Tethers, LetNoParticleBeyondItsWayAlongTheCloth) {
    for (const float slack : {1.0f, 1.1f}) {
        // The last one diverges at such a step; tethers hold even that.
        for (const Method& method :
             {Method(Jacobi{.iterations = 3}), Method(Xpbd{}), Method(SymplecticEuler{})}) {
            HungSheet sheet(settings_of(method, true, slack));
            sheet.cloth().unpin(31);
            for (int frame = 0; frame < 60; ++frame) {
                sheet.cloth().find_pin(0)->target += Vector3(0.005f, 0.01f, 0);
                sheet.step();
                ASSERT_LT(excess(sheet, 0, slack), 1e-4);
            }
        }
    }
}

TEST(Tethers, OfTwoHoldsKeepTheLastExactlyAndTheFirstNearly) {
    for (const Method& method : {Method(Jacobi{.iterations = 3}), Method(Xpbd{})}) {
        HungSheet sheet(settings_of(method, true));
        for (int frame = 0; frame < 60; ++frame) {
            sheet.cloth().find_pin(0)->target += Vector3(0.005f, 0.01f, 0);
            sheet.step();
            ASSERT_LT(excess(sheet, 0, 1), 0.05);
            ASSERT_LT(excess(sheet, 1, 1), 1e-4);
        }
    }
}

TEST(Tethers, DoNothingWithinTheirLength) {
    HungSheet without(settings_of(Jacobi{.iterations = 31}, false));
    HungSheet with(settings_of(Jacobi{.iterations = 31}, true, 100));
    for (int frame = 0; frame < 10; ++frame) {
        without.step();
        with.step();
    }
    EXPECT_EQ(flat(with.cloth().state.positions.span()), flat(without.cloth().state.positions.span()));
    EXPECT_EQ(flat(with.cloth().state.velocities.span()), flat(without.cloth().state.velocities.span()));
    EXPECT_TRUE(without.cloth().limits.empty()) << "no memory while they are off";
}

TEST(Tethers, TakeTheVelocityAwayFromThePinAndNoOther) {
    const ClothModel model = must(cook(sheet(2, 3)));
    const LongRangeAttachments tethers = attached(model, std::array{0u});
    AlignedBuffer<Vec4> positions(6), velocities(6);
    for (Vec4& x : positions.span()) x.w = 1;
    positions[0] = {1, 1, 1, 0};
    velocities[0] = {5, 0, 0, 0};
    positions[2] = {1, 3, 1, 1};  // the limit is 1 m
    velocities[2] = {5, 4, 2, 0};
    Parallel serial(1);
    tethers.hold(serial, 1, positions.span(), velocities.span());
    EXPECT_LT((xyz(positions[2]) - Vector3(1, 2, 1)).norm(), 1e-6f);
    EXPECT_LT((xyz(velocities[2]) - Vector3(5, 0, 2)).norm(), 1e-6f);
    velocities[2] = {5, -4, 2, 0};
    positions[2].y = 3;
    tethers.hold(serial, 1, positions.span(), velocities.span());
    EXPECT_EQ(velocities[2].y, -4);
}

TEST(Tethers, FollowThePins) {
    HungSheet sheet(settings_of(Jacobi{}, true), 8);
    const auto layers = [&] {
        sheet.step();
        return tethers_of(sheet).layers();
    };
    EXPECT_EQ(layers().size(), 2u);
    EXPECT_EQ(layers()[0].pins[63], 0u);
    EXPECT_EQ(layers()[1].pins[63], 7u);
    sheet.cloth().pin(63);
    EXPECT_EQ(layers().size(), 3u);
    EXPECT_EQ(layers()[2].pins[62], 63u);
    sheet.cloth().unpin(63);
    sheet.cloth().unpin(7);
    EXPECT_EQ(layers().size(), 1u);
    EXPECT_EQ(layers()[0].pins[63], 0u);
    sheet.cloth().unpin(0);
    EXPECT_TRUE(layers().empty());
}

TEST(Tethers, TakePinsThatSpringsJoinForOneHold) {
    const ClothModel model = must(cook(sheet(6, 6)));
    const LongRangeAttachments tethers = attached(model, std::array{0u, 1u, 2u, 3u, 4u, 5u, 30u, 35u});
    ASSERT_EQ(tethers.layers().size(), 3u);
    EXPECT_EQ(tethers.layers()[0].pins[9], 3u);
    EXPECT_FLOAT_EQ(tethers.layers()[0].lengths[9], 0.2f);
    EXPECT_EQ(tethers.layers()[1].pins[9], 30u);
    EXPECT_EQ(tethers.layers()[2].pins[9], 35u);
}

TEST(Tethers, ReachTheFourNearestHoldsAsIfEachWereMarchedAlone) {
    const ClothModel model = must(cook(irregular_sheet(20)));
    std::vector<std::uint32_t> pins;
    for (const std::uint32_t vertex : {0u, 19u, 47u, 144u, 210u, 266u, 380u, 399u})
        pins.push_back(model.vertex_to_particle[vertex]);
    std::ranges::sort(pins);
    std::vector<std::vector<double>> alone;
    Geodesics geodesics(model);
    for (const std::uint32_t pin : pins) {
        geodesics.march(model, std::array{GeodesicSource{pin, 0}});
        alone.emplace_back();
        for (std::uint32_t i = 0; i < model.particle_count; ++i)
            alone.back().push_back(geodesics.from(i)[0].distance);
    }
    const LongRangeAttachments tethers = attached(model, pins);
    ASSERT_EQ(tethers.layers().size(), 4u);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        std::vector<double> distances, lengths;
        for (const std::vector<double>& from_pin : alone) distances.push_back(from_pin[i]);
        std::ranges::sort(distances);
        for (const auto& layer : tethers.layers()) lengths.push_back(static_cast<double>(layer.lengths[i]));
        std::ranges::sort(lengths);
        for (std::size_t k = 0; k < 4; ++k) {
            // Where a hold ends to be among the four nearest, its front goes on along edges: longer, never
            // shorter.
            EXPECT_GE(lengths[k], (1 - 1e-4) * distances[k]);
            EXPECT_LE(lengths[k], (k == 0 ? 1.0001 : 1.05) * distances[k]) << k;
        }
    }
}

std::vector<std::uint32_t> bits_of(const LongRangeAttachments& tethers) {
    std::vector<std::uint32_t> bits;
    for (const LongRangeAttachments::Layer& layer : tethers.layers()) {
        bits.insert(bits.end(), layer.pins.span().begin(), layer.pins.span().end());
        for (const float length : layer.lengths.span()) bits.push_back(std::bit_cast<std::uint32_t>(length));
    }
    return bits;
}

TEST(Tethers, DoNotDependOnTheOrderOfPinsAndUnpins) {
    std::mt19937 random(11);
    std::vector<NamedMesh> meshes = sound_meshes();
    meshes.push_back({"sheet", sheet(24, 24)});
    meshes.push_back({"irregular sheet", irregular_sheet(20)});
    for (const NamedMesh& named : meshes) {
        const ClothModel model = must(cook(named.mesh));
        LongRangeAttachments changed(model);
        std::set<std::uint32_t> pinned;
        for (int call = 0; call < 60; ++call) {
            const auto particle = static_cast<std::uint32_t>(random() % model.particle_count);
            if (!pinned.erase(particle)) pinned.insert(particle);
            const std::vector<std::uint32_t> pins(pinned.begin(), pinned.end());
            changed.prepare(model, pins);
            changed.commit();
            if (random() % 4 != 0) continue;  // several changes between two steps
            changed.update(model);
            ASSERT_EQ(bits_of(changed), bits_of(attached(model, pins))) << named.name << ", call " << call;
        }
    }
}

TEST(Tethers, PinnedOneByOneStepAsPinnedAtOnce) {
    HungSheet one_by_one(settings_of(Jacobi{}, true), 24), at_once(settings_of(Jacobi{}, true), 24);
    std::vector<std::uint32_t> row;
    for (std::uint32_t i = 100; i < 140; ++i) row.push_back(i);
    at_once.cloth().pin(row);
    for (const std::uint32_t i : row) one_by_one.cloth().pin(i);
    for (std::uint32_t i = 200; i < 210; ++i) {
        one_by_one.cloth().pin(i);
        one_by_one.cloth().unpin(i);
    }
    for (int frame = 0; frame < 5; ++frame) {
        at_once.step();
        one_by_one.step();
    }
    EXPECT_EQ(flat(one_by_one.cloth().state.positions.span()), flat(at_once.cloth().state.positions.span()));
}

TEST(Tethers, HoldWhatFewIterationsLeaveStretched) {
    // Without bending, which such few iterations take for a drag.
    ClothSettings bare = settings_of(Jacobi{.iterations = 5}, false), tied = settings_of(bare.method, true);
    bare.fabric.bending = tied.fabric.bending = 0;
    HungSheet without(bare, 64), with(tied, 64);
    for (int frame = 0; frame < 60; ++frame) {
        without.step();
        with.step();
    }
    EXPECT_GT(without.mean_stretch(), 0.03);
    EXPECT_LT(with.mean_stretch(), 0.25 * without.mean_stretch());
}

}  // namespace
}  // namespace weft::test
