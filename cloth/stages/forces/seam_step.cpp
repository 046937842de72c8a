#include "cloth/stages/forces/seam_step.h"

#include <algorithm>
#include <array>
#include <utility>

namespace weft {

namespace {

const Cloth& cloth_of(const Simulation& world, ClothId id) {
    return **world.cloths.find(id);
}

bool is_present(const Simulation& world, const Cloth& cloth) {
    return cloth.place < world.present.size() && world.present[cloth.place] == &cloth;
}

bool has_contact(const Cloth& cloth) {
    return cloth.settings.self_collision.method == SelfCollisionMethod::contact;
}

/// Contact keeps the cloths' features apart, so stitches that were shorter would fight it.
float least_length(const Cloth& a, const Cloth& b) {
    if (!has_contact(a) || !has_contact(b) || !may_meet(a, b)) return 0;
    return 0.5f * (a.as_body().radius + b.as_body().radius);
}

SeamRows::Law law_of(const SeamSettings& settings, const Cloth& a, const Cloth& b, float gamma) {
    const Fabric &of_a = a.settings.fabric, &of_b = b.settings.fabric;
    const float stiffest = std::max({1.0f, of_a.warp, of_a.weft, of_b.warp, of_b.weft});
    return {.stiffness = settings.stiffness > 0 ? settings.stiffness : stiffest,
            .rest_length = std::max(settings.rest_length, least_length(a, b)),
            .break_force = settings.break_force,
            .gamma = gamma};
}

SeamRows::Side side_of(const Cloth& cloth) {
    if (cloth.equation == nullptr) return {SeamRows::Side::fixed, cloth.state.positions.span()};
    return {cloth.equation->first, cloth.equation->base_positions};
}

/// visit(rows, state) for the seams of these cloths, each once.
template <class Visit>
void for_each_seam(Simulation& world, std::span<Cloth* const> set, const Visit& visit) {
    for (const Cloth* cloth : set)
        for (SeamRows* rows : cloth->seams) {
            SeamState& seam = *world.state.seams.find(rows->id());
            const Cloth &a = cloth_of(world, seam.cloths[0]), &b = cloth_of(world, seam.cloths[1]);
            const Cloth& leader = a.equation != nullptr ? a : b;
            if (cloth == &leader) visit(*rows, seam, a, b);
        }
}

}  // namespace

bool joins_cloths(const Simulation& world) {
    bool any = false;
    world.state.seams.for_each([&](SeamId, const SeamState& seam) {
        any = any || (seam.cloths[0] != seam.cloths[1] && cloth_of(world, seam.cloths[0]).was_stepped &&
                      cloth_of(world, seam.cloths[1]).was_stepped);
    });
    return any;
}

void join_seams(Simulation& world) {
    if (world.state.seams.size() == 0) return;
    for (std::uint32_t i = 0; i < world.present.size(); ++i) world.present[i]->place = i;
    world.state.seams.for_each([&](SeamId, const SeamState& seam) {
        const Cloth &a = cloth_of(world, seam.cloths[0]), &b = cloth_of(world, seam.cloths[1]);
        if (is_present(world, a) && is_present(world, b)) world.group_finder.join(a.place, b.place);
    });
    world.group_finder.end();
}

void agree_on_order(std::span<Cloth* const> group, float h) {
    const auto goes_first_order = [&](const Cloth* cloth) {
        return !cloth->seams.empty() && !cloth->bdf_of(h).is_second_order();
    };
    if (std::ranges::none_of(group, goes_first_order)) return;
    for (Cloth* cloth : group)
        if (!cloth->seams.empty()) cloth->state.record.h = 0;
}

void begin_seams(Simulation& world, std::span<Cloth* const> set, float gamma) {
    for_each_seam(world, set, [&](SeamRows& rows, SeamState& seam, const Cloth& a, const Cloth& b) {
        rows.begin(seam, law_of(seam.settings, a, b, gamma), {side_of(a), side_of(b)});
    });
}

void end_seams(Simulation& world, std::span<Cloth* const> set) {
    for (const Cloth* cloth : set)
        for (SeamRows* rows : cloth->seams)
            rows->take(cloth->equation->first, std::as_const(cloth->scratch_velocities).span());
    for_each_seam(world, set,
                  [](SeamRows& rows, SeamState& seam, const Cloth&, const Cloth&) { rows.finish(seam); });
}

}  // namespace weft
