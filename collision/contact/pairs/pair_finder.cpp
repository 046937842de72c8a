#include "collision/contact/pairs/pair_finder.h"

#include <algorithm>

#include "engine/vector.h"

namespace weft {

namespace {

/// Room for a block's crossings until all are counted. A block with more is searched again.
constexpr std::uint32_t kept_crossings = 64;

/// `count` items from `first` on, or as many as the list has.
template <class Item>
std::span<Item> part_of(std::span<Item> list, std::size_t first, std::size_t count) {
    const std::size_t begin = std::min(first, list.size());
    return list.subspan(begin, std::min(count, list.size() - begin));
}

/// Number of groups of triangles whose gradients a search keeps.
std::uint32_t groups_of_gradients(const ContactMesh& mesh) {
    return mesh.flat_rest().is_empty() ? 0 : mesh.triangle_slots().groups();
}

}  // namespace

void PairFinder::Room::add(const ContactMesh& mesh) {
    const std::size_t patches = mesh.patches().size();
    ++bodies;
    vertices += mesh.vertex_slots().groups();
    triangles += mesh.triangle_slots().groups();
    edges += mesh.edge_slots().groups();
    gradients += groups_of_gradients(mesh);
    neighbours += mesh.flat_rest().pairs();
    blocks += (patches + PatchBlock::most - 1) / PatchBlock::most;
}

void PairFinder::lay_out_boxes(Scratch& scratch, const Room& room) {
    const std::size_t blocks = room.blocks;
    const std::size_t groups = (blocks + 15) / 16;
    scratch.take(bodies_, room.bodies);
    scratch.take(blocks_, blocks);
    scratch.take(is_calm_, blocks);
    scratch.take(boxes_.vertices, room.vertices);
    scratch.take(boxes_.triangles, room.triangles);
    scratch.take(boxes_.edges, room.edges);
    scratch.take(boxes_.patches, blocks);
    scratch.take(boxes_.blocks, groups);
    scratch.take(boxes_.groups, (groups + 15) / 16);
    scratch.take(boxes_.strains, blocks * PatchBlock::most);
    scratch.take(boxes_.gradients, room.gradients);
    scratch.take(boxes_.wanted_gradients, room.gradients);
    scratch.take(boxes_.neighbours, room.neighbours);
    scratch.take(of_crossings_, room.neighbours);
    scratch.take(boxes_.wanted, blocks * PatchBlock::most);
    scratch.take(block_pairs_, blocks);
    fill_.lay_out(scratch, blocks);
    scratch.take(crossing_room_, blocks * kept_crossings);
    scratch.take(block_crossings_, blocks);
    scratch.take(only_, blocks);
    scratch.take(strayed_, blocks);
}

void PairFinder::choose(std::span<const ContactBody> bodies) {
    std::uint32_t vertices = 0, triangles = 0, edges = 0, gradients = 0, neighbours = 0;
    block_count_ = 0;
    for (std::uint32_t k = 0; k < bodies.size(); ++k) {
        const ContactBody& body = bodies[k];
        const ContactMesh& mesh = *body.mesh;
        bodies_[k] = {&mesh,    body.first, body.reach, body.layer,   body.mask, body.meets_itself,
                      vertices, triangles,  edges,      block_count_, gradients, neighbours};
        vertices += mesh.vertex_slots().groups();
        triangles += mesh.triangle_slots().groups();
        edges += mesh.edge_slots().groups();
        gradients += groups_of_gradients(mesh);
        neighbours += mesh.flat_rest().pairs();
        const auto patches = static_cast<std::uint32_t>(mesh.patches().size());
        for (std::uint32_t first = 0; first < patches; first += PatchBlock::most)
            blocks_[block_count_++] = {k, first, std::min(patches - first, PatchBlock::most)};
    }
    body_count_ = bodies.size();
    neighbour_count_ = neighbours;
}

PairSearch PairFinder::search_of(std::span<const Vec4> positions, const Vec4* motions,
                                 float of_borders) const {
    return {bodies_.span().first(body_count_),
            blocks_.span().first(block_count_),
            &boxes_,
            positions.data(),
            motions,
            of_borders};
}

void PairFinder::find(Parallel& parallel, std::span<const ContactBody> bodies,
                      std::span<const Vec4> positions, std::span<const Vec4> motions, PairList& found,
                      float of_borders, FullList full, Parts parts) {
    choose(bodies);
    found.clear();
    PairSearch all = search_of(positions, motions.data(), of_borders);
    all.together = parts == Parts::alike;
    search(parallel, all, found, full);
}

PairSearch PairFinder::search_of_marked(Parallel& parallel, std::span<const Vec4> positions,
                                        const Vec4* motions, const auto& marks_of) {
    parallel.blocks(block_count_, [&](std::uint32_t block) {
        const PatchBlock& patches = blocks_[block];
        const SearchedBody& body = bodies_[patches.body];
        const std::span<const std::uint32_t> all = body.mesh->corner_slots().corners[0].span();
        std::uint32_t only = 0, strayed = 0;
        for (std::uint32_t p = 0; p < patches.patch_count; ++p) {
            const SlotSpan& corners = body.mesh->patches()[patches.first_patch + p].corners;
            std::uint32_t marks = 0;
            for (const std::uint32_t i : all.subspan(corners.first, corners.count))
                marks |= std::uint32_t{marks_of(body.first + i)};
            only |= ((marks & is_unlisted) != 0 ? 1u : 0u) << p;
            strayed |= ((marks & has_strayed) != 0 ? 1u : 0u) << p;
        }
        only_[block] = static_cast<std::uint16_t>(only);
        strayed_[block] = static_cast<std::uint16_t>(strayed);
    });
    PairSearch search = search_of(positions, motions, 1);
    search.together = true;
    search.only = only_.data();
    search.strayed = strayed_.data();
    return search;
}

void PairFinder::find_more(Parallel& parallel, std::span<const ContactBody> bodies,
                           std::span<const Vec4> positions, std::span<const Vec4> motions,
                           std::span<const std::uint8_t> marks, PairList& list) {
    choose(bodies);
    const PairSearch marked =
        search_of_marked(parallel, positions, motions.data(), [&](std::uint32_t i) { return marks[i]; });
    search(parallel, marked, list, FullList::is_empty);
}

bool PairFinder::find_opened(Parallel& parallel, std::span<const ContactBody> bodies,
                             std::span<const Vec4> positions, std::span<const Vec4> motions,
                             std::span<const Vec4> cut, PairList& list) {
    choose(bodies);
    if (neighbour_count_ == 0) return false;
    PairSearch opened = search_of_marked(parallel, positions, cut.data(), [&](std::uint32_t i) {
        return xyz(cut[i]) == xyz(motions[i]) ? std::uint8_t{0} : has_strayed;
    });
    ask_neighbours(parallel, opened);
    const std::span<const Neighbours> neighbours = boxes_.neighbours.span().first(neighbour_count_);
    if (std::ranges::find(neighbours, Neighbours::opened) == neighbours.end()) return false;
    opened.motions = motions.data();
    place(parallel, opened);
    list_pairs(parallel, opened, list, FullList::is_empty);
    return true;
}

void PairFinder::search(Parallel& parallel, const PairSearch& search, PairList& found, FullList full) {
    place(parallel, search);
    ask_neighbours(parallel, search);
    list_pairs(parallel, search, found, full);
}

void PairFinder::list_pairs(Parallel& parallel, const PairSearch& search, PairList& found, FullList full) {
    want(parallel, search);
    count_pairs(parallel, search, static_cast<std::uint32_t>(found.capacity()) - found.size, full);
    number(found);
    if (found.overflowed && full == FullList::is_empty) {
        found.size = found.vertex_triangle = 0;
        return;
    }
    parallel.blocks(block_count_, [&](std::uint32_t block) { write(search, block, found); });
}

void PairFinder::find_block(const PairSearch& search, std::uint32_t block, FoundPairs& pairs) const {
    if (is_calm_[block] == 0) find_pairs(search, block, pairs);
}

void PairFinder::count_pairs(Parallel& parallel, const PairSearch& search, std::uint32_t capacity,
                             FullList full) {
    fill_.begin(block_count_, capacity, full);
    pool_.begin();
    parallel.blocks(block_count_, [&](std::uint32_t block) {
        FoundPairs pairs{PairsOfBlock(pool_), PairsOfBlock(pool_), &fill_, block};
        find_block(search, block, pairs);
        block_pairs_[block] = {{pairs.vertex_triangle.count, pairs.vertex_triangle.first_chunk()},
                               {pairs.edge_edge.count, pairs.edge_edge.first_chunk()}};
    });
}

void PairFinder::find_crossings(Parallel& parallel, std::span<const ContactBody> bodies,
                                std::span<const Vec4> positions, CrossingList& found) {
    choose(bodies);
    for (SearchedBody& body : bodies_.span()) body.reach = 0;
    const PairSearch search = search_of(positions, nullptr, 1);
    const auto room_of_block = [&](std::uint32_t block) {
        return crossing_room_.span().subspan(std::size_t{block} * kept_crossings, kept_crossings);
    };
    std::swap(boxes_.neighbours, of_crossings_);
    place(parallel, search);
    ask_neighbours(parallel, search);
    want(parallel, search);
    parallel.blocks(block_count_, [&](std::uint32_t block) {
        FoundCrossings crossings{room_of_block(block)};
        if (is_calm_[block] == 0) weft::find_crossings(search, block, crossings);
        block_crossings_[block] = crossings.count;
    });

    std::uint64_t count = 0;
    for (std::uint32_t block = 0; block < block_count_; ++block) {  // serial: most blocks have none
        const std::span<Crossing> to =
            part_of(found.crossings.span(),
                    static_cast<std::size_t>(std::min<std::uint64_t>(count, found.capacity())),
                    block_crossings_[block]);
        count += block_crossings_[block];
        FoundCrossings again{to};
        if (block_crossings_[block] > kept_crossings)
            weft::find_crossings(search, block, again);
        else
            std::copy_n(room_of_block(block).begin(), to.size(), to.begin());
    }
    found.size = static_cast<std::uint32_t>(std::min<std::uint64_t>(count, found.capacity()));
    found.overflowed = count > found.capacity();
    std::swap(boxes_.neighbours, of_crossings_);
}

void PairFinder::place(Parallel& parallel, const PairSearch& search) {
    parallel.blocks(block_count_, [&](std::uint32_t block) {
        set_box(boxes_.blocks[block / 16], block % 16, place_patches(search, block, boxes_));
    });
    // The boxes behind the last one are empty.
    const std::uint32_t groups = (block_count_ + 15) / 16;
    for (std::uint32_t k = block_count_; k < 16 * groups; ++k) set_box(boxes_.blocks[k / 16], k % 16, no_box);
    for (std::uint32_t k = 0; k < 16 * boxes_.groups.size(); ++k)
        set_box(boxes_.groups[k / 16], k % 16, k < groups ? hull(boxes_.blocks[k]) : no_box);
}

void PairFinder::ask_neighbours(Parallel& parallel, const PairSearch& search) {
    if (neighbour_count_ == 0) return;
    if (search.only != nullptr) {
        std::ranges::fill(boxes_.wanted_gradients.span(), std::uint8_t{0});
        parallel.blocks(block_count_, [&](std::uint32_t block) { want_gradients(search, block, boxes_); });
    }
    parallel.blocks(block_count_, [&](std::uint32_t block) { place_gradients(search, block, boxes_); });
    parallel.blocks(block_count_, [&](std::uint32_t block) { find_neighbours(search, block, boxes_); });
}

void PairFinder::want(Parallel& parallel, const PairSearch& search) {
    std::ranges::fill(boxes_.wanted.span().first(block_count_ * PatchBlock::most), std::uint8_t{0});
    parallel.blocks(block_count_, [&](std::uint32_t block) {
        is_calm_[block] = want_features(search, block, boxes_) ? 0 : 1;
    });
    if (std::ranges::all_of(is_calm_.span().first(block_count_), [](std::uint8_t calm) { return calm == 1; }))
        return;
    parallel.blocks(block_count_, [&](std::uint32_t block) { place_features(search, block, boxes_); });
}

// Pairs of edges that are in the list already move back, to make room for new pairs of vertices.
void PairFinder::number(PairList& found) {
    const std::uint32_t had_vertex_triangle = found.vertex_triangle, had = found.size;
    std::uint64_t count = had_vertex_triangle;
    const auto take = [&](std::uint32_t pairs) {
        const std::uint64_t first = std::min<std::uint64_t>(count, found.capacity());
        count += pairs;
        return static_cast<std::uint32_t>(first);
    };
    const auto blocks = block_pairs_.span().first(block_count_);
    for (PairsOfBothKinds& block : blocks) block.vertex_triangle.first = take(block.vertex_triangle.count);
    found.vertex_triangle = take(had - had_vertex_triangle);
    for (PairsOfBothKinds& block : blocks) block.edge_edge.first = take(block.edge_edge.count);
    found.size = take(0);
    found.overflowed = count > found.capacity();
    if (found.overflowed || had == had_vertex_triangle) return;
    const std::uint32_t end = found.vertex_triangle + had - had_vertex_triangle;
    const auto move = [&](auto* items) {
        std::copy_backward(items + had_vertex_triangle, items + had, items + end);
    };
    move(found.pairs.data());
    move(found.shapes.data());
}

void PairFinder::write(const PairSearch& search, std::uint32_t block, PairList& found) {
    const auto& [of_vertices, of_edges] = block_pairs_[block];
    const auto place_of = [&](const BlockPairs& pairs) {
        return part_of(found.pairs.span(), pairs.first, pairs.count);
    };
    const std::span<FeaturePair> vertex_triangle = place_of(of_vertices), edge_edge = place_of(of_edges);
    const auto has_room = [](const BlockPairs& pairs, std::span<FeaturePair> place) {
        return place.empty() || pairs.chunk != PairPool::none;
    };
    if (has_room(of_vertices, vertex_triangle) && has_room(of_edges, edge_edge)) {
        pool_.copy(of_vertices.chunk, vertex_triangle);
        pool_.copy(of_edges.chunk, edge_edge);
    } else {
        FoundPairs pairs{PairsOfBlock(vertex_triangle), PairsOfBlock(edge_edge)};
        find_block(search, block, pairs);
    }
    shape_pairs(search.positions, true, vertex_triangle, found.shapes.data() + of_vertices.first);
    shape_pairs(search.positions, false, edge_edge, found.shapes.data() + of_edges.first);
}

}  // namespace weft
