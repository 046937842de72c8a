// Colours and fibres: the invariants on which solving in parallel rests, on every mesh.

#include "cloth/methods/positional/colouring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "cloth/methods/positional/fibre_sets.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

std::vector<NamedMesh> coloured_meshes() {
    std::vector<NamedMesh> all = sound_meshes();
    all.push_back({"two_columns", must(make_sheet({.rows = 9, .columns = 2}))});
    if (const char* data = std::getenv("WEFT_DATA")) {
        for (const char* name : {"skirt-iso", "tshirt-iso", "dress-victor-iso-draped"})
            all.push_back({name, must(load_obj(std::filesystem::path(data) / "garments" /
                                               (std::string(name) + ".obj")))});
    }
    return all;
}

std::size_t half_edges_of_springs(const ClothModel& model) {
    return model.neighbours.size() -
           static_cast<std::size_t>(std::ranges::count(model.kinds.span(), SpringKind::bending));
}

std::uint32_t most_springs(const ClothModel& model) {
    std::uint32_t most = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        most = std::max(most, model.spring_offsets[i + 1] - model.spring_offsets[i]);
    return most;
}

TEST(Colouring, HasEverySpringOnceAndNoParticleTwiceInAColour) {
    for (const NamedMesh& named : coloured_meshes()) {
        const ClothModel model = must(cook(named.mesh));
        const SpringColours colours = colour_springs(model);
        std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
        for (std::uint32_t c = 0; c < colours.colours(); ++c) {
            std::set<std::uint32_t> particles;
            for (std::uint32_t s = colours.offsets[c]; s < colours.offsets[c + 1]; ++s) {
                const std::uint32_t e = colours.half_edges[s];
                if (e == SpringColours::no_half_edge) {
                    EXPECT_GE(colours.first[s], model.particle_count);
                    EXPECT_GE(colours.second[s], model.particle_count);
                    continue;
                }
                ASSERT_EQ(model.neighbours[e], colours.second[s]) << named.name;
                ASSERT_TRUE(particles.insert(colours.first[s]).second) << named.name << ", colour " << c;
                ASSERT_TRUE(particles.insert(colours.second[s]).second) << named.name << ", colour " << c;
                ASSERT_TRUE(seen.insert({colours.first[s], colours.second[s]}).second) << named.name;
            }
        }
        EXPECT_EQ(2 * seen.size(), half_edges_of_springs(model)) << named.name;
    }
}

TEST(Colouring, NeedsFewColours) {
    for (const NamedMesh& named : coloured_meshes()) {
        const ClothModel model = must(cook(named.mesh));
        const std::uint32_t colours = colour_springs(model).colours();
        // Vizing: some colouring has at most one more than the best-connected particle has springs.
        EXPECT_LE(colours, named.mesh.rows > 0 ? 12 : most_springs(model) + 1) << named.name;
    }
}

TEST(Fibres, HoldEverySpringOnceAndNoParticleTwice) {
    for (const NamedMesh& named : coloured_meshes()) {
        const ClothModel model = must(cook(named.mesh));
        std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
        for (const Fibre& fibre : find_fibres(model)) {
            ASSERT_EQ(fibre.particles.size(), fibre.half_edges.size() + 1);
            EXPECT_EQ(std::set(fibre.particles.begin(), fibre.particles.end()).size(), fibre.particles.size())
                << named.name;
            for (std::size_t s = 0; s < fibre.half_edges.size(); ++s) {
                const std::uint32_t e = fibre.half_edges[s], i = fibre.particles[s],
                                    j = fibre.particles[s + 1];
                ASSERT_EQ(model.neighbours[e], j);
                EXPECT_EQ(model.kinds[e], fibre.springs);
                ASSERT_TRUE(seen.insert(std::minmax(i, j)).second) << named.name;
            }
        }
        EXPECT_EQ(2 * seen.size(), half_edges_of_springs(model)) << named.name;
    }
}

TEST(Fibres, AreTheRowsColumnsAndDiagonalsOfAGrid) {
    const std::uint32_t rows = 5, columns = 7;
    const ClothModel model = must(cook(must(make_sheet({.rows = rows, .columns = columns}))));
    const std::vector<Fibre> fibres = find_fibres(model);
    const auto lengths = [&](FibreKind kind) {
        std::vector<std::size_t> springs;
        for (const Fibre& fibre : fibres)
            if (fibre.kind == kind) springs.push_back(fibre.half_edges.size());
        std::ranges::sort(springs);
        return springs;
    };
    EXPECT_EQ(lengths(FibreKind::horizontal), std::vector<std::size_t>(rows, columns - 1));
    EXPECT_EQ(lengths(FibreKind::vertical), std::vector<std::size_t>(columns, rows - 1));
    // In each of two directions: three full diagonals, and two of every shorter length.
    EXPECT_EQ(lengths(FibreKind::shear),
              (std::vector<std::size_t>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4}));
}

TEST(FibreSets, HaveNoParticleTwiceAndEndShorterFibresWithStandIns) {
    for (const NamedMesh& named : coloured_meshes()) {
        const ClothModel model = must(cook(named.mesh));
        const FibreSets sets = make_fibre_sets(model);
        std::size_t springs = 0;
        for (const FibreSet& set : sets.sets) {
            std::set<std::uint32_t> particles;
            EXPECT_EQ(set.blocks.front(), set.groups_begin);
            EXPECT_EQ(set.blocks.back(), set.groups_end);
            for (std::uint32_t g = set.groups_begin; g < set.groups_end; ++g) {
                for (std::uint32_t row = 0; row <= sets.rows_of(g); ++row) {
                    for (std::uint32_t lane = 0; lane < FibreSets::lanes; ++lane) {
                        const std::uint32_t i =
                            sets.particles[(sets.particle_row(g) + row) * FibreSets::lanes + lane];
                        if (i < model.particle_count) {
                            EXPECT_TRUE(particles.insert(i).second) << named.name;
                        } else {
                            EXPECT_EQ(i, model.particle_count + g - set.groups_begin);
                            EXPECT_LT(i, model.particle_count + sets.stand_ins);
                        }
                        if (row == sets.rows_of(g)) continue;
                        const std::size_t at = (sets.rows[g] + row) * FibreSets::lanes + lane;
                        const bool exists = sets.rest_lengths[at] != FibreSets::no_spring;
                        springs += exists;
                        const std::uint32_t next =
                            sets.particles[(sets.particle_row(g) + row + 1) * FibreSets::lanes + lane];
                        EXPECT_EQ(exists, next < model.particle_count);
                    }
                }
            }
        }
        EXPECT_EQ(2 * springs, half_edges_of_springs(model)) << named.name;
    }
}

}  // namespace
}  // namespace weft::test
