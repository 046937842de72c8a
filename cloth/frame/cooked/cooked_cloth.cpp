#include "cloth/frame/cooked/cooked_cloth.h"

#include <utility>

#include "cloth/frame/settings/validate.h"
#include "cloth/frame/world/world_calls.h"
#include "cloth/frame/worn/moving_frame.h"
#include "engine/memory/without_exceptions.h"

namespace weft {

namespace {

/// By which nothing moves, not even the sign of a 0.
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

CookedCloth::CookedCloth(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

Result<CookedCloth> CookedCloth::create(const Mesh& mesh, const ClothSettings& settings,
                                        const CookProgress& to_host) {
    return without_exceptions([&]() -> Result<CookedCloth> {
        if (const auto valid = validate(settings); !valid) return valid.error();
        const Progress progress(to_host);
        CookReport report;
        auto model = cook(mesh, settings.fabric.bending_ratio, &report, progress);
        if (!model) return model.error();
        if (auto valid = validate_neighbours(*model, settings); !valid) return valid.error();
        CookedCloth cooked(
            std::make_shared<const Impl>(std::move(model).value(), std::move(report), settings, progress));
        if (progress.is_cancelled()) return Progress::cancelled();
        log_repairs(cooked.info());
        progress.reach(Progress::done);
        return cooked;
    });
}

const ClothInfo& CookedCloth::info() const noexcept {
    return impl_->info;
}

const CookReport& CookedCloth::report() const noexcept {
    return impl_->report;
}

Result<ClothId> World::add_cloth(const CookedCloth& cooked, const Transform& place) {
    const auto add = [&]() -> Result<ClothId> {
        auto cloth = std::make_unique<Cloth>(cooked.impl_->cloth);
        if (auto valid = put(*cloth, place); !valid) return valid.error();
        impl_->simulation.prepare(*cloth);
        return impl_->simulation.add(std::move(cloth));
    };
    return impl_->change_by(Call::add_cooked_cloth, add, [&](const Result<ClothId>& id) {
        impl_->recorder->note_cooked(*id, cooked.impl_, cooked, cooked.impl_->cloth.settings, place);
    });
}

}  // namespace weft
