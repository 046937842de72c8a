// Patches of surfaces that lie in no plane or in several pieces, and which of them are passed over.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/contact/mesh/surface_order.h"
#include "tests/collision/contact/pair_list_reference.h"

namespace weft::test {
namespace {

/// How many patches a search looks at the features of.
std::size_t wanted_patches(const ContactScene& scene) {
    const ContactBody& body = scene.bodies[0];
    const ContactMesh& mesh = *body.mesh;
    const std::vector<SearchedBody> bodies = {{.mesh = &mesh,
                                               .first = 0,
                                               .reach = body.reach,
                                               .layer = 1,
                                               .mask = ~0u,
                                               .meets_itself = true,
                                               .first_vertex_group = 0,
                                               .first_triangle_group = 0,
                                               .first_edge_group = 0,
                                               .first_block = 0,
                                               .first_gradients = 0,
                                               .first_neighbours = 0}};
    const auto patches = static_cast<std::uint32_t>(mesh.patches().size());
    std::vector<PatchBlock> blocks;
    for (std::uint32_t first = 0; first < patches; first += PatchBlock::most)
        blocks.push_back({0, first, std::min(patches - first, PatchBlock::most)});
    AlignedBuffer<Boxes> of_patches(blocks.size()), of_blocks(1), of_groups(1);
    for (AlignedBuffer<Boxes>* all : {&of_patches, &of_blocks, &of_groups})
        for (std::size_t k = 0; k < 16 * all->size(); ++k)
            set_box((*all)[k / 16], static_cast<std::uint32_t>(k % 16), no_box);
    AlignedBuffer<PatchStrain> strains(16 * blocks.size());
    AlignedBuffer<TriangleGradients> gradients(mesh.triangle_slots().groups());
    AlignedBuffer<Neighbours> neighbours(mesh.flat_rest().pairs());
    AlignedBuffer<std::uint8_t> wanted(16 * blocks.size());
    FeatureBoxes boxes{.vertices = {},
                       .triangles = {},
                       .edges = {},
                       .patches = {of_patches.data(), of_patches.size()},
                       .blocks = {of_blocks.data(), 1},
                       .groups = {of_groups.data(), 1},
                       .strains = {strains.data(), strains.size()},
                       .gradients = {gradients.data(), gradients.size()},
                       .wanted_gradients = {},
                       .neighbours = {neighbours.data(), neighbours.size()},
                       .wanted = {wanted.data(), wanted.size()}};
    const PairSearch search{bodies, blocks, &boxes, scene.positions.data(), scene.motions.data()};
    for (std::uint32_t b = 0; b < blocks.size(); ++b)
        set_box(boxes.blocks[0], b, place_patches(search, b, boxes));
    set_box(boxes.groups[0], 0, {{-1e30f, -1e30f, -1e30f}, {1e30f, 1e30f, 1e30f}});
    for (std::uint32_t b = 0; b < blocks.size(); ++b) place_gradients(search, b, boxes);
    for (std::uint32_t b = 0; b < blocks.size(); ++b) find_neighbours(search, b, boxes);
    for (std::uint32_t b = 0; b < blocks.size(); ++b) want_features(search, b, boxes);
    return static_cast<std::size_t>(std::ranges::count(boxes.wanted.span(), std::uint8_t{1}));
}

/// A sheet on a cylinder, turning by so much an edge.
ContactScene rolled(std::uint32_t side, float turn) {
    return sheet(side, 0.3f * edge, grid_positions(side, side, [&](float u, float v) {
                     const float radius = edge / turn, angle = turn * u;
                     return Vec4{radius * std::sin(angle), radius * std::cos(angle), edge * v, 0};
                 }));
}

constexpr std::uint32_t around = 40, along = 16;

/// A tube, pressed together until its sides are `gap` edges apart.
std::vector<Vec4> tube(float gap) {
    return grid_positions(along, around, [&](float u, float v) {
        const float angle = 2 * std::numbers::pi_v<float> * u / float(around),
                    radius = edge * float(around) / 6.28f;
        return Vec4{radius * std::cos(angle), 0.5f * gap * edge * std::sin(angle), edge * v, 0};
    });
}
std::vector<Triangle> tube_triangles(std::uint32_t first = 0) {
    std::vector<Triangle> triangles;
    for (std::uint32_t r = 0; r + 1 < along; ++r)
        for (std::uint32_t c = 0; c < around; ++c) {
            const std::uint32_t a = first + r * around + c, b = first + r * around + (c + 1) % around;
            triangles.push_back({a, a + around, b});
            triangles.push_back({b, a + around, b + around});
        }
    return triangles;
}

/// Three sheets that are one mesh, of 81, 91 and 12 vertices, and a roof that lies in no plane.
struct Sheets {
    std::vector<Vec4> rest;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> starts;

    explicit Sheets(float apart, bool with_roof) {
        const auto add = [&](std::uint32_t rows, std::uint32_t columns, const auto& shape) {
            const auto first = static_cast<std::uint32_t>(rest.size());
            starts.push_back(first);
            for (const Vec4& p : grid_positions(rows, columns, shape)) rest.push_back(p);
            for (const Triangle& t : grid_triangles(rows, columns, first)) triangles.push_back(t);
        };
        const auto flat_at = [&](float y) {
            return [=](float u, float v) { return Vec4{edge * u, edge * y, edge * v, 0}; };
        };
        add(9, 9, flat_at(0));
        add(13, 7, flat_at(apart));
        add(4, 3, flat_at(2 * apart));
        if (with_roof)
            add(11, 10, [&](float u, float v) {
                return Vec4{0.8f * edge * u, edge * (3 * apart + 2 * std::abs(u - 4.5f)), edge * v, 0};
            });
    }
    [[nodiscard]] std::size_t sheet_of(std::uint32_t vertex) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(starts, vertex) - starts.begin());
    }
};

TEST(CalmPatches, ASheetMayTurnByARightAngleFromPatchToPatch) {
    EXPECT_EQ(wanted_patches(rolled(16, 0.01f)), 0u);
    EXPECT_EQ(wanted_patches(rolled(16, 0.12f)), 0u);
    EXPECT_GT(wanted_patches(rolled(16, 0.5f)), 8u);
    expect_same_pairs(rolled(16, 0.12f));
    expect_same_pairs(rolled(16, 0.5f));
}

TEST(CalmPatches, WhatIsCrushedOrStretchedFarIsLookedAt) {
    for (const float width : {0.4f, 30.0f}) {
        std::vector<Vec4> now = flat(16, 16);
        for (Vec4& p : now) p.x *= width;
        EXPECT_GT(wanted_patches(sheet(16, 0.3f * edge, now)), 0u) << width;
    }
    ContactScene at_rest = sheet(16, 0.3f * edge, flat(16, 16));
    EXPECT_EQ(wanted_patches(at_rest), 0u);
    at_rest.motions[100] = {0, 0.5f * edge, 0, 0};
    EXPECT_GT(wanted_patches(at_rest), 0u);
    EXPECT_LT(wanted_patches(at_rest), 16u);
}

TEST(CalmPatches, TubesAsReference) {
    const std::vector<Vec4> rest = tube(0.5f);
    for (const float gap : {12.0f, 0.5f, 0.1f}) {
        ContactScene scene;
        scene.add(rest, tube(gap), tube_triangles(), 0.3f * edge);
        scene.jitter(0.02f * edge);
        expect_same_pairs(scene, gap < 0.2f ? 100 : 0);
        scene.add_motions(random_vectors(rest.size(), 0.2f * edge, 3));
        expect_same_pairs(scene);
    }
    ContactScene crumpled;
    crumpled.add(rest, smoothly(rest, 0.8f, 2), tube_triangles(), 0.3f * edge);
    expect_same_pairs(crumpled);
}

TEST(CalmPatches, SeveralSheetsInOneMeshAsReference) {
    for (const bool with_roof : {false, true})
        for (const float apart : {0.2f, 30.0f}) {
            const Sheets sheets(apart, with_roof);
            for (const float strength : {0.0f, 0.3f, 0.8f}) {
                ContactScene scene;
                std::vector<Vec4> now = sheets.rest;
                for (Vec4& p : now) {
                    const float y = p.y;
                    p = smoothly(p, strength, 5);
                    p.y += 0.01f * y;
                }
                scene.add(sheets.rest, now, sheets.triangles, 0.3f * edge);
                expect_same_pairs(scene, 100);
            }
        }
}

TEST(CalmPatches, SheetsOfOneMeshAreCalmEachForItself) {
    std::vector<Vec4> rest = flat(16, 16);
    for (const Vec4& p : flat(16, 16)) rest.push_back({p.x + 1, p.y, p.z, 0});
    std::vector<Triangle> triangles = grid_triangles(16, 16);
    for (const Triangle& t : grid_triangles(16, 16, 256)) triangles.push_back(t);
    ContactScene scene;
    scene.add(rest, rest, triangles, 0.3f * edge);
    EXPECT_EQ(wanted_patches(scene), 0u);
    for (std::size_t i = 256; i < rest.size(); ++i) scene.positions[i].x -= 1 - 0.3f * edge;
    EXPECT_GT(wanted_patches(scene), 0u);
    expect_same_pairs(scene, 100);
}

/// A sheet that waves, and goes on waving: smooth motions, longer than edges, and a jitter.
ContactScene fluttering(float strength, std::uint32_t seed, std::uint32_t side = 11) {
    const std::vector<Vec4> rest = flat(side, side);
    const std::vector<Vec4> now = smoothly(rest, strength, seed),
                            then = smoothly(now, 0.5f * strength, seed + 50);
    ContactScene scene = sheet(side, 0.3f * edge, now);
    scene.jitter(0.05f * edge);
    std::vector<Vec4> motions = random_vectors(now.size(), 0.05f * edge, seed);
    for (std::size_t i = 0; i < now.size(); ++i) {
        motions[i].x += then[i].x - now[i].x;
        motions[i].y += then[i].y - now[i].y;
        motions[i].z += then[i].z - now[i].z;
    }
    scene.add_motions(motions);
    return scene;
}

std::set<Corners> keys_of(const PairList& list) {
    std::set<Corners> keys;
    for (std::uint32_t k = 0; k < list.size; ++k)
        keys.insert(key_of(list.pairs[k].corners, k < list.vertex_triangle));
    return keys;
}

/// Looks for pairs that come within reach while all particles go the same part of these motions, and that are
/// not listed. Returns how many pairs come within reach.
std::size_t expect_listed(const ContactScene& scene, const std::vector<Vec4>& motions, const PairList& list) {
    const std::set<Corners> listed = keys_of(list);
    constexpr int parts = 6;
    std::vector<std::vector<Vec4>> places;
    for (int k = 0; k <= parts; ++k) {
        places.push_back(scene.positions);
        const float part = static_cast<float>(k) / parts;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            places.back()[i].x += part * motions[i].x;
            places.back()[i].y += part * motions[i].y;
            places.back()[i].z += part * motions[i].z;
        }
    }
    const std::vector<Vec4> none(motions.size());
    std::size_t near = 0, missed = 0;
    for_each_pair(scene, [&](const Corners& c, std::size_t of_a, double reach) {
        const bool comes_near = std::ranges::any_of(places, [&](const std::vector<Vec4>& at) {
            return reference_pair(c, of_a, at, none).distance < reach * (1 - margin);
        });
        near += comes_near;
        missed += comes_near && !listed.contains(key_of(c, of_a == 1));
    });
    EXPECT_EQ(missed, 0u);
    return near;
}

/// What is left of motions where some particles, one in `few`, are cut.
std::vector<Vec4> cut_at_random(std::vector<Vec4> motions, std::uint32_t few, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (Vec4& m : motions) {
        const float part = random() % few == 0 ? uniform(random) : 1;
        m = {part * m.x, part * m.y, part * m.z, 0};
    }
    return motions;
}

/// A search of a scene whose particles all go the same part of their motions, and what it listed.
struct SearchAlike {
    LaidOut<PairFinder> finder;
    Parallel parallel{1};
    LaidOut<PairList> list{1 << 18};

    explicit SearchAlike(const ContactScene& scene) {
        finder.reserve(scene.bodies, room_for_pairs);
        finder.find(parallel, scene.bodies, scene.positions, scene.motions, list, 1, FullList::has_the_first,
                    Parts::alike);
    }
};

TEST(CalmPatches, WhatAllGoesAlikeIsListedWhereItComesNear) {
    std::size_t near = 0, passed_over = 0;
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const ContactScene scene = fluttering(0.25f + 0.25f * static_cast<float>(seed % 3), seed);
        SearchAlike search(scene);
        near += expect_listed(scene, scene.motions, search.list);
        const LaidOut<PairList> all = pairs_of(scene);
        EXPECT_TRUE(std::ranges::includes(keys_of(all), keys_of(search.list)));
        passed_over += all.size - search.list.size;
    }
    EXPECT_GT(near, 100u);
    EXPECT_GT(passed_over, 1000u);
}

TEST(CalmPatches, OtherMotionsOpenWhatWasPassedOver) {
    std::size_t near = 0;
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        ContactScene scene = fluttering(0.25f, seed);
        const std::vector<Vec4> others = fluttering(0.75f, seed + 1).motions;
        SearchAlike search(scene);
        const std::vector<std::uint8_t> marks(scene.positions.size(),
                                              PairFinder::is_unlisted | PairFinder::has_strayed);
        search.finder.find_more(search.parallel, scene.bodies, scene.positions, others, marks, search.list);
        near += expect_listed(scene, others, search.list);
    }
    EXPECT_GT(near, 100u);
}

TEST(CalmPatches, WhatIsCutIsListedWhereItComesNear) {
    std::size_t near = 0, opened = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const ContactScene scene = fluttering(0.25f + 0.25f * static_cast<float>(seed % 3), seed);
        SearchAlike search(scene);
        const auto look_again = [&](const std::vector<Vec4>& cut) {
            return search.finder.find_opened(search.parallel, scene.bodies, scene.positions, scene.motions,
                                             cut, search.list);
        };
        EXPECT_FALSE(look_again(scene.motions)) << "nothing is cut";
        const std::vector<Vec4> cut = cut_at_random(scene.motions, seed < 6 ? 4 : 40, seed);
        opened += look_again(cut);
        near += expect_listed(scene, cut, search.list);
        EXPECT_FALSE(look_again(cut)) << "what is opened is listed";
        const std::vector<Vec4> cut_more = cut_at_random(cut, 4, seed + 1);
        look_again(cut_more);
        near += expect_listed(scene, cut_more, search.list);
        const LaidOut<PairList> all = pairs_of(scene);
        EXPECT_TRUE(std::ranges::includes(keys_of(all), keys_of(search.list)));
    }
    EXPECT_GT(near, 100u);
    EXPECT_GT(opened, 3u);
}

/// Pairs of neighbours that a search for all the same part of its motions passed over, and that one for these
/// motions does not, if all are asked for.
std::set<Corners> opened_by(const ContactScene& scene, const std::vector<Vec4>& cut) {
    SearchAlike search(scene);
    LaidOut<PairList> opened(1 << 18);
    const std::vector<std::uint8_t> all(cut.size(), PairFinder::has_strayed);
    search.finder.find_more(search.parallel, scene.bodies, scene.positions, cut, all, opened);
    return keys_of(opened);
}

// What goes the whole way again after a cut before is told apart from what does not. A search for crossings
// in between, whose boxes are smaller, does not matter.
TEST(CalmPatches, NeighboursOfWhichAParticleIsCutOpenAsIfAllWereAskedFor) {
    std::size_t opened = 0;
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        const ContactScene scene = fluttering(0.25f + 0.05f * static_cast<float>(seed % 6), seed, 15);
        SearchAlike search(scene);
        LaidOut<CrossingList> crossings(1 << 10);
        for (std::uint32_t k = 0; k < 2; ++k) {
            const std::vector<Vec4> cut = cut_at_random(scene.motions, seed % 2 == 0 ? 8 : 60, 2 * seed + k);
            search.finder.find_crossings(search.parallel, scene.bodies, scene.positions, crossings);
            search.finder.find_opened(search.parallel, scene.bodies, scene.positions, scene.motions, cut,
                                      search.list);
            const std::set<Corners> listed = keys_of(search.list), all = opened_by(scene, cut);
            const auto is_cut = [&](std::uint32_t i) { return xyz(cut[i]) != xyz(scene.motions[i]); };
            const auto is_missing = [&](const Corners& pair) {
                return std::ranges::any_of(pair, is_cut) && !listed.contains(pair);
            };
            EXPECT_EQ(std::ranges::count_if(all, is_missing), 0) << seed << " " << k;
            opened += all.empty() ? 0 : 1;
        }
    }
    EXPECT_GT(opened, 20u);
}

}  // namespace
}  // namespace weft::test
