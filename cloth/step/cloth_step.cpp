#include "cloth/step/cloth_step.h"

#include <cmath>
#include <utility>

#include "cloth/motion/advance.h"
#include "cloth/stages/forces/air_step.h"
#include "cloth/stages/report_contacts.h"
#include "cloth/stages/worn_step.h"
#include "cloth/step/choose.h"

namespace weft {

namespace {

Vector3 limited(const Vector3& velocity, float max_speed) {
    const float squared = velocity.squaredNorm();
    return squared > max_speed * max_speed ? Vector3(velocity * (max_speed / std::sqrt(squared))) : velocity;
}

/// A pin goes along a straight line to its target, all through the step.
void move_pins(const Simulation& world, Cloth& cloth, float dt) {
    for (const Pin& pin : cloth.state.pins) {
        const Vector3 wanted = (pin.target - xyz(cloth.state.positions[pin.particle])) / dt;
        const Vector3 velocity = limited(wanted, world.settings.max_speed);
        cloth.pins_limited |= velocity != wanted;
        set_xyz(cloth.state.velocities[pin.particle], velocity);
    }
}

// Neither rounding nor the speed limit may make a pin miss its target; only cloth in its way may. Whatever
// stage wrote a velocity last, max_speed is enforced here.
void guard(Simulation& world, Worker& worker, Cloth& cloth) {
    const auto timer = world.timed(Stage::guard);
    const auto look = [&] {
        if (!cloth.has_features()) cloth.place_pins();
        return survey(worker.parallel, cloth.state, cloth.partial_surveys.span());
    };
    cloth.extent = look();
    cloth.restored = std::exchange(cloth.solver_failed, false) || !cloth.extent.sound;
    if (cloth.restored) cloth.restore_start_of_step();
    const bool is_too_fast =
        cloth.extent.peak_speed_squared > world.settings.max_speed * world.settings.max_speed;
    if (is_too_fast) limit_speeds(worker.parallel, world.settings.max_speed, cloth.state.velocities.span());
    if (cloth.restored || is_too_fast) cloth.extent = look();
    cloth.pin_lag = cloth.has_features() && !cloth.restored ? cloth.farthest_pin() : 0;
}

}  // namespace

// Gusts change little in a step: they are sampled once, at its start, and act in every substep. A step begins
// with the normals that the last one ended with, since only steps move particles.
void predict(Simulation& world, Worker& worker, Cloth& cloth, float dt, const Substep& substep) {
    if (substep.is_first()) {
        if (cloth.carried) {
            carry(worker.parallel, *cloth.carried, cloth.state);
            limit_speeds(worker.parallel, world.settings.max_speed, cloth.state.velocities.span());
        }
        move_pins(world, cloth, dt);
    }
    if (!world.air_is_on()) return;
    if (substep.is_first()) feel_wind(world, worker, cloth);
    find_air_forces(world, worker, cloth, substep.is_first() && !cloth.carried);
}

void arrive(Simulation& world, Worker& worker, Cloth& cloth) {
    if (cloth.is_gliding()) return glide(world, worker, cloth);
    guard(world, worker, cloth);
    begin_stride(world, worker, cloth);
    if (world.reports_contacts()) find_touched_colliders(world, worker, cloth);
    end_worn(worker, cloth);
    const auto timer = world.timed(Stage::normals);
    world.update_normals(worker.parallel, cloth);
}

}  // namespace weft
