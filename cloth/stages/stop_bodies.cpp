// Bodies that the World's unattached colliders stop.

#include <algorithm>
#include <cmath>

#include "cloth/bodies/body_contacts.h"
#include "cloth/stages/step_bodies.h"
#include "engine/bounds.h"

namespace weft {

namespace {

constexpr float contact_reach = 0.01f;  ///< gap up to which a body at rest has contacts [m]

/// A collider over a part of the substep.
ColliderMotion over_part(const ColliderMotion& motion, const Substep& substep, const Substep& part) {
    if (part == substep) return motion;
    const float whole = substep.end() - substep.begin();
    ColliderMotion of_part = motion;
    of_part.start = blend(motion.start, motion.end, (part.begin() - substep.begin()) / whole);
    of_part.end = blend(motion.start, motion.end, (part.end() - substep.begin()) / whole);
    return of_part;
}

/// One body over a part of the substep.
struct StoppedBody {
    const Simulation& world;
    const Substep& part;
    BodyId id;
    MovingBody& body;

    template <class Visit>
    void for_each_own(const Visit& visit) const {
        world.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
            if (slot.body == id && !slot.own.is_trigger) visit(slot.own, world.held_by(slot.own));
        });
    }

    /// Bound on the distance that a point of the body goes in the part [m].
    [[nodiscard]] float way() const {
        float radius = 0;
        for_each_own([&](const Collider& own, const HeldShape* held) {
            const Sphere ball = ball_around(own, held);
            radius = std::max(radius, to_vector(ball.center).norm() + ball.radius);
        });
        return part.h * (static_cast<float>(body.now.head<3>().norm()) +
                         radius * static_cast<float>(body.now.tail<3>().norm()));
    }

    /// Pose once the body has gone this share of its way.
    [[nodiscard]] BodyPose pose_at(float t) const {
        return {body.start.position + t * (body.end.position - body.start.position),
                body.start.rotation.slerp(t, body.end.rotation)};
    }

    /// Adds the contacts that the body has on its way, every two centimetres.
    void find_contacts_on_way(BodyContacts& contacts) const {
        constexpr float apart = 0.02f, most = 16;
        const float poses = std::clamp(std::ceil(way() / apart), 1.0f, most);
        for (float k = 1; k <= poses; ++k) find_contacts(pose_at(k / poses), contact_reach, contacts);
    }

    /// Adds the contacts of gaps up to `reach` that the body has at a pose.
    void find_contacts(const BodyPose& pose, float reach, BodyContacts& contacts) const {
        const BodyStage& stage = *world.body_stage;
        for_each_own([&](const Collider& own, const HeldShape* held) {
            const Bounds box = grown(box_of(carried(own, pose), held), own.thickness + reach);
            for (const ColliderMotion& other : stage.others)
                if ((other.end.layers & own.layers) != 0 && overlap(box, other.filled))
                    contacts.add(own, held, pose, over_part(other, stage.substep, part), reach);
        });
    }

    /// Finds the contacts where the body, whose way is `whole`, first comes near a collider, by conservative
    /// advancement (Mirtich 1996, "Impulse-based dynamic simulation of rigid body systems").
    void find_first_contacts(float whole, BodyContacts& contacts) const {
        constexpr int most_advances = 32;
        constexpr float near = 0.5f * contact_reach;
        float gone = 0;
        for (int k = 0; k < most_advances; ++k) {
            contacts.clear();
            find_contacts(pose_at(whole > 0 ? gone / whole : 0), contact_reach + whole - gone, contacts);
            if (whole < contact_reach || contacts.nearest() < near) return;
            gone += contacts.nearest();
            if (!(gone < whole)) break;
        }
        contacts.clear();
    }
};

}  // namespace

// A body that goes far may slide from its first contact into the next: contacts on its new way are added.
void stop_at_colliders(Simulation& world, std::size_t number, const Substep& part) {
    constexpr int most_rounds = 4;
    BodyStage& stage = *world.body_stage;
    MovingBody& body = stage.moving[number];
    body.is_stopped = false;
    if (stage.others.empty() || !body.gives_way() || !body.now.allFinite()) return;
    const StoppedBody stopped{world, part, stage.impulses[number].body, body};
    const MovingBody free = body;
    const float whole = stopped.way();
    BodyContacts contacts(free);
    stopped.find_first_contacts(whole, contacts);
    Vector6 last = Vector6::Zero();
    for (int round = 0; round < most_rounds; ++round) {
        if (round > 0) stopped.find_contacts_on_way(contacts);
        const Vector6 impulse = contacts.impulse();
        if (impulse == last) return;
        body = free;
        body.stop(impulse);
        if (whole < contact_reach) return;
        last = impulse;
    }
}

}  // namespace weft
