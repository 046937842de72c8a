// Sliced rows against the compressed ones that they are made from.

#include "cloth/equation/sparse/stencil.h"

#include <gtest/gtest.h>

#include <set>

#include "cloth/mesh/cook.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

Stencil springs_of(const ClothModel& model) {
    return {model.spring_offsets.span(), model.neighbours.span()};
}

TEST(Stencil, HoldsEveryHalfEdgeOnceInItsNodesLaneInOrder) {
    for (const NamedMesh& named : sound_meshes()) {
        SCOPED_TRACE(named.name);
        const ClothModel model = must(cook(named.mesh));
        const Stencil stencil = springs_of(model);
        for (std::uint32_t i = 0; i < model.particle_count; ++i) {
            std::uint32_t last_slot = 0;
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                const std::uint32_t entry = stencil.entries[e], slot = entry / Stencil::lanes;
                EXPECT_EQ(stencil.neighbours[entry], model.neighbours[e]);
                EXPECT_EQ(entry % Stencil::lanes, i % Stencil::lanes);
                EXPECT_GE(slot, stencil.group_slots[i / Stencil::lanes]);
                EXPECT_LT(slot, stencil.group_slots[i / Stencil::lanes + 1]);
                if (e > model.spring_offsets[i]) {
                    EXPECT_GT(slot, last_slot);
                }
                last_slot = slot;
            }
        }
    }
}

TEST(Stencil, HasAsManySlotsAsTheBestConnectedNodeNeeds) {
    for (const NamedMesh& named : sound_meshes()) {
        const ClothModel model = must(cook(named.mesh));
        const Stencil stencil = springs_of(model);
        for (std::uint32_t g = 0; g < stencil.groups(); ++g) {
            std::uint32_t most = 0;
            for (std::uint32_t i = g * Stencil::lanes; i < std::min((g + 1) * Stencil::lanes, stencil.nodes);
                 ++i)
                most = std::max(most, model.spring_offsets[i + 1] - model.spring_offsets[i]);
            EXPECT_EQ(stencil.group_slots[g + 1] - stencil.group_slots[g], most) << named.name;
        }
    }
}

TEST(Stencil, NodesNameThemselvesWhereTheyNeedNoSlot) {
    for (const NamedMesh& named : sound_meshes()) {
        const ClothModel model = must(cook(named.mesh));
        const Stencil stencil = springs_of(model);
        const std::set<std::uint32_t> used(stencil.entries.data(),
                                           stencil.entries.data() + stencil.entries.size());
        for (std::uint32_t g = 0; g < stencil.groups(); ++g) {
            for (std::uint32_t entry = stencil.group_slots[g] * Stencil::lanes;
                 entry < stencil.group_slots[g + 1] * Stencil::lanes; ++entry) {
                const std::uint32_t node = g * Stencil::lanes + entry % Stencil::lanes;
                EXPECT_TRUE(used.contains(entry) ||
                            stencil.neighbours[entry] == std::min(node, stencil.nodes - 1));
            }
        }
    }
}

TEST(Stencil, RunsHoldTheNeighboursAndEndWithinTheGroups) {
    for (const NamedMesh& named : sound_meshes()) {
        const ClothModel model = must(cook(named.mesh));
        const Stencil stencil = springs_of(model);
        for (const std::uint32_t entry : stencil.entries.span()) {
            const std::uint32_t run = stencil.runs[entry / Stencil::lanes];
            if (run == Stencil::no_run) continue;
            EXPECT_EQ(stencil.neighbours[entry], run + entry % Stencil::lanes) << named.name;
            EXPECT_LE(run + Stencil::lanes, stencil.groups() * Stencil::lanes);
        }
    }
}

TEST(Stencil, GridsAreReadAsTheyLie) {
    const ClothModel model = must(cook(sheet(40, 50)));
    const Stencil stencil = springs_of(model);
    // But for the first and last rows, whose missing neighbours would lie outside of the grid.
    for (std::uint32_t g = 8; g + 8 < stencil.groups(); ++g)
        for (std::uint32_t s = stencil.group_slots[g]; s < stencil.group_slots[g + 1]; ++s)
            EXPECT_NE(stencil.runs[s], Stencil::no_run) << "group " << g;
}

}  // namespace
}  // namespace weft::test
