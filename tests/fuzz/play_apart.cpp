// A step in three: one thread takes it, another one reads meanwhile what the last step left.

#include <cmath>
#include <thread>

#include "tests/fuzz/player.h"

namespace weft::fuzz {

void Player::step_apart(float dt, bool is_refused) {
    const auto begun = world_.begin_step(dt);
    check(begun.ok() != is_refused, begun ? "an invalid step was begun" : begun.error().message);
    if (!begun) return;
    bool was_taken = false;
    {
        const std::jthread worker([&] { was_taken = world_.work().ok(); });
        read_beside_work();
    }
    check(was_taken, "a step that was begun is not taken");
    check(!world_.work(), "a step was taken twice");
    check(world_.end_step().ok(), "a step that was taken does not end");
    check(!world_.end_step(), "a step ended twice");
}

void Player::read_beside_work() {
    bool are_right = !world_.begin_step(1.0f / 60) &&
                     has(world_.step(1.0f / 60).flags, StepFlags::step_under_way) &&
                     world_.save_size() == 0 && world_.contacts().empty() && !world_.describe() &&
                     world_.report().step == steps_ && world_.settings().substeps > 0;
    for (std::size_t i = 0; i < cloths_.size(); ++i) {
        if (!cloths_[i]) continue;
        are_right &= !world_.pin(*cloths_[i], 0);
        const auto view = world_.cloth(*cloths_[i]);
        if (!view) continue;
        for (const Vec4& p : view->positions) are_right &= std::isfinite(p.x + p.y + p.z);
        std::vector<Vec3> places(view->vertex_to_particle.size());
        are_right &=
            world_.write_vertices(*cloths_[i], {.positions = {std::as_writable_bytes(std::span(places))}})
                .ok();
    }
    check(are_right, "beside work() a call answers otherwise than it is documented to");
}

}  // namespace weft::fuzz
