#pragma once
// What the steps of a World that has bodies need; each body has a number, its place in the order of ids.
//
// Cloths that may meet the same body are a group, and those of its cloths whose method can have bodies as
// unknowns are one equation with them. In each part of a substep each of the group's equations takes the
// bodies along in turn: from where they were when the part began, with gravity, what the other equations'
// cloths give or, if these are still to come, gave in the last substep, and what its own give. The last to
// take them brings them where they go on.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/bodies/body_coupling.h"
#include "cloth/contact/group_finder.h"
#include "cloth/equation/moving_body.h"
#include "weft/body.h"

namespace weft {

/// Impulses and angular ones, as states have them and as they are reckoned with.
[[nodiscard]] inline Vector6 to_vector6(const std::array<float, 6>& values) {
    return Eigen::Map<const Eigen::Matrix<float, 6, 1>>(values.data()).cast<double>();
}
[[nodiscard]] inline std::array<float, 6> to_floats(const Vector6& v) {
    std::array<float, 6> values{};
    Eigen::Map<Eigen::Matrix<float, 6, 1>>(values.data()) = v.cast<float>();
    return values;
}

struct BodyStage {
    /// Room for so many.
    BodyStage(std::size_t bodies, std::size_t cloths, std::size_t colliders) {
        moving.resize(bodies);
        begins.resize(bodies);
        settings.resize(bodies);
        given.resize(bodies);
        impulses.resize(bodies);
        first_cloths.resize(bodies);
        reserve(cloths, colliders);
    }
    void reserve(std::size_t cloths, std::size_t colliders) {
        coupling.reserve(moving.size(), cloths);
        sharing.reserve(cloths);
        carried.reserve(colliders);
    }

    void remove_last() noexcept {
        moving.pop_back();
        begins.pop_back();
        settings.pop_back();
        given.pop_back();
        impulses.pop_back();
        first_cloths.pop_back();
    }

    struct Begin {
        BodyPose pose;
        Vector6 velocity = Vector6::Zero();
    };

    std::vector<MovingBody> moving;
    std::vector<Begin> begins;  ///< where a cloth takes them from
    std::vector<BodySettings> settings;
    std::vector<Vector6> given;         ///< by cloths, in the step so far
    std::vector<BodyImpulse> impulses;  ///< of the last step
    std::vector<CarriedCollider> carried;
    BodyCoupling coupling;
    GroupFinder sharing;                      ///< cloths that may meet one body, which gives way to them
    std::vector<std::uint32_t> first_cloths;  ///< the first that may meet each body, while these are found
    float h = 0;                              ///< of what a cloth takes them along for [s]
    bool were_taken = false;                  ///< in this substep
};

}  // namespace weft
