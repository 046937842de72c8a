// Cloth that is cut in a script.

#include "tests/fuzz/player.h"

namespace weft::fuzz {

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
