#pragma once
// Data of the steps of a World with bodies. A body's number is its place in the order of ids.
//
// Cloths that may meet the same body are a group; those whose method can have bodies as unknowns are one
// equation with them. In each part of a substep each of the group's equations integrates the bodies in turn,
// always from the part's start: with gravity, the impulses of the other equations' cloths (of equations still
// to come, those of the last substep), and the impulses of its own cloths. The bodies go on from the last
// equation's result.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/bodies/body_coupling.h"
#include "cloth/contact/group_finder.h"
#include "cloth/equation/moving_body.h"
#include "cloth/simulation/substep.h"
#include "weft/body.h"

namespace weft {

/// Conversions of an impulse and angular impulse: single precision in states, double in computations.
[[nodiscard]] inline Vector6 to_vector6(const std::array<float, 6>& values) {
    return Eigen::Map<const Eigen::Matrix<float, 6, 1>>(values.data()).cast<double>();
}
[[nodiscard]] inline std::array<float, 6> to_floats(const Vector6& v) {
    std::array<float, 6> values{};
    Eigen::Map<Eigen::Matrix<float, 6, 1>>(values.data()) = v.cast<float>();
    return values;
}

struct BodyStage {
    /// Reserves memory for these numbers.
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
        others.reserve(colliders);
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
    std::vector<Begin> begins;  ///< the bodies at the start of the present part
    std::vector<BodySettings> settings;
    std::vector<Vector6> given;         ///< impulses of cloths in the step so far [N s, N m s]
    std::vector<BodyImpulse> impulses;  ///< reported for the last step
    std::vector<CarriedCollider> carried;
    BodyCoupling coupling;
    GroupFinder sharing;                      ///< groups of cloths that may meet one movable body
    std::vector<std::uint32_t> first_cloths;  ///< by body: the first cloth of its group, during that search
    Substep substep{0, 1, 0};                 ///< that a group solves
    std::vector<ColliderMotion> others;       ///< colliders that no body carries, over the substep
    bool were_taken = false;                  ///< whether any cloth was solved with bodies in this substep
};

}  // namespace weft
