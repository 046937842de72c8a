#pragma once
// Maps the parts of a person to a skeleton's joints, under the names that motion files use.

#include <array>

#include "demo/character/motion/motion.h"
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
    std::size_t spine = 0;  ///< joint nearest to half way from hips to chest; may be the chest

    /// Is true if the rig has toes; where it has none, the foot's joint stands for them.
    [[nodiscard]] bool has_toes(bool left) const {
        return left ? (*this)[Part::left_toes] != (*this)[Part::left_foot]
                    : (*this)[Part::right_toes] != (*this)[Part::right_foot];
    }
    [[nodiscard]] std::size_t operator[](Part part) const { return of_part[static_cast<std::size_t>(part)]; }
};

/// Finds joints by the names of the CMU database, of Mixamo and of cgspeed. Error: lists the missing joints,
/// each with its possible names; toes may be missing.
[[nodiscard]] Result<BodyJoints> find_body_joints(const Skeleton& skeleton);

}  // namespace weft::demo
