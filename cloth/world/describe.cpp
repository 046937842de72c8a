// World::describe(): all that a World holds, as text or JSON.

#include "cloth/record/world_calls.h"
#include "cloth/world/drawing/outline.h"

namespace weft {

namespace {

void describe_cloth(Outline& outline, const Simulation& simulation, ClothId id, const Cloth& cloth) {
    outline.value("id", id);
    outline.value("pins", cloth.state.pins.size());
    outline.value("attached", cloth.attached.size());
    outline.value("bounds", Bounds{cloth.extent.lower, cloth.extent.upper});
    outline.value("report", simulation.report_of(cloth));
    outline.value("info", cloth.info());
    outline.value("settings", cloth.settings);
}

std::uint64_t memory_of(const Simulation& simulation) {
    std::uint64_t bytes = simulation.common_bytes();
    simulation.cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) {
        bytes += cloth->info().bytes - cloth->scratch_bytes - cloth->zone_bytes();
    });
    simulation.shapes.for_each(
        [&](ShapeId, const std::unique_ptr<HeldShape>& shape) { bytes += shape->info().bytes; });
    return bytes;
}

std::string description_of(const Simulation& simulation, DescriptionFormat format) {
    Outline outline(format);
    outline.value("bytes", memory_of(simulation));
    outline.value("bytes_to_spare", std::uint64_t{simulation.bytes_to_spare()});
    outline.value("report", simulation.report);
    outline.value("settings", simulation.settings);
    outline.list("cloths", [&] {
        simulation.cloths.for_each([&](ClothId id, const std::unique_ptr<Cloth>& cloth) {
            outline.object("", [&] { describe_cloth(outline, simulation, id, *cloth); });
        });
    });
    outline.list("colliders", [&] {
        simulation.state.colliders.for_each([&](ColliderId id, const ColliderSlot& slot) {
            outline.object("", [&] {
                outline.value("id", id);
                if (slot.body != BodyId{}) outline.value("body", slot.body);
                outline.fields(slot.current);
            });
        });
    });
    outline.list("bodies", [&] {
        simulation.state.bodies.for_each([&](BodyId id, const BodySlot& slot) {
            outline.object("", [&] {
                outline.value("id", id);
                outline.value("settings", slot.settings);
                outline.value("state", slot.state);
            });
        });
    });
    outline.list("seams", [&] {
        simulation.state.seams.for_each([&](SeamId id, const SeamState& seam) {
            outline.object("", [&] {
                outline.value("id", id);
                outline.fields(simulation.info_of(id));
                outline.value("settings", seam.settings);
            });
        });
    });
    outline.list("shapes", [&] {
        simulation.shapes.for_each([&](ShapeId id, const std::unique_ptr<HeldShape>& shape) {
            outline.object("", [&] {
                outline.value("id", id);
                outline.fields(shape->info());
            });
        });
    });
    return std::move(outline).finish();
}

}  // namespace

Result<std::string> World::describe(DescriptionFormat format) const {
    return impl_->read("describe",
                       [&]() -> Result<std::string> { return description_of(impl_->simulation, format); });
}

}  // namespace weft
