#include "cloth/simulation/sewn.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <memory>
#include <utility>

#include "cloth/solver/levels/levels.h"
#include "cloth/solver/levels/multigrid.h"
#include "cloth/solver/make_system.h"

namespace weft {

namespace {

bool is_below(ClothId a, ClothId b) {
    return a.index < b.index;
}

std::vector<const SeamState*> seams_after(const Simulation& world, const SewnChange& change) {
    std::vector<const SeamState*> seams;
    world.state.seams.for_each([&](SeamId id, const SeamState& seam) {
        if (std::ranges::find(change.removed, id) != change.removed.end()) return;
        const auto moved = std::ranges::find(change.moved, id, &std::pair<SeamId, SeamState>::first);
        seams.push_back(moved != change.moved.end() ? &moved->second : &seam);
    });
    return seams;
}

/// Adds the cloths that seams join to those given, until there are no more. Returns the seams between them.
std::vector<const SeamState*> gather(std::span<const SeamState* const> seams, std::vector<ClothId>& cloths) {
    const auto is_in = [&](ClothId id) { return std::ranges::find(cloths, id) != cloths.end(); };
    for (std::size_t before = 0; before != cloths.size();) {
        before = cloths.size();
        for (const SeamState* seam : seams)
            for (std::size_t side = 0; side < 2; ++side)
                if (is_in(seam->cloths[side]) && !is_in(seam->cloths[1 - side]))
                    cloths.push_back(seam->cloths[1 - side]);
    }
    std::ranges::sort(cloths, is_below);
    std::vector<const SeamState*> between;
    std::ranges::copy_if(seams, std::back_inserter(between),
                         [&](const SeamState* seam) { return is_in(seam->cloths[0]); });
    return between;
}

/// A cloth's system at rest, from which levels are made.
struct RestingSystem {
    std::unique_ptr<ImplicitSystem> system;
    AlignedBuffer<Vec4> positions;
    std::size_t pairs;

    RestingSystem(const ClothModel& model, const ClothSettings& settings)
        : system(make_system(model, settings)),
          positions(linearise_at_rest(model, *system)),
          pairs(settings.self_collision.method == SelfCollisionMethod::contact
                    ? FeatureContact::room_for_rows(model.particle_count)
                    : 0) {}
};

}  // namespace

bool Sewn::has(ClothId id) const {
    return std::ranges::find(cloths, id) != cloths.end();
}

void Sewn::give_to(Simulation& world) const noexcept {
    for (std::uint32_t k = 0; k < cloths.size(); ++k)
        (*world.cloths.find(cloths[k]))->sewn = {levels, levels ? k : 0, k == 0 ? bytes : 0};
}

Sewn sew(Simulation& world, ClothId cloth, const SewnChange& change) {
    Sewn sewn;
    sewn.cloths = {cloth};
    const std::vector<const SeamState*> seams = gather(seams_after(world, change), sewn.cloths);
    if (seams.empty()) return sewn;
    std::vector<RestingSystem> systems;
    std::vector<Multigrid::Source> sources;
    systems.reserve(sewn.cloths.size());
    std::size_t pairs = 0;
    for (const ClothId id : sewn.cloths) {
        const Cloth& of = change.cut.second != nullptr && change.cut.first == id ? *change.cut.second
                                                                                 : **world.cloths.find(id);
        const RestingSystem& added =
            systems.emplace_back(of.model, change.other.first == &of ? *change.other.second : of.settings);
        sources.push_back({*added.system, added.positions.span()});
        pairs += added.pairs;
    }
    const std::vector<std::uint32_t> firsts = Multigrid::first_particles(sources);
    std::vector<Link> stitches;
    for (const SeamState* seam : seams) {
        std::array<std::uint32_t, 2> first;
        for (std::size_t side = 0; side < 2; ++side)
            first[side] = firsts[static_cast<std::size_t>(std::ranges::find(sewn.cloths, seam->cloths[side]) -
                                                          sewn.cloths.begin())];
        for (const Stitch& stitch : seam->stitches) {
            const std::uint32_t a = first[0] + stitch.particles[0], b = first[1] + stitch.particles[1];
            if (a != b) stitches.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    Parallel serial(1);
    sewn.levels = std::make_shared<Multigrid>(serial, sources, std::move(stitches));
    Scratch measured;
    sewn.levels->lay_out(measured, pairs);
    sewn.bytes = sewn.levels->bytes() + measured.bytes();
    sewn.levels->lay_out_alone(pairs);
    return sewn;
}

// A cloth knows its id only after its first step; its seams know it from the start.
Sewn sew_again(Simulation& world, const Cloth& cloth, const SewnChange& change) {
    return sew(world, world.state.seams.find(cloth.seams.front()->id())->cloths.front(), change);
}

std::vector<Sewn> sew_after(Simulation& world, const SewnChange& change) {
    std::vector<Sewn> all;
    for (const SeamId seam : change.removed)
        for (const ClothId id : world.state.seams.find(seam)->cloths)
            if (std::ranges::none_of(all, [&](const Sewn& sewn) { return sewn.has(id); }))
                all.push_back(sew(world, id, change));
    return all;
}

}  // namespace weft
