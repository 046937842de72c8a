// The public World: checks what comes in, looks ids up, and hands over to the simulation.

#include "weft/world.h"

#include <cmath>
#include <new>
#include <utility>

#include "cloth/frame/simulation.h"
#include "cloth/frame/validate.h"
#include "engine/error_text.h"
#include "engine/state_hash.h"

namespace weft {

struct World::Impl {
    explicit Impl(const WorldSettings& settings) : simulation(settings) {}
    Simulation simulation;
};

namespace {

/// Runs `make` and turns what memory could not be had into an error: nothing throws out of a World.
template <class Make>
auto without_exceptions(const Make& make) -> decltype(make()) {
    try {
        return make();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_memory, "out of memory; nothing was changed"};
    } catch (const std::exception& e) {
        return Error{ErrorCode::out_of_memory, std::string("the system refused a resource: ") + e.what()};
    }
}

template <class Id>
Error stale_id(const char* type, Id id) {
    if (id == Id{})
        return {ErrorCode::stale_id, std::string(type) + " is null; use the one that the World returned"};
    return {ErrorCode::stale_id, std::string(type) + " {" + std::to_string(id.index) + ", " +
                                     std::to_string(id.generation) +
                                     "} is of an object that was removed, or of another World"};
}

/// With all the memory that its steps will need, but what depends on pins.
Result<std::unique_ptr<Cloth>> make_cloth(Simulation& simulation, const Mesh& mesh,
                                          const ClothSettings& settings) {
    if (const auto valid = validate(settings); !valid) return valid.error();
    auto cooked = cook(mesh);
    if (!cooked) return cooked.error();
    auto cloth = std::make_unique<Cloth>(std::move(cooked).value(), settings);
    simulation.prepare(*cloth);
    cloth->solver->prepare(cloth->model, cloth->settings, cloth->state.positions.span());
    cloth->solver_is_prepared = true;
    return cloth;
}

/// The particle of a mesh vertex.
Result<std::uint32_t> particle_of(const Cloth& cloth, std::uint32_t vertex) {
    const auto& map = cloth.model.vertex_to_particle;
    if (vertex >= map.size()) {
        return Error{ErrorCode::invalid_argument, "vertex " + std::to_string(vertex) +
                                                      " does not exist; the mesh has " +
                                                      std::to_string(map.size())};
    }
    return map[vertex];
}

/// Calls `use` with the cloth of an id and returns its result, or says that the id is stale.
template <class Simulation, class Use>
auto with_cloth(Simulation& simulation, ClothId id, const Use& use)
    -> decltype(use(**simulation.cloths.find(id))) {
    auto* slot = simulation.cloths.find(id);
    if (slot == nullptr) return stale_id("ClothId", id);
    return use(**slot);
}

}  // namespace

World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const WorldSettings& settings) {
    if (const auto valid = validate(settings); !valid) return valid.error();
    return without_exceptions([&]() -> Result<World> { return World(std::make_unique<Impl>(settings)); });
}

const WorldSettings& World::settings() const noexcept {
    return impl_->simulation.settings;
}

Result<void> World::set_settings(const WorldSettings& settings) {
    if (const auto valid = validate(settings); !valid) return valid.error();
    return without_exceptions([&]() -> Result<void> {
        impl_->simulation.apply(settings);
        return {};
    });
}

Result<ClothId> World::add_cloth(const Mesh& mesh, const ClothSettings& settings) {
    return without_exceptions([&]() -> Result<ClothId> {
        auto cloth = make_cloth(impl_->simulation, mesh, settings);
        if (!cloth) return cloth.error();
        impl_->simulation.reserve_cloths(impl_->simulation.cloths.size() + 1);
        return impl_->simulation.cloths.insert(std::move(cloth).value());
    });
}

Result<ClothInfo> World::measure_cloth(const Mesh& mesh, const ClothSettings& settings) const {
    return without_exceptions([&]() -> Result<ClothInfo> {
        const auto cloth = make_cloth(impl_->simulation, mesh, settings);
        if (!cloth) return cloth.error();
        return (*cloth)->info();
    });
}

Result<void> World::remove_cloth(ClothId id) {
    if (!impl_->simulation.cloths.erase(id)) return stale_id("ClothId", id);
    return {};
}

Result<ClothSettings> World::cloth_settings(ClothId id) const {
    return with_cloth(impl_->simulation, id,
                      [](const Cloth& cloth) { return Result<ClothSettings>(cloth.settings); });
}

Result<void> World::set_cloth_settings(ClothId id, const ClothSettings& settings) {
    if (const auto valid = validate(settings); !valid) return valid.error();
    return with_cloth(impl_->simulation, id, [&](Cloth& cloth) {
        return without_exceptions([&]() -> Result<void> {
            cloth.apply(settings);
            return {};
        });
    });
}

Result<ClothInfo> World::cloth_info(ClothId id) const {
    return with_cloth(impl_->simulation, id,
                      [](const Cloth& cloth) { return Result<ClothInfo>(cloth.info()); });
}

Result<const ClothView&> World::cloth(ClothId id) const {
    return with_cloth(impl_->simulation, id, [](const Cloth& cloth) {
        const ClothState& state = cloth.state;
        cloth.view = {.positions = state.positions.span(),
                      .previous_positions = state.previous_positions.span(),
                      .velocities = state.velocities.span(),
                      .normals = state.normals.span(),
                      .triangles = cloth.model.triangles,
                      .vertex_to_particle = cloth.model.vertex_to_particle,
                      .bounds = {cloth.extent.lower, cloth.extent.upper}};
        return Result<const ClothView&>(cloth.view);
    });
}

Result<void> World::pin(ClothId id, std::uint32_t vertex) {
    return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
        const auto particle = particle_of(cloth, vertex);
        if (!particle) return particle.error();
        return without_exceptions([&]() -> Result<void> {
            cloth.pin(*particle);
            return {};
        });
    });
}

Result<void> World::move_pin(ClothId id, std::uint32_t vertex, const Vec3& target) {
    if (const auto valid = validate_point("move_pin's target", target); !valid) return valid.error();
    return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
        const auto particle = particle_of(cloth, vertex);
        if (!particle) return particle.error();
        Pin* pin = cloth.find_pin(*particle);
        if (pin == nullptr) {
            return Error{ErrorCode::invalid_argument,
                         "vertex " + std::to_string(vertex) + " is not pinned; call pin first"};
        }
        pin->target = to_vector(target);
        return {};
    });
}

Result<void> World::unpin(ClothId id, std::uint32_t vertex) {
    return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
        const auto particle = particle_of(cloth, vertex);
        if (!particle) return particle.error();
        cloth.unpin(*particle);
        return {};
    });
}

Result<ColliderId> World::add_collider(const Collider& collider) {
    if (const auto valid = validate(collider); !valid) return valid.error();
    return without_exceptions([&]() -> Result<ColliderId> {
        Simulation& simulation = impl_->simulation;
        simulation.expect_colliders(simulation.colliders.size() + 1);
        return simulation.colliders.insert({collider, collider});
    });
}

Result<void> World::move_collider(ColliderId id, const Collider& target) {
    if (const auto valid = validate(target); !valid) return valid.error();
    ColliderSlot* slot = impl_->simulation.colliders.find(id);
    if (slot == nullptr) return stale_id("ColliderId", id);
    if (slot->current.shape.index() != target.shape.index()) {
        return Error{
            ErrorCode::invalid_argument,
            "move_collider was given another kind of shape; remove the collider and add the new one"};
    }
    slot->target = target;
    return {};
}

Result<void> World::remove_collider(ColliderId id) {
    if (!impl_->simulation.colliders.erase(id)) return stale_id("ColliderId", id);
    impl_->simulation.expect_colliders(impl_->simulation.colliders.size());
    return {};
}

Result<Collider> World::collider(ColliderId id) const {
    const ColliderSlot* slot = impl_->simulation.colliders.find(id);
    if (slot == nullptr) return stale_id("ColliderId", id);
    return slot->current;
}

const StepReport& World::step(float dt) noexcept {
    StepReport& report = impl_->simulation.report;
    if (dt > 0 && dt <= 1) {
        impl_->simulation.step(dt);
    } else {
        report = {.flags = StepFlags::invalid_dt, .step = report.step};
    }
    return report;
}

const StepReport& World::report() const noexcept {
    return impl_->simulation.report;
}

std::span<const StageTime> World::profile() const {
    return impl_->simulation.profiler.stages();
}

void World::start_trace(std::size_t max_events) {
    impl_->simulation.profiler.start_trace(max_events);
}

Result<void> World::write_trace(const std::filesystem::path& file) const {
    return impl_->simulation.profiler.write_trace(file);
}

std::uint64_t World::state_hash() const {
    StateHash hash;
    impl_->simulation.cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) {
        hash.add(std::as_const(cloth->state.positions).span());
        hash.add(std::as_const(cloth->state.velocities).span());
    });
    return hash.value();
}

}  // namespace weft
