#include "demo/scenes/dolls.h"

#include <algorithm>
#include <utility>

#include "engine/least_turn.h"

namespace weft::demo {
namespace {

/// The part of a capsule's axis between two places, with radii of its own.
TaperedCapsule piece_of(const TaperedCapsule& capsule, float from, float to, float radius_a, float radius_b) {
    const Vector3 a = to_vector(capsule.a), axis = to_vector(capsule.b) - a;
    return {to_vec3(a + from * axis), to_vec3(a + to * axis), radius_a, radius_b};
}

}  // namespace

SceneSolid figure_solid(const Figure& figure, std::size_t person,
                        std::function<void(std::span<Vec3>, SolidMoment)> place, std::optional<Suit> suit) {
    const Complexion& own = complexions[person % complexions.size()];
    SceneSolid solid{{.positions = std::vector<Vec3>(figure.size()), .triangles = figure.triangles()},
                     own.skin,
                     std::move(place)};
    for (const Figure::Wear& wear : figure.wear()) {
        const float bare = std::max(wear.hair, wear.shoe);
        const float covered = suit ? wear.suit + (suit->has_sleeves ? wear.sleeve : 0) : 0;
        const Vec3& c = covered > bare ? suit->colour : wear.hair > 0 ? own.hair : own.shoe;
        solid.tints.push_back({c.x, c.y, c.z, std::max(covered, bare)});
    }
    return solid;
}

FigureLimb doll_limb(LimbKind kind, const TaperedCapsule& capsule, const Matrix3& axes) {
    return {kind, to_vector(capsule.a), to_vector(capsule.b), capsule.radius_a, capsule.radius_b, axes, axes};
}

void add_doll_leg(const TaperedCapsule& leg, const TaperedCapsule& sole, const Matrix3& axes,
                  std::vector<FigureLimb>& to) {
    const float top = leg.radius_a, ankle = 0.55f * leg.radius_b;
    to.push_back(doll_limb(LimbKind::thigh, piece_of(leg, 0, 0.5f, top, 0.72f * top), axes));
    to.push_back(doll_limb(LimbKind::shin, piece_of(leg, 0.5f, 1, 0.72f * top, ankle), axes));
    to.push_back(doll_limb(LimbKind::sole, sole, axes));
    const Vec3 instep = to_vec3(0.5f * (to_vector(sole.a) + to_vector(sole.b)));
    to.push_back(doll_limb(LimbKind::foot, {leg.b, instep, ankle, sole.radius_a}, axes));
}

void add_doll_arm(const TaperedCapsule& arm, float side, std::vector<FigureLimb>& to) {
    const Vector3 way = to_vector(arm.b) - to_vector(arm.a);
    const Matrix3 axes = least_turn({side, 0, 0}, way).toRotationMatrix();
    const float top = arm.radius_a, wrist = 0.52f * top;
    to.push_back(doll_limb(LimbKind::arm, piece_of(arm, 0, 0.45f, top, 0.76f * top), axes));
    to.push_back(doll_limb(LimbKind::forearm, piece_of(arm, 0.45f, 0.84f, 0.76f * top, wrist), axes));
    FigureLimb hand = doll_limb(LimbKind::hand, piece_of(arm, 0.84f, 1.04f, 0.60f * top, 0.60f * top), axes);
    hand.scale = flat_hand;
    to.push_back(hand);
}

}  // namespace weft::demo
