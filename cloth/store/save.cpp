#include "cloth/store/save.h"

#include <string>
#include <utility>
#include <vector>

#include "cloth/simulation/simulation.h"
#include "cloth/store/check_saved.h"
#include "cloth/store/parts.h"
#include "cloth/store/read_cloth.h"

namespace weft {

namespace {

Error other_world(std::string why) {
    return {ErrorCode::invalid_argument, "the save is of another World: " + std::move(why)};
}

std::uint32_t kinds_of(const WorldState& state) {
    std::uint32_t kinds = 1;
    state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        kinds = 31 * kinds + static_cast<std::uint32_t>(slot.current.shape.index());
    });
    return kinds;
}

std::uint32_t attached_of(const Simulation& simulation) {
    std::size_t count = 0;
    simulation.state.colliders.for_each(
        [&](ColliderId, const ColliderSlot& slot) { count += slot.body == BodyId{} ? 0 : 1; });
    simulation.cloths.for_each(
        [&](ClothId, const std::unique_ptr<Cloth>& cloth) { count += cloth->attached.size(); });
    return static_cast<std::uint32_t>(count);
}

std::uint32_t deformable_of(const Simulation& simulation) {
    std::uint32_t vertices = 0;
    simulation.shapes.for_each([&](ShapeId, const std::unique_ptr<HeldShape>& shape) {
        vertices += static_cast<std::uint32_t>(shape->deformable());
    });
    return vertices;
}

/// By places of cloths in the order of their ids, which differ between Worlds.
std::uint32_t sewn_of(const Simulation& simulation) {
    std::uint32_t sewn = 1;
    const auto add = [&](std::uint32_t number) { sewn = 31 * sewn + number; };
    const auto place_of = [&](ClothId wanted) {
        std::uint32_t place = 0;
        simulation.cloths.for_each(
            [&](ClothId id, const auto&) { place += id.index < wanted.index ? 1 : 0; });
        return place;
    };
    simulation.state.seams.for_each([&](SeamId, const SeamState& seam) {
        for (const ClothId cloth : seam.cloths) add(place_of(cloth));
        add(static_cast<std::uint32_t>(seam.stitches.size()));
        for (const Stitch& stitch : seam.stitches)
            for (const std::uint32_t particle : stitch.particles) add(particle);
    });
    return sewn;
}

SaveHead head_of(const Simulation& simulation) {
    SaveSize before;
    for_each_part_before_cloths(simulation, before);
    return {.cloths = static_cast<std::uint32_t>(simulation.cloths.size()),
            .colliders = static_cast<std::uint32_t>(simulation.state.colliders.size()),
            .bodies = static_cast<std::uint32_t>(simulation.state.bodies.size()),
            .attached = attached_of(simulation),
            .kinds = kinds_of(simulation.state),
            .shapes = static_cast<std::uint32_t>(simulation.shapes.size()),
            .deformable = deformable_of(simulation),
            .seams = static_cast<std::uint32_t>(simulation.state.seams.size()),
            .sewn = sewn_of(simulation),
            .garments = simulation.garments.size(),
            .before_cloths = before.bytes(),
            .bytes = save_size(simulation)};
}

Result<void> check_world(const SaveHead& head, const Simulation& simulation) {
    const SaveHead here = head_of(simulation);
    if (head.cloths != here.cloths)
        return other_world("it has " + std::to_string(head.cloths) + " cloths, this one has " +
                           std::to_string(here.cloths) +
                           "; restore_cloths() restores those that have the same ClothSettings::key");
    if (head.colliders != here.colliders)
        return other_world("it has " + std::to_string(head.colliders) + " colliders, this one has " +
                           std::to_string(here.colliders));
    if (head.bodies != here.bodies)
        return other_world("it has " + std::to_string(head.bodies) + " bodies, this one has " +
                           std::to_string(here.bodies));
    if (head.attached != here.attached)
        return other_world("it has " + std::to_string(head.attached) +
                           " colliders and vertices attached to bodies, this one has " +
                           std::to_string(here.attached));
    if (head.kinds != here.kinds) return other_world("its colliders are of other kinds, or in another order");
    if (head.shapes != here.shapes)
        return other_world("it has " + std::to_string(head.shapes) + " shapes, this one has " +
                           std::to_string(here.shapes));
    if (head.deformable != here.deformable)
        return other_world("its triangle meshes have " + std::to_string(head.deformable) +
                           " vertices, those here " + std::to_string(here.deformable));
    if (head.seams != here.seams)
        return other_world("it has " + std::to_string(head.seams) + " seams, this one has " +
                           std::to_string(here.seams));
    if (head.garments != here.garments)
        return other_world("it has " + std::to_string(head.garments) +
                           " garments with levels, this one has " + std::to_string(here.garments));
    if (head.sewn != here.sewn) return other_world("its seams join other vertices, or are in another order");
    return {};
}

struct SavedDeformation {
    std::vector<Vec3> vertices, displacements;
    std::uint64_t step = 0;
};

/// Before anything is changed: checks the part of each shape, and allocates the memory that it needs.
Result<std::vector<SavedDeformation>> prepare_shapes(Simulation& simulation, const SaveReader& reader) {
    std::vector<SavedDeformation> read;
    Result<void> checked;
    simulation.shapes.for_each([&](ShapeId, std::unique_ptr<HeldShape>& shape) {
        if (!checked) return;
        ShapeHead head;
        if (checked = check_left(reader, sizeof head); !checked) return;
        reader(std::span(&head, 1));
        if (head.vertices != 0 && head.vertices != shape->deformable()) {
            checked = other_world("its shape " + std::to_string(read.size()) + " has " +
                                  std::to_string(head.vertices) + " vertices, the one here " +
                                  std::to_string(shape->deformable()));
            return;
        }
        if (head.vertices != 0) {
            const std::size_t follow = 2 * sizeof(Vec3) * head.vertices + sizeof SavedDeformation::step;
            if (checked = check_left(reader, follow); !checked) return;
            if (checked = check_shape_part(read.size(), head, reader.after(0)); !checked) return;
        }
        SavedDeformation& made = read.emplace_back();
        if (head.vertices == 0) return;
        shape->prepare_deformation();
        made.vertices.resize(head.vertices);
        made.displacements.resize(head.displacements);
        reader(std::span(made.vertices));
        reader(std::span(made.displacements));
        reader(std::span(&made.step, 1));
    });
    if (!checked) return checked.error();
    return read;
}

/// Before anything is changed: checks the part of each cloth, and allocates what its pins need.
Result<std::vector<ReadCloth>> prepare_cloths(Simulation& simulation, std::size_t bodies,
                                              const SaveReader& reader) {
    std::vector<ReadCloth> cloths;
    Result<void> checked;
    simulation.cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        if (!checked) return;
        ClothHead head;
        if (checked = check_left(reader, sizeof head); !checked) return;
        reader(std::span(&head, 1));
        const std::string name = "its cloth " + std::to_string(cloths.size());
        if (head.key != cloth->settings.key) {
            checked = does_not_fit(name + " has the key " + std::to_string(head.key) + ", the one here " +
                                   std::to_string(cloth->settings.key) +
                                   "; restore_cloths() finds cloths by their keys");
            return;
        }
        auto read = prepare_cloth(simulation, *cloth, name, head, bodies, reader);
        if (read)
            cloths.push_back(*std::move(read));
        else
            checked = read.error();
    });
    if (!checked) return checked.error();
    if (reader.left() > 0)
        return refused("goes on for " + std::to_string(reader.left()) + " bytes behind its last cloth");
    return cloths;
}

}  // namespace

std::size_t save_size(const Simulation& simulation) {
    SaveSize size;
    for_each_part(simulation, size);
    return sizeof(SaveHead) + size.bytes();
}

Result<void> save(const Simulation& simulation, std::span<std::byte> to) {
    return write_save("save", head_of(simulation), to,
                      [&](const SaveWriter& writer) { for_each_part(simulation, writer); });
}

Result<void> restore(Simulation& simulation, std::span<const std::byte> saved) {
    const auto head = read_head(saved, save_mark);
    if (!head) return head.error();
    if (auto checked = check_world(*head, simulation); !checked) return checked;
    SaveSize of_world;
    for_each_part(std::as_const(simulation.state), of_world);
    const SaveReader reader(saved.subspan(sizeof(SaveHead)));
    if (auto there = check_left(reader, of_world.bytes()); !there) return there;
    if (auto sound = check_world_part(simulation, reader.after(0)); !sound) return sound;
    const SaveReader ahead = reader.after(of_world.bytes());
    const auto deformations = prepare_shapes(simulation, ahead);
    if (!deformations) return deformations.error();
    if (const std::size_t before = reader.left() - ahead.left(); head->before_cloths != before)
        return refused("says that " + std::to_string(head->before_cloths) +
                       " bytes are before its cloths; it must be " + std::to_string(before));
    auto cloths = prepare_cloths(simulation, head->bodies, ahead);
    if (!cloths) return cloths.error();

    // From here on nothing can fail.
    for_each_part(simulation.state, reader);
    simulation.enable_restored_levels();
    auto of_shape = deformations->begin();
    simulation.shapes.for_each([&](ShapeId, std::unique_ptr<HeldShape>& shape) {
        shape->put_back({of_shape->vertices, of_shape->displacements, of_shape->step});
        ++of_shape;
    });
    for (ReadCloth& cloth : *cloths) overwrite_cloth(simulation, cloth);
    for (const std::unique_ptr<SeamRows>& seam : simulation.seam_rows)
        if (seam) seam->forget_forces();
    simulation.clear_contacts();
    simulation.clear_body_impulses();
    return {};
}

}  // namespace weft
