#include "cloth/store/save.h"

#include <string>
#include <utility>
#include <vector>

#include "cloth/simulation/simulation.h"
#include "cloth/store/check_saved.h"
#include "cloth/store/parts.h"
#include "cloth/store/save_format.h"
#include "engine/state_hash.h"

namespace weft {

namespace {

Error refused(std::string why) {
    return {ErrorCode::malformed_file, "the save " + std::move(why)};
}
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

std::uint64_t hash_of(std::span<const std::byte> bytes) {
    StateHash hash;
    hash.add(bytes);
    return hash.value();
}

SaveHead head_of(const Simulation& simulation) {
    return {.cloths = static_cast<std::uint32_t>(simulation.cloths.size()),
            .colliders = static_cast<std::uint32_t>(simulation.state.colliders.size()),
            .bodies = static_cast<std::uint32_t>(simulation.state.bodies.size()),
            .attached = attached_of(simulation),
            .kinds = kinds_of(simulation.state),
            .shapes = static_cast<std::uint32_t>(simulation.shapes.size()),
            .deformable = deformable_of(simulation),
            .seams = static_cast<std::uint32_t>(simulation.state.seams.size()),
            .sewn = sewn_of(simulation),
            .bytes = save_size(simulation)};
}

Result<void> check_head(const SaveHead& head, std::span<const std::byte> saved) {
    if (head.mark != save_mark) return refused("is none of Weft's: it does not begin with WEFTSAVE");
    if (head.version != save_version)
        return refused("has version " + std::to_string(head.version) + "; this library reads version " +
                       std::to_string(save_version));
    if (head.bytes != saved.size())
        return refused("has " + std::to_string(head.bytes) + " bytes; " + std::to_string(saved.size()) +
                       " were given");
    if (head.hash != hash_of(saved.subspan(sizeof head)))
        return refused("is damaged: its bytes are not those that were written");
    return {};
}

Result<void> check_world(const SaveHead& head, const Simulation& simulation) {
    const SaveHead here = head_of(simulation);
    if (head.cloths != here.cloths)
        return other_world("it has " + std::to_string(head.cloths) + " cloths, this one has " +
                           std::to_string(here.cloths));
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
    if (head.sewn != here.sewn) return other_world("its seams join other vertices, or are in another order");
    return {};
}

Result<void> check_cloth(std::size_t number, const ClothHead& saved, const ClothHead& here) {
    const auto differs = [&](const char* what, std::uint32_t a, std::uint32_t b, const char* because) {
        return other_world("its cloth " + std::to_string(number) + " has " + std::to_string(a) + ' ' + what +
                           ", the one here " + std::to_string(b) + because);
    };
    if (saved.particles != here.particles)
        return differs("particles", saved.particles, here.particles, "; give it the mesh that it had");
    if (saved.mesh != here.mesh)
        return other_world("its cloth " + std::to_string(number) +
                           " has other triangles than the one here; give it the mesh that it had");
    if (saved.record != here.record)
        return differs("particles in BDF2's record", saved.record, here.record,
                       "; set the time scheme and the method that it had");
    if (saved.held != here.held)
        return differs("particles held by colliders", saved.held, here.held,
                       "; set the method and the collider response that it had");
    if (saved.tangles != here.tangles)
        return differs("particles with contact", saved.tangles, here.tangles,
                       "; set the self-collision that it had");
    if (saved.rest != here.rest)
        return differs("times of rest", saved.rest, here.rest, "; set ClothSettings::sleep_speed as it was");
    if (saved.skin != here.skin)
        return differs("places and normals of its skin", saved.skin, here.skin,
                       "; set the maps of leashes and backstops that it had");
    if (saved.detail != here.detail)
        return differs("particles with a budget", saved.detail, here.detail,
                       "; set WorldSettings::budget to 0 where it was, and above where it was above");
    if (saved.frame > 1)
        return refused("has " + std::to_string(saved.frame) + " frames of its cloth " +
                       std::to_string(number) + "; it must be 0 or 1");
    return {};
}

/// Error: fewer bytes are left. A correct checksum does not exclude that: it can be computed for any bytes.
Result<void> check_left(const SaveReader& reader, std::size_t bytes) {
    if (reader.left() >= bytes) return {};
    return refused("is not whole, though its checksum is right: " + std::to_string(bytes) +
                   " bytes are to follow, of which there are " + std::to_string(reader.left()));
}

/// Bytes of a cloth's part with the pins and the frame that its head announces.
std::size_t part_bytes(const ClothState& state, const ClothHead& head) {
    SaveSize size;
    for_each_part(state, size);
    const std::size_t a_pin = sizeof(Pin::particle) + 3 * sizeof(float);
    const std::size_t has = a_pin * state.pins.size() + (state.frame ? sizeof(FrameState) : 0);
    return size.bytes() + a_pin * head.pins + head.frame * sizeof(FrameState) - has;
}

std::vector<Pin> read_pins(const SaveReader& reader, std::uint32_t count) {
    std::vector<Pin> pins(count);
    visit_pins(pins, reader);
    return pins;
}

/// Parts of a saved cloth that may differ from the cloth here.
struct Saved {
    std::vector<Pin> pins;
    bool in_frame;
};

/// Reads a cloth's head. Error: bytes are missing, do not fit the cloth here, or hold unsound values.
Result<ClothHead> check_next_cloth(std::size_t number, const ClothState& here, std::uint32_t fingerprint,
                                   const SaveReader& reader) {
    ClothHead head;
    if (auto there = check_left(reader, sizeof head); !there) return there.error();
    reader(std::span(&head, 1));
    if (auto fits = check_cloth(number, head, ClothHead(here, fingerprint)); !fits) return fits.error();
    if (auto there = check_left(reader, part_bytes(here, head)); !there) return there.error();
    if (auto sound = check_cloth_part(number, head, here, reader.after(0)); !sound) return sound.error();
    return head;
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
Result<std::vector<Saved>> prepare_cloths(Simulation& simulation, const SaveReader& reader) {
    std::vector<Saved> cloths;
    Result<void> checked;
    simulation.cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        if (!checked) return;
        const auto head = check_next_cloth(cloths.size(), cloth->state, cloth->model.fingerprint, reader);
        if (!head) {
            checked = head.error();
            return;
        }
        cloths.push_back({read_pins(reader.after(head->bytes_before_pins()), head->pins), head->frame != 0});
        cloth->prepare_restore(cloths.back().pins);
        if (cloths.back().in_frame) cloth->seen_colliders.reserve(simulation.state.colliders.size());
        reader.skip(part_bytes(cloth->state, *head));
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
    SaveHead head = head_of(simulation);
    if (to.size() < head.bytes)
        return Error{ErrorCode::invalid_argument, "save needs " + std::to_string(head.bytes) + " bytes; " +
                                                      std::to_string(to.size()) + " were given"};
    for_each_part(simulation, SaveWriter(to.data() + sizeof head));
    head.hash = hash_of(to.subspan(sizeof head, head.bytes - sizeof head));
    std::memcpy(to.data(), &head, sizeof head);
    return {};
}

Result<void> restore(Simulation& simulation, std::span<const std::byte> saved) {
    SaveHead head;
    if (saved.size() < sizeof head)
        return refused("has " + std::to_string(saved.size()) + " bytes; its head alone takes " +
                       std::to_string(sizeof head));
    std::memcpy(&head, saved.data(), sizeof head);
    if (auto checked = check_head(head, saved); !checked) return checked;
    if (auto checked = check_world(head, simulation); !checked) return checked;
    SaveSize of_world;
    for_each_part(std::as_const(simulation.state), of_world);
    const SaveReader reader(saved.subspan(sizeof head));
    if (auto there = check_left(reader, of_world.bytes()); !there) return there;
    if (auto sound = check_world_part(simulation.state, reader.after(0)); !sound) return sound;
    const SaveReader ahead = reader.after(of_world.bytes());
    const auto deformations = prepare_shapes(simulation, ahead);
    if (!deformations) return deformations.error();
    const SaveReader of_cloths = ahead;
    auto cloths = prepare_cloths(simulation, ahead);
    if (!cloths) return cloths.error();

    // From here on nothing can fail.
    for_each_part(simulation.state, reader);
    auto of_shape = deformations->begin();
    simulation.shapes.for_each([&](ShapeId, std::unique_ptr<HeldShape>& shape) {
        shape->put_back({of_shape->vertices, of_shape->displacements, of_shape->step});
        ++of_shape;
    });
    auto of_cloth = cloths->begin();
    simulation.cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        of_cloths.skip(sizeof(ClothHead));
        cloth->state.pins = std::move(of_cloth->pins);
        cloth->state.frame.reset();
        if (of_cloth++->in_frame) cloth->state.frame.emplace();
        for_each_part(cloth->state, of_cloths);
        simulation.state_has_changed(*cloth);
    });
    for (const std::unique_ptr<SeamRows>& seam : simulation.seam_rows)
        if (seam) seam->forget_forces();
    simulation.clear_contacts();
    simulation.clear_body_impulses();
    return {};
}

}  // namespace weft
