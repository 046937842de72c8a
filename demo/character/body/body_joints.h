#pragma once
// Which of a skeleton's joints is what part of a person, whatever the file calls them.

#include <array>

#include "demo/character/motion/skeleton.h"
#include "weft/error.h"

namespace weft::demo {

enum class Part : std::uint8_t {
    hips,
    chest,
    neck,
    head,
    left_arm,
    left_forearm,
    left_hand,
    left_thigh,
    left_shin,
    left_foot,
    left_toes,
    right_arm,
    right_forearm,
    right_hand,
    right_thigh,
    right_shin,
    right_foot,
    right_toes,
    count
};

struct BodyJoints {
    std::array<std::size_t, static_cast<std::size_t>(Part::count)> of_part{};
    std::size_t spine =
        0;  ///< between hips and chest, nearest to their middle; the chest where there is none

    [[nodiscard]] std::size_t operator[](Part part) const { return of_part[static_cast<std::size_t>(part)]; }
};

/// By the names of the CMU database, of Mixamo and of cgspeed. Error: the joints that are missing, each with
/// the names that it could have.
[[nodiscard]] Result<BodyJoints> find_body_joints(const Skeleton& skeleton);

}  // namespace weft::demo
