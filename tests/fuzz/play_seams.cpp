// Cloth that is cut, and sewn.

#include "tests/fuzz/player.h"

namespace weft::fuzz {

/// Seams, and saves of single cloths, in a script.
Player::Answered Player::make(const Operation& operation, const Stitch& call) {
    std::optional<SeamId>& seam = seams_.emplace_back();
    const bool is_left_out = options_.without && call.other == *options_.without;
    if (is_left_out || !cloths_[call.other]) return std::nullopt;
    const auto made = world_.stitch(*cloths_[operation.cloth], call.vertices, *cloths_[call.other],
                                    call.others, call.settings);
    if (!made) return made.error();
    seam = *made;
    const SeamInfo info = world_.seam_info(*made).value();
    check(info.stitches == call.vertices.size() && info.holding == info.stitches,
          "a new seam has other stitches than were given");
    return Result<void>();
}

Player::Answered Player::make(const Operation&, const Unstitch& call) {
    const auto& id = seams_[call.seam];
    if (!id) return std::nullopt;
    const bool there = world_.seam_info(*id).ok();
    const auto answer = world_.unstitch(*id);
    check(there == answer.ok(), "unstitching a seam that is there must work, and once only");
    check(!world_.seam_info(*id).ok(), "the seam is still there");
    return std::nullopt;
}

void Player::check_seams(const StepReport& report) const {
    std::uint32_t broken = 0;
    for (const auto& id : seams_) {
        const auto info = id ? world_.seam_info(*id) : Result<SeamInfo>(SeamInfo{});
        if (!info) continue;
        broken += info->stitches - info->holding;
        check(info->holding <= info->stitches, "more stitches hold than there are");
        check(std::isfinite(info->tightest) && info->tightest >= 0, "a tension that is none");
    }
    check(report.broken_stitches <= broken, "more stitches broke in the step than are broken");
}

std::vector<std::byte> Player::saved_cloth(ClothId id) const {
    std::vector<std::byte> bytes(world_.cloth_save_size(id));
    check(bytes.empty() || world_.save_cloth(id, bytes).ok(), "a cloth cannot be saved");
    return bytes;
}

Player::Answered Player::make(const Operation& operation, const SaveCloth&) {
    const std::string before = snapshot_now();
    KeptCloth& kept = cloth_saves_.emplace_back();
    if (!is_there(operation.cloth)) return std::nullopt;
    kept = {saved_cloth(*cloths_[operation.cloth]), pins_[operation.cloth],
            world_.cloth_info(*cloths_[operation.cloth])->vertices};
    check(snapshot_now() == before, "saving a cloth changed the World");
    return Result<void>();
}

/// Where the cloth has other vertices by now, another of the same size could take it.
Player::Answered Player::make(const Operation& operation, const RestoreCloth& call) {
    const KeptCloth& kept = cloth_saves_[call.save];
    if (kept.bytes.empty() || !is_there(operation.cloth)) return std::nullopt;
    const ClothId id = *cloths_[operation.cloth];
    if (world_.cloth_info(id)->vertices != kept.vertices) return std::nullopt;
    const auto answer = world_.restore_cloth(id, kept.bytes);
    if (answer) pins_[operation.cloth] = kept.pins;
    return answer;
}

// Cloth that is cut in a script.

/// Pins of copies are put apart: where they are to be is said anew.
Player::Answered Player::make(const Operation& operation, const Recut& call) {
    const ClothId id = *cloths_[operation.cloth];
    const auto view_before = world_.cloth(id);
    const std::vector<std::uint32_t> before =
        view_before
            ? std::vector(view_before->vertex_to_particle.begin(), view_before->vertex_to_particle.end())
            : std::vector<std::uint32_t>();
    const std::string unchanged = snapshot_now();
    const auto answer = world_.recut_cloth(id, call.cut.mesh, call.cut.from);
    if (!answer && operation.answer == Answer::either && view_before) {
        // The script goes on with vertices that this cloth does not have.
        check(snapshot_now() == unchanged, "failed (" + answer.error().message + ") and changed the World");
        check(world_.remove_cloth(id).ok(), "a cloth is not there any more");
        return std::nullopt;
    }
    if (!answer) return answer;
    std::map<std::uint32_t, Vec3> now;
    for (std::uint32_t v = 0; v < call.cut.from.size(); ++v) {
        const auto pin = pins_[operation.cloth].find(before[call.cut.from[v]]);
        if (pin == pins_[operation.cloth].end()) continue;
        now[particle(operation.cloth, v)] = pin->second;
        check(world_.move_pin(id, v, pin->second).ok(), "a copy of what is pinned is not");
    }
    pins_[operation.cloth] = std::move(now);
    return answer;
}

}  // namespace weft::fuzz
