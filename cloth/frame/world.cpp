// The public World: checks what comes in, looks ids up, and hands over to the simulation.

#include "weft/world.h"

#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "cloth/frame/save/save.h"
#include "cloth/frame/simulation.h"
#include "cloth/frame/validate.h"
#include "engine/error_text.h"
#include "engine/state_hash.h"
#include "engine/without_exceptions.h"

namespace weft {

struct World::Impl {
    explicit Impl(const WorldSettings& settings) : simulation(settings) {}
    Simulation simulation;
};

namespace {

template <class Id>
Error stale_id(const char* type, Id id) {
    if (id == Id{})
        return {ErrorCode::stale_id, std::string(type) + " is null; use the one that the World returned"};
    return {ErrorCode::stale_id, std::string(type) + " {" + std::to_string(id.index) + ", " +
                                     std::to_string(id.generation) +
                                     "} is of an object that was removed, or of another World"};
}

/// With all the memory that its steps will need.
Result<std::unique_ptr<Cloth>> make_cloth(Simulation& simulation, const Mesh& mesh,
                                          const ClothSettings& settings) {
    if (const auto valid = validate(settings); !valid) return valid.error();
    auto cooked = cook(mesh);
    if (!cooked) return cooked.error();
    auto cloth = std::make_unique<Cloth>(std::move(cooked).value(), settings);
    simulation.prepare(*cloth);
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

/// The particles of mesh vertices.
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

/// Calls `use` with the cloth of an id and returns its result, or says that the id is stale.
template <class Simulation, class Use>
auto with_cloth(Simulation& simulation, ClothId id, const Use& use)
    -> decltype(use(**simulation.cloths.find(id))) {
    return without_exceptions([&]() -> decltype(use(**simulation.cloths.find(id))) {
        auto* slot = simulation.cloths.find(id);
        if (slot == nullptr) return stale_id("ClothId", id);
        return use(**slot);
    });
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

/// An instance is one of a shape that is there.
Result<void> validate_instance(const Simulation& simulation, const Collider& collider) {
    const auto* const placed = std::get_if<PlacedShape>(&collider.shape);
    if (placed != nullptr && simulation.held_by(collider) == nullptr)
        return stale_id("ShapeId", placed->shape);
    return {};
}

bool are_of_one_kind(const Collider& a, const Collider& b) {
    const auto* const of_a = std::get_if<PlacedShape>(&a.shape);
    const auto* const of_b = std::get_if<PlacedShape>(&b.shape);
    if (of_a != nullptr && of_b != nullptr) return of_a->shape == of_b->shape;
    return a.shape.index() == b.shape.index();
}

/// Calls `use` with the slot of a collider that may become `target`.
template <class Use>
Result<void> with_collider(Simulation& simulation, ColliderId id, const Collider& target, const Use& use) {
    return without_exceptions([&]() -> Result<void> {
        if (auto valid = validate(target); !valid) return valid.error();
        ColliderSlot* const slot = simulation.state.colliders.find(id);
        if (slot == nullptr) return stale_id("ColliderId", id);
        if (!are_of_one_kind(slot->current, target))
            return Error{ErrorCode::invalid_argument,
                         "the collider is of another kind of shape; remove it and add the new one"};
        use(*slot);
        return {};
    });
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
    return without_exceptions([&]() -> Result<void> {
        if (auto valid = validate(settings); !valid) return valid;
        impl_->simulation.apply(settings);
        return {};
    });
}

Result<ClothId> World::add_cloth(const Mesh& mesh, const ClothSettings& settings) {
    return without_exceptions([&]() -> Result<ClothId> {
        auto cloth = make_cloth(impl_->simulation, mesh, settings);
        if (!cloth) return cloth.error();
        return impl_->simulation.add(std::move(cloth).value());
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
    return without_exceptions([&]() -> Result<void> {
        Simulation& simulation = impl_->simulation;
        if (!simulation.cloths.erase(id)) return stale_id("ClothId", id);
        simulation.cloth_has_gone();
        return {};
    });
}

Result<ClothSettings> World::cloth_settings(ClothId id) const {
    return with_cloth(impl_->simulation, id,
                      [](const Cloth& cloth) { return Result<ClothSettings>(cloth.settings); });
}

Result<void> World::set_cloth_settings(ClothId id, const ClothSettings& settings) {
    return with_cloth(impl_->simulation, id, [&](Cloth& cloth) -> Result<void> {
        if (auto valid = validate(settings); !valid) return valid;
        impl_->simulation.apply(cloth, settings);
        return {};
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

Result<void> World::pin(ClothId id, std::span<const std::uint32_t> vertices) {
    return with_particles(impl_->simulation, id, vertices,
                          [](Cloth& cloth, const auto& particles) { cloth.pin(particles); });
}

Result<void> World::unpin(ClothId id, std::span<const std::uint32_t> vertices) {
    return with_particles(impl_->simulation, id, vertices,
                          [](Cloth& cloth, const auto& particles) { cloth.unpin(particles); });
}

Result<void> World::move_pin(ClothId id, std::uint32_t vertex, const Vec3& target) {
    return move_pins(id, {&vertex, 1}, {&target, 1});
}

Result<void> World::move_pins(ClothId id, std::span<const std::uint32_t> vertices,
                              std::span<const Vec3> targets) {
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
}

Result<ShapeId> World::add_shape(const Shape& shape) {
    return without_exceptions([&]() -> Result<ShapeId> {
        auto held = HeldShape::make(shape);
        if (!held) return held.error();
        return impl_->simulation.shapes.insert(std::make_unique<HeldShape>(std::move(held).value()));
    });
}

Result<void> World::deform_shape(ShapeId id, std::span<const Vec3> vertices) {
    return without_exceptions([&]() -> Result<void> {
        auto* const held = impl_->simulation.shapes.find(id);
        if (held == nullptr) return stale_id("ShapeId", id);
        return (*held)->deform(vertices, impl_->simulation.state.steps + 1);
    });
}

Result<void> World::remove_shape(ShapeId id) {
    return without_exceptions([&]() -> Result<void> {
        Simulation& simulation = impl_->simulation;
        const auto* const held = simulation.shapes.find(id);
        if (held == nullptr) return stale_id("ShapeId", id);
        std::size_t instances = 0;
        simulation.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
            instances += simulation.held_by(slot.target) == held->get() ? 1 : 0;
        });
        if (instances > 0)
            return Error{ErrorCode::invalid_argument, std::to_string(instances) +
                                                          " colliders are instances of the shape; remove "
                                                          "them first"};
        simulation.shapes.erase(id);
        return {};
    });
}

Result<ShapeInfo> World::shape_info(ShapeId id) const {
    return without_exceptions([&]() -> Result<ShapeInfo> {
        const auto* const held = impl_->simulation.shapes.find(id);
        if (held == nullptr) return stale_id("ShapeId", id);
        return (*held)->info();
    });
}

Result<ColliderId> World::add_collider(const Collider& collider) {
    return without_exceptions([&]() -> Result<ColliderId> {
        Simulation& simulation = impl_->simulation;
        if (const auto valid = validate(collider); !valid) return valid.error();
        if (const auto there = validate_instance(simulation, collider); !there) return there.error();
        const ColliderId id = simulation.state.colliders.insert({collider, collider});
        try {
            simulation.expect_colliders(simulation.state.colliders.size());
        } catch (...) {
            simulation.state.colliders.erase(id);
            throw;
        }
        simulation.expect_crossings(collider);
        return id;
    });
}

Result<void> World::move_collider(ColliderId id, const Collider& target) {
    return with_collider(impl_->simulation, id, target, [&](ColliderSlot& slot) { slot.target = target; });
}

Result<void> World::place_collider(ColliderId id, const Collider& place) {
    return with_collider(impl_->simulation, id, place, [&](ColliderSlot& slot) {
        slot = {.current = place, .target = place};
        impl_->simulation.expect_crossings(place);
    });
}

Result<void> World::remove_collider(ColliderId id) {
    return without_exceptions([&]() -> Result<void> {
        WorldState& state = impl_->simulation.state;
        if (!state.colliders.erase(id)) return stale_id("ColliderId", id);
        if (state.colliders.size() == 0) impl_->simulation.expect_colliders(0);
        return {};
    });
}

Result<Collider> World::collider(ColliderId id) const {
    return without_exceptions([&]() -> Result<Collider> {
        const ColliderSlot* slot = impl_->simulation.state.colliders.find(id);
        if (slot == nullptr) return stale_id("ColliderId", id);
        return slot->current;
    });
}

const StepReport& World::step(float dt) noexcept {
    StepReport& report = impl_->simulation.report;
    if (dt >= least_step && dt <= greatest_step) {
        impl_->simulation.parallel.lend([&] { impl_->simulation.step(dt); });
    } else {
        impl_->simulation.clear_contacts();
        report = {.flags = StepFlags::invalid_dt, .step = impl_->simulation.state.steps};
    }
    return report;
}

const StepReport& World::report() const noexcept {
    return impl_->simulation.report;
}

std::span<const Contact> World::contacts() const noexcept {
    return impl_->simulation.contacts();
}

std::span<const StageTime> World::profile() const {
    return impl_->simulation.profiler.stages();
}

Result<void> World::start_trace(std::size_t max_events) {
    return without_exceptions([&] { return impl_->simulation.profiler.start_trace(max_events); });
}

Result<void> World::write_trace(const std::filesystem::path& file) const {
    return without_exceptions([&] { return impl_->simulation.profiler.write_trace(file); });
}

std::size_t World::save_size() const noexcept {
    return weft::save_size(impl_->simulation);
}

Result<void> World::save(std::span<std::byte> to) const {
    return without_exceptions([&] { return weft::save(impl_->simulation, to); });
}

Result<void> World::restore(std::span<const std::byte> saved) {
    return without_exceptions([&] { return weft::restore(impl_->simulation, saved); });
}

std::uint64_t World::state_hash() const {
    StateHash hash;
    const auto add = [&](auto part) { hash.add(part); };
    for_each_part(std::as_const(impl_->simulation.state), add);
    impl_->simulation.cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) {
        for_each_part(std::as_const(cloth->state), add);
    });
    return hash.value();
}

}  // namespace weft
