// A World's seams: which cloths they join, and the memory that they need.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "cloth/simulation/sewn.h"
#include "cloth/simulation/simulation.h"

namespace weft {

namespace {

/// The cloths of a seam, each once.
std::vector<Cloth*> cloths_of(Simulation& world, const SeamState& seam) {
    std::vector<Cloth*> cloths;
    for (const ClothId id : seam.cloths) {
        Cloth* const cloth = world.cloths.find(id)->get();
        if (std::ranges::find(cloths, cloth) == cloths.end()) cloths.push_back(cloth);
    }
    return cloths;
}

std::vector<SeamRows*> with(const std::vector<SeamRows*>& list, SeamRows* more) {
    std::vector<SeamRows*> sum = list;
    const auto index = [](const SeamRows* rows) { return rows->id().index; };
    sum.insert(std::ranges::lower_bound(sum, more->id().index, {}, index), more);
    return sum;
}

}  // namespace

// The seam's id is known only once it has its place: whatever fails after that takes it back.
SeamId Simulation::add_seam(SeamState&& seam) {
    const std::vector<Cloth*> joined = cloths_of(*this, seam);
    const std::size_t stitches = seam.stitches.size();
    const SeamId id = state.seams.insert(std::move(seam));
    std::vector<SeamBuffers> buffers;
    Sewn sewn;
    Room room;
    or_undo(
        [&] {
            if (seam_rows.size() <= id.index) seam_rows.resize(id.index + 1);
            seam_rows[id.index] = std::make_unique<SeamRows>(id, stitches);
            std::vector<Newcomer> newcomers;
            for (Cloth* cloth : joined) {
                buffers.push_back(cloth->make_seams(with(cloth->seams, seam_rows[id.index].get())));
                newcomers.push_back({cloth, buffers.back().scratch_bytes, cloth->settings.self_collision,
                                     cloth->contact_mesh.get(), true});
            }
            room = make_room(newcomers, parallel.width());
            sewn = sew(*this, state.seams.find(id)->cloths.front());
        },
        [&] { state.seams.erase(id); });

    // From here on nothing can fail.
    take(std::move(room));
    sewn.give_to(*this);
    for (std::size_t k = 0; k < joined.size(); ++k) {
        joined[k]->take_seams(std::move(buffers[k]));
        joined[k]->wake();
    }
    return id;
}

void Simulation::remove_seams(std::span<const SeamId> seams) {
    const std::vector<Sewn> left = sew_after(*this, {.removed = seams});

    // From here on nothing can fail.
    for (const Sewn& sewn : left) sewn.give_to(*this);
    for (const SeamId id : seams) {
        for (const ClothId of : state.seams.find(id)->cloths) {
            Cloth& cloth = **cloths.find(of);
            cloth.drop_seam(seam_rows[id.index].get());
            cloth.wake();
        }
        seam_rows[id.index].reset();
        state.seams.erase(id);
    }
}

SeamInfo Simulation::info_of(SeamId id) const {
    const SeamState& seam = *state.seams.find(id);
    const SeamRows& rows = *seam_rows[id.index];
    return {.a = seam.cloths[0],
            .b = seam.cloths[1],
            .stitches = static_cast<std::uint32_t>(seam.stitches.size()),
            .holding = static_cast<std::uint32_t>(std::ranges::count(seam.holds, 1u)),
            .force = to_vec3(rows.force()),
            .tightest = rows.tightest()};
}

void Simulation::wake_joined(const Cloth& cloth) noexcept {
    for (const SeamRows* rows : cloth.seams)
        for (const ClothId id : state.seams.find(rows->id())->cloths) (*cloths.find(id))->wake();
}

}  // namespace weft
