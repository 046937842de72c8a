// The public World: checks arguments, looks ids up, and calls the simulation.

#include "weft/world.h"

#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "cloth/mesh/cooking/log_repairs.h"
#include "cloth/record/state_hashes.h"
#include "cloth/record/world_calls.h"
#include "cloth/settings/validate.h"
#include "cloth/store/save.h"
#include "cloth/world/coincident.h"
#include "cloth/world/drawing/debug_draw.h"
#include "engine/error_text.h"
#include "engine/memory/without_exceptions.h"
#include "engine/state_hash.h"

namespace weft {

namespace {

Result<std::unique_ptr<Cloth>> make_cloth(const Mesh& mesh, const ClothSettings& settings) {
    if (const auto valid = validate(settings); !valid) return valid.error();
    auto cooked = cook(mesh, settings.fabric.bending_ratio);
    if (!cooked) return cooked.error();
    if (auto valid = validate_neighbours(*cooked, settings); !valid) return valid.error();
    if (auto valid = validate_filling(*cooked, settings); !valid) return valid.error();
    return std::make_unique<Cloth>(std::move(cooked).value(), settings);
}

}  // namespace

Result<std::vector<std::uint32_t>> particles_of(const Cloth& cloth, std::span<const std::uint32_t> vertices) {
    std::vector<std::uint32_t> particles;
    particles.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices) {
        const auto particle = particle_of(cloth, vertex);
        if (!particle) return particle.error();
        particles.push_back(*particle);
    }
    return particles;
}

namespace {

/// The pin of a mesh vertex.
Result<Pin*> pin_of(Cloth& cloth, std::uint32_t vertex) {
    const auto particle = particle_of(cloth, vertex);
    if (!particle) return particle.error();
    Pin* const pin = cloth.find_pin(*particle);
    if (pin == nullptr)
        return Error{ErrorCode::invalid_argument,
                     "vertex " + std::to_string(vertex) + " is not pinned; call pin first"};
    return pin;
}

/// Calls `use` with the particles of mesh vertices of a cloth.
template <class Use>
Result<void> with_particles(Simulation& simulation, ClothId id, std::span<const std::uint32_t> vertices,
                            const Use& use) {
    return with_cloth(simulation, id, [&](Cloth& cloth) -> Result<void> {
        const auto particles = particles_of(cloth, vertices);
        if (!particles) return particles.error();
        use(cloth, *particles);
        return {};
    });
}

/// Calls `apply`, which switches the cloth on or off. Cloth that is switched on is teleported to its pins,
/// bodies and skin, which may have moved meanwhile. Error: it cannot be; then nothing has changed.
template <class Apply>
Result<void> enable(Simulation& simulation, Cloth& cloth, bool on, const Apply& apply) {
    std::optional<RigidMotion> motion;
    if (on && !cloth.settings.enabled) {
        if (cloth.garment != no_garment && simulation.state.levels[cloth.garment] != cloth.level)
            return Error{ErrorCode::invalid_argument,
                         "the cloth is level " + std::to_string(cloth.level) +
                             " of a garment, which is at level " +
                             std::to_string(simulation.state.levels[cloth.garment]) + "; call set_level"};
        auto found = simulation.motion_to_holds(cloth, cloth.state.skin, StillPins::stay);
        if (!found) return found.error();
        motion = *found;
    }
    apply();
    if (motion) simulation.parallel.lend([&] { simulation.go_to_holds(cloth, *motion, StillPins::stay); });
    return {};
}

}  // namespace

World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const WorldSettings& settings) {
    return without_exceptions([&]() -> Result<World> {
        if (const auto valid = validate(settings); !valid) return valid.error();
        return World(std::make_unique<Impl>(settings));
    });
}

const WorldSettings& World::settings() const noexcept {
    return impl_->simulation.settings;
}

Result<void> World::set_settings(const WorldSettings& settings) {
    return impl_->change(Call::set_settings, settings)([&]() -> Result<void> {
        if (auto valid = validate(settings); !valid) return valid;
        impl_->simulation.apply(settings);
        return {};
    });
}

Result<ClothId> World::add_cloth(const Mesh& mesh, const ClothSettings& settings) {
    return impl_->change(Call::add_cloth, mesh, settings)([&]() -> Result<ClothId> {
        auto cloth = make_cloth(mesh, settings);
        if (!cloth) return cloth.error();
        impl_->simulation.prepare(**cloth);
        log_coincident(impl_->simulation, **cloth);
        const ClothInfo cooked = (*cloth)->model.info;
        const ClothId id = impl_->simulation.add(std::move(cloth).value());
        log_repairs(cooked);
        return id;
    });
}

Result<ClothInfo> World::measure_cloth(const Mesh& mesh, const ClothSettings& settings) const {
    return impl_->read("measure_cloth", [&]() -> Result<ClothInfo> {
        const auto cloth = make_cloth(mesh, settings);
        if (!cloth) return cloth.error();
        impl_->simulation.prepare(**cloth);
        return (*cloth)->info();
    });
}

Result<void> World::remove_cloth(ClothId id) {
    return impl_->change(Call::remove_cloth, id)([&]() -> Result<void> {
        Simulation& simulation = impl_->simulation;
        auto* const cloth = simulation.cloths.find(id);
        if (cloth == nullptr) return stale_id("ClothId", id);
        simulation.refine_from(**cloth);
        std::vector<SeamId> seams;
        for (const SeamRows* seam : (*cloth)->seams) seams.push_back(seam->id());
        simulation.remove_seams(seams);
        simulation.wake_near(**cloth);
        simulation.drop_level(**cloth);
        simulation.cloths.erase(id);
        *simulation.views[id.index] = {};
        simulation.cloth_has_gone();
        return {};
    });
}

Result<void> World::set_enabled(ClothId id, bool on) {
    return impl_->change(Call::set_enabled, id, on)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (!on) impl_->simulation.wake_near(cloth);
            impl_->simulation.wake_joined(cloth);
            return enable(impl_->simulation, cloth, on, [&] { cloth.set_enabled(on); });
        });
    });
}

Result<bool> World::is_asleep(ClothId id) const {
    return impl_->read("is_asleep", [&] {
        return with_cloth(impl_->simulation, id,
                          [](const Cloth& cloth) { return Result<bool>(cloth.is_asleep()); });
    });
}

Result<void> World::wake(ClothId id) {
    return impl_->change(Call::wake, id)([&] {
        return with_cloth(impl_->simulation, id, [](Cloth& cloth) -> Result<void> {
            cloth.wake();
            return {};
        });
    });
}

Result<ClothSettings> World::cloth_settings(ClothId id) const {
    return with_cloth(impl_->simulation, id,
                      [](const Cloth& cloth) { return Result<ClothSettings>(cloth.settings); });
}

Result<void> World::set_cloth_settings(ClothId id, const ClothSettings& settings) {
    return impl_->change(Call::set_cloth_settings, id, settings)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (auto valid = validate(settings); !valid) return valid;
            if (cloth.areas_without_map.size() > 0 || cloth.model.stiffness.size() > 0)
                if (auto valid = validate_for_maps(settings); !valid) return valid;
            if (auto valid = validate_neighbours(cloth.model, settings); !valid) return valid;
            if (auto valid = validate_filling(cloth.model, settings); !valid) return valid;
            if (!cloth.seams.empty())
                if (auto valid = validate_for_seams(settings); !valid) return valid;
            impl_->simulation.mark_near(cloth);
            Result<void> done = enable(impl_->simulation, cloth, settings.enabled,
                                       [&] { impl_->simulation.apply(cloth, settings); });
            impl_->simulation.wake_marked();
            return done;
        });
    });
}

Result<void> World::set_importance(ClothId id, float importance) {
    return impl_->change(Call::set_importance, id, importance)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (auto valid = validate_importance(importance); !valid) return valid;
            cloth.settings.importance = importance;
            return {};
        });
    });
}

Result<ClothInfo> World::cloth_info(ClothId id) const {
    return impl_->read("cloth_info", [&] {
        return with_cloth(impl_->simulation, id,
                          [](const Cloth& cloth) { return Result<ClothInfo>(cloth.info()); });
    });
}

Result<void> World::pin(ClothId id, std::span<const std::uint32_t> vertices) {
    return impl_->change(Call::pin, id, vertices)([&] {
        return with_particles(impl_->simulation, id, vertices,
                              [](Cloth& cloth, const auto& particles) { cloth.pin(particles); });
    });
}

Result<void> World::unpin(ClothId id, std::span<const std::uint32_t> vertices) {
    return impl_->change(Call::unpin, id, vertices)([&] {
        return with_particles(impl_->simulation, id, vertices,
                              [](Cloth& cloth, const auto& particles) { cloth.unpin(particles); });
    });
}

Result<void> World::move_pin(ClothId id, std::uint32_t vertex, const Vec3& target) {
    return move_pins(id, {&vertex, 1}, {&target, 1});
}

Result<void> World::move_pins(ClothId id, std::span<const std::uint32_t> vertices,
                              std::span<const Vec3> targets) {
    return impl_->change(Call::move_pins, id, vertices, targets)([&] {
        return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
            if (vertices.size() != targets.size())
                return Error{ErrorCode::invalid_argument, std::to_string(vertices.size()) + " vertices and " +
                                                              std::to_string(targets.size()) +
                                                              " targets: give as many of each"};
            for (std::size_t k = 0; k < vertices.size(); ++k) {
                if (auto valid = validate_point("a pin's target", targets[k]); !valid) return valid;
                if (const auto pin = pin_of(cloth, vertices[k]); !pin) return pin.error();
            }
            for (std::size_t k = 0; k < vertices.size(); ++k)
                (*pin_of(cloth, vertices[k]))->target = to_vector(targets[k]);
            return {};
        });
    });
}

std::span<const StageTime> World::profile() const {
    if (impl_->is_in_step()) return {};
    return impl_->simulation.profiler.stages();
}

Result<void> World::start_trace(std::size_t max_events) {
    return impl_->read("start_trace", [&] { return impl_->simulation.profiler.start_trace(max_events); });
}

Result<void> World::write_trace(const std::filesystem::path& file) const {
    return impl_->read("write_trace", [&] { return impl_->simulation.profiler.write_trace(file); });
}

void World::debug_draw(const DebugCanvas& canvas, DebugParts parts) const {
    if (!impl_->is_in_step()) weft::debug_draw(impl_->simulation, canvas, parts);
}

std::size_t World::save_size() const noexcept {
    return impl_->is_in_step() ? 0 : weft::save_size(impl_->simulation);
}

Result<void> World::save(std::span<std::byte> to) const {
    return impl_->read("save", [&] { return weft::save(impl_->simulation, to); });
}

Result<void> World::restore(std::span<const std::byte> saved) {
    return impl_->change(Call::restore, saved)([&] { return weft::restore(impl_->simulation, saved); });
}

Result<std::uint32_t> World::restore_cloths(std::span<const std::byte> saved) {
    return impl_->change(Call::restore_cloths,
                         saved)([&] { return weft::restore_cloths(impl_->simulation, saved); });
}

std::size_t World::cloth_save_size(ClothId id) const noexcept {
    const auto* const cloth = impl_->is_in_step() ? nullptr : impl_->simulation.cloths.find(id);
    return cloth == nullptr ? 0 : weft::save_size(**cloth);
}

Result<void> World::save_cloth(ClothId id, std::span<std::byte> to) const {
    return impl_->read("save_cloth", [&] {
        return with_cloth(impl_->simulation, id,
                          [&](const Cloth& cloth) { return weft::save_cloth(cloth, to); });
    });
}

Result<void> World::restore_cloth(ClothId id, std::span<const std::byte> saved) {
    return impl_->change(Call::restore_cloth, id, saved)([&] {
        return with_cloth(impl_->simulation, id,
                          [&](Cloth& cloth) { return weft::restore_cloth(impl_->simulation, cloth, saved); });
    });
}

std::uint64_t World::state_hash() const {
    if (impl_->is_in_step()) return 0;
    StateHash hash;
    for_each_part(std::as_const(impl_->simulation), HashVisitor{hash});
    return hash.value();
}

}  // namespace weft
