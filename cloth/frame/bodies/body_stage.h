#pragma once
// What the steps of a World that has bodies need; each body has a number, its place in the order of ids.
//
// Within a substep each cloth, or island, that may meet bodies takes them along in turn: from where they were
// when it began, with gravity, what the other cloths give in it as far as that is known, and what this one
// gives. The last to take them brings them where they go on.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/system/bodies/body_coupling.h"
#include "cloth/system/bodies/moving_body.h"
#include "weft/body.h"

namespace weft {

struct BodyStage {
    /// Room for so many.
    BodyStage(std::size_t bodies, std::size_t cloths, std::size_t colliders) {
        moving.resize(bodies);
        begins.resize(bodies);
        settings.resize(bodies);
        given.resize(bodies);
        impulses.resize(bodies);
        reserve(cloths, colliders);
    }
    void reserve(std::size_t cloths, std::size_t colliders) {
        coupling.reserve(moving.size(), cloths);
        carried.reserve(colliders);
    }

    void remove_last() noexcept {
        moving.pop_back();
        begins.pop_back();
        settings.pop_back();
        given.pop_back();
        impulses.pop_back();
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
    float h = 0;              ///< of what a cloth takes them along for [s]
    bool were_taken = false;  ///< in this substep
};

}  // namespace weft
