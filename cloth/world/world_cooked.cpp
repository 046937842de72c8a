#include "cloth/motion/moving_frame.h"
#include "cloth/record/world_calls.h"
#include "cloth/settings/validate.h"
#include "cloth/store/cooked_cloth.h"
#include "cloth/world/coincident.h"

namespace weft {

namespace {

/// Whether `place` changes nothing, not even the sign of a 0.
bool is_nothing(const Transform& place) {
    const Rotation& r = place.rotation;
    return to_vector(place.translation) == Vector3::Zero() && r.x == 0 && r.y == 0 && r.z == 0 && r.w == 1;
}

Result<void> put(Cloth& cloth, const Transform& place) {
    if (auto valid = validate_transform("place", place); !valid) return valid;
    if (is_nothing(place)) return {};
    const RigidMotion motion = rigid_motion(place);
    if (auto valid = validate_move(cloth, motion); !valid) return valid;
    Parallel serial(1);
    move_all(serial, motion, cloth.state);
    return {};
}

}  // namespace

Result<ClothId> World::add_cloth(const CookedCloth& cooked, const Transform& place) {
    const auto add = [&]() -> Result<ClothId> {
        auto cloth = std::make_unique<Cloth>(cooked.impl_->cloth);
        if (auto valid = put(*cloth, place); !valid) return valid.error();
        impl_->simulation.prepare(*cloth);
        log_coincident(impl_->simulation, *cloth);
        return impl_->simulation.add(std::move(cloth));
    };
    return impl_->change_by(Call::add_cooked_cloth, add, [&](const Result<ClothId>& id) {
        impl_->recorder->note_cooked(*id, cooked.impl_, cooked, cooked.impl_->cloth.settings, place);
    });
}

}  // namespace weft
