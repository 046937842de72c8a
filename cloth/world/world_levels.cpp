// The World's calls for garments of several meshes.

#include <algorithm>
#include <string>

#include "cloth/record/world_calls.h"
#include "cloth/settings/validate.h"
#include "engine/error_text.h"

namespace weft {

namespace {

Error no_level(const std::string& why) {
    return {ErrorCode::invalid_argument, "add_level: " + why};
}

/// Error: see World::add_level().
Result<void> validate_level(const Simulation& simulation, ClothId finest, ClothId coarser) {
    const auto *const first = simulation.cloths.find(finest), *const added = simulation.cloths.find(coarser);
    if (first == nullptr) return stale_id("ClothId", finest);
    if (added == nullptr) return stale_id("ClothId", coarser);
    if (first == added) return no_level("a cloth is no level of itself; add a coarser mesh as another cloth");
    if ((*added)->garment != no_garment)
        return no_level("the cloth to be added is a level of a garment already");
    if ((*first)->level > 0)
        return no_level("the first cloth is level " + std::to_string((*first)->level) +
                        " of its garment; name the finest");
    const bool has_levels = (*first)->garment != no_garment;
    const std::size_t levels = has_levels ? simulation.garments[(*first)->garment].levels.size() : 1;
    if (levels == most_garment_levels)
        return no_level("the garment has " + std::to_string(most_garment_levels) +
                        " levels, and may have no more");
    const Cloth& last =
        has_levels ? **simulation.cloths.find(simulation.garments[(*first)->garment].levels.back()) : **first;
    if ((*added)->model.particle_count >= last.model.particle_count)
        return no_level("the cloth to be added has " + std::to_string((*added)->model.particle_count) +
                        " particles; the level above it has " + std::to_string(last.model.particle_count) +
                        ", and a coarser one has fewer");
    if (!(*first)->seams.empty() || !(*added)->seams.empty())
        return no_level("cloth with seams cannot be a level, since it would hold others while it waits");
    return {};
}

}  // namespace

Result<void> World::add_level(ClothId finest, ClothId coarser, float reach) {
    return impl_->change(Call::add_level, finest, coarser, reach)([&]() -> Result<void> {
        Simulation& simulation = impl_->simulation;
        if (auto valid = validate_level(simulation, finest, coarser); !valid) return valid;
        Cloth& added = **simulation.cloths.find(coarser);
        if (added.settings.enabled) simulation.wake_near(added);
        return simulation.add_level(finest, coarser, reach);
    });
}

Result<void> World::set_level(ClothId id, std::uint32_t level) {
    return impl_->change(Call::set_level, id, level)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            Simulation& simulation = impl_->simulation;
            const bool has_levels = cloth.garment != no_garment;
            const std::size_t levels = has_levels ? simulation.garments[cloth.garment].levels.size() : 1;
            if (level >= levels)
                return out_of_range("level", static_cast<double>(level),
                                    "below the number of the garment's levels, " + std::to_string(levels));
            if (!has_levels) return {};
            Garment& garment = simulation.garments[cloth.garment];
            const std::uint32_t now = simulation.state.levels[cloth.garment];
            garment.least = level;
            if (simulation.settings.budget > 0 && level <= now) return {};
            const Cloth& present = **simulation.cloths.find(garment.levels[now]);
            const std::uint32_t rung = present.state.detail ? present.state.detail->rung : 0;
            simulation.parallel.lend([&] { simulation.set_level(garment, level, rung); });
            return {};
        });
    });
}

Result<std::uint32_t> World::level(ClothId id) const {
    return with_cloth(impl_->simulation, id, [&](const Cloth& cloth) -> Result<std::uint32_t> {
        if (auto ready = impl_->refuse_beside_step("level"); !ready) return ready.error();
        return cloth.garment == no_garment ? 0 : impl_->simulation.state.levels[cloth.garment];
    });
}

}  // namespace weft
