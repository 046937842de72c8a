// Cloths of a World for C.

#include "cloth/c/handles.h"
#include "cloth/c/inputs.h"

namespace weft::c {

namespace {

[[nodiscard]] VertexStream stream_of(const WeftStream& stream) {
    if (stream.data == nullptr) return {};
    return {{static_cast<std::byte*>(stream.data), stream.bytes}, stream.stride};
}

[[nodiscard]] WeftClothView view_of(const ClothView& of) {
    WeftClothView view{};
    view.particles = static_cast<std::uint32_t>(of.positions.size());
    view.vertices = static_cast<std::uint32_t>(of.vertex_to_particle.size());
    view.triangle_count = static_cast<std::uint32_t>(of.triangles.size());
    view.positions = list<WeftVec4>(of.positions, nullptr);
    view.previous_positions = list<WeftVec4>(of.previous_positions, nullptr);
    view.velocities = list<WeftVec4>(of.velocities, nullptr);
    view.normals = list<WeftVec4>(of.normals, nullptr);
    view.triangles = list<WeftTriangle>(of.triangles, nullptr);
    view.vertex_to_particle = list<std::uint32_t>(of.vertex_to_particle, nullptr);
    view.texcoords = list<WeftVec2>(of.texcoords, nullptr);
    view.vertex_triangles = list<WeftTriangle>(of.vertex_triangles, nullptr);
    view.bounds = std::bit_cast<WeftBounds>(of.bounds);
    return view;
}

/// Calls act(world, cloth, vertices).
template <class Act>
[[nodiscard]] WeftResult on_vertices(WeftWorld* world, WeftClothId id, const std::uint32_t* vertices,
                                     std::size_t count, const Act& act) noexcept {
    return on(world, [&](World& of) -> Result<void> {
        const auto named = indices(vertices, count);
        if (!named) return named.error();
        return act(of, id_of(id), *named);
    });
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

WeftResult weft_world_add_cloth(WeftWorld* world, const WeftMesh* mesh, const WeftClothSettings* settings,
                                WeftClothId* id) {
    return on(world, {{mesh, "mesh"}, {id, "id"}}, [&](weft::World& of) -> weft::Result<void> {
        const auto given = take<weft::ClothSettings>("settings", settings);
        if (!given) return given.error();
        return put(of.add_cloth(mesh->mesh, *given), id);
    });
}
WeftResult weft_world_add_cooked_cloth(WeftWorld* world, const WeftCookedCloth* cooked,
                                       const WeftTransform* place, WeftClothId* id) {
    return on(world, {{cooked, "cooked"}, {id, "id"}},
              [&](weft::World& of) { return put(of.add_cloth(cooked->cooked, transform_of(place)), id); });
}
WeftResult weft_world_measure_cloth(const WeftWorld* world, const WeftMesh* mesh,
                                    const WeftClothSettings* settings, WeftClothInfo* info) {
    return on(world, {{mesh, "mesh"}}, [&](const weft::World& of) -> weft::Result<void> {
        const auto given = take<weft::ClothSettings>("settings", settings);
        if (!given) return given.error();
        return hand("info", of.measure_cloth(mesh->mesh, *given), info);
    });
}
WeftResult weft_world_remove_cloth(WeftWorld* world, WeftClothId id) {
    return on(world, [&](weft::World& of) { return of.remove_cloth(id_of(id)); });
}
WeftResult weft_world_cloth_settings(const WeftWorld* world, WeftClothId id, WeftClothSettings* settings) {
    return on(world, [&](const weft::World& of) {
        return hand("settings", of.cloth_settings(id_of(id)), settings);
    });
}
WeftResult weft_world_set_cloth_settings(WeftWorld* world, WeftClothId id,
                                         const WeftClothSettings* settings) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        const auto given = take<weft::ClothSettings>("settings", settings);
        if (!given) return given.error();
        return of.set_cloth_settings(id_of(id), *given);
    });
}
WeftResult weft_world_set_enabled(WeftWorld* world, WeftClothId id, WeftBool enabled) {
    return on(world, [&](weft::World& of) { return of.set_enabled(id_of(id), enabled != 0); });
}
WeftResult weft_world_is_asleep(const WeftWorld* world, WeftClothId id, WeftBool* asleep) {
    return on(world, {{asleep, "asleep"}}, [&](const weft::World& of) -> weft::Result<void> {
        const auto is = of.is_asleep(id_of(id));
        if (!is) return is.error();
        *asleep = *is;
        return {};
    });
}
WeftResult weft_world_wake(WeftWorld* world, WeftClothId id) {
    return on(world, [&](weft::World& of) { return of.wake(id_of(id)); });
}
WeftResult weft_world_set_importance(WeftWorld* world, WeftClothId id, float importance) {
    return on(world, [&](weft::World& of) { return of.set_importance(id_of(id), importance); });
}
WeftResult weft_world_add_level(WeftWorld* world, WeftClothId finest, WeftClothId coarser, float reach) {
    return on(world, [&](weft::World& of) { return of.add_level(id_of(finest), id_of(coarser), reach); });
}
WeftResult weft_world_set_level(WeftWorld* world, WeftClothId id, std::uint32_t level) {
    return on(world, [&](weft::World& of) { return of.set_level(id_of(id), level); });
}
WeftResult weft_world_level(const WeftWorld* world, WeftClothId id, std::uint32_t* level) {
    return on(world, {{level, "level"}},
              [&](const weft::World& of) { return put(of.level(id_of(id)), level); });
}
WeftResult weft_world_filling_info(const WeftWorld* world, WeftClothId id, WeftFillingInfo* info) {
    return on(world, [&](const weft::World& of) { return hand("info", of.filling_info(id_of(id)), info); });
}
WeftResult weft_world_cloth_info(const WeftWorld* world, WeftClothId id, WeftClothInfo* info) {
    return on(world, [&](const weft::World& of) { return hand("info", of.cloth_info(id_of(id)), info); });
}
WeftResult weft_world_cloth(const WeftWorld* world, WeftClothId id, WeftClothView* view) {
    return on(world, [&](const weft::World& of) -> weft::Result<void> {
        const auto seen = of.cloth(id_of(id));
        if (!seen) return seen.error();
        return fill("view", view_of(*seen), view);
    });
}
WeftResult weft_world_write_vertices(const WeftWorld* world, WeftClothId id, const WeftVertexStreams* to,
                                     size_t first, size_t count) {
    return on(world, {{to, "to"}}, [&](const weft::World& of) -> weft::Result<void> {
        const auto streams = taken("to", to, WeftVertexStreams{});
        if (!streams) return streams.error();
        return of.write_vertices(id_of(id),
                                 {.positions = stream_of(streams->positions),
                                  .previous_positions = stream_of(streams->previous_positions),
                                  .normals = stream_of(streams->normals),
                                  .previous_normals = stream_of(streams->previous_normals),
                                  .tangents = stream_of(streams->tangents),
                                  .texcoords = stream_of(streams->texcoords),
                                  .strains = stream_of(streams->strains)},
                                 first, count);
    });
}

WeftResult weft_world_pin(WeftWorld* world, WeftClothId id, const uint32_t* vertices, size_t count) {
    return on_vertices(world, id, vertices, count,
                       [](weft::World& of, weft::ClothId cloth, auto named) { return of.pin(cloth, named); });
}
WeftResult weft_world_unpin(WeftWorld* world, WeftClothId id, const uint32_t* vertices, size_t count) {
    return on_vertices(world, id, vertices, count, [](weft::World& of, weft::ClothId cloth, auto named) {
        return of.unpin(cloth, named);
    });
}
WeftResult weft_world_move_pin(WeftWorld* world, WeftClothId id, uint32_t vertex, WeftVec3 target) {
    return on(world, [&](weft::World& of) {
        return of.move_pin(id_of(id), vertex, std::bit_cast<weft::Vec3>(target));
    });
}
WeftResult weft_world_move_pins(WeftWorld* world, WeftClothId id, const uint32_t* vertices, size_t count,
                                WeftInput targets) {
    return on_vertices(world, id, vertices, count,
                       [&](weft::World& of, weft::ClothId cloth, auto named) -> weft::Result<void> {
                           const auto places = items("targets", targets, world->first);
                           if (!places) return places.error();
                           return of.move_pins(cloth, named, *places);
                       });
}
WeftResult weft_world_attach(WeftWorld* world, WeftBodyId id, WeftClothId cloth, const uint32_t* vertices,
                             size_t count) {
    return on_vertices(world, cloth, vertices, count, [&](weft::World& of, weft::ClothId to, auto named) {
        return of.attach(std::bit_cast<weft::BodyId>(id), to, named);
    });
}
WeftResult weft_world_detach(WeftWorld* world, WeftClothId cloth, const uint32_t* vertices, size_t count) {
    return on_vertices(world, cloth, vertices, count, [](weft::World& of, weft::ClothId from, auto named) {
        return of.detach(from, named);
    });
}

WeftResult weft_world_stitch(WeftWorld* world, WeftClothId a, const uint32_t* vertices_a, WeftClothId b,
                             const uint32_t* vertices_b, size_t count, const WeftSeamSettings* settings,
                             WeftSeamId* id) {
    return on(world, {{id, "id"}}, [&](weft::World& of) -> weft::Result<void> {
        const auto of_a = indices(vertices_a, count), of_b = indices(vertices_b, count);
        if (!of_a) return of_a.error();
        if (!of_b) return of_b.error();
        const auto given = take<weft::SeamSettings>("settings", settings);
        if (!given) return given.error();
        return put(of.stitch(id_of(a), *of_a, id_of(b), *of_b, *given), id);
    });
}
WeftResult weft_world_unstitch(WeftWorld* world, WeftSeamId id) {
    return on(world, [&](weft::World& of) { return of.unstitch(std::bit_cast<weft::SeamId>(id)); });
}
WeftResult weft_world_seam_info(const WeftWorld* world, WeftSeamId id, WeftSeamInfo* info) {
    return on(world, [&](const weft::World& of) {
        return hand("info", of.seam_info(std::bit_cast<weft::SeamId>(id)), info);
    });
}

WeftResult weft_world_move_cloth(WeftWorld* world, WeftClothId id, const WeftTransform* by) {
    return on(world, [&](weft::World& of) { return of.move_cloth(id_of(id), transform_of(by)); });
}
WeftResult weft_world_reset_cloth(WeftWorld* world, WeftClothId id, WeftInput positions) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        const auto there = items("positions", positions, world->first);
        if (!there) return there.error();
        return of.reset_cloth(id_of(id), *there);
    });
}
WeftResult weft_world_resume_cloth(WeftWorld* world, WeftClothId id, WeftInput positions,
                                   WeftInput previous_positions, WeftInput velocities) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        std::vector<weft::Vec3> room;
        const auto there = items("positions", positions, world->first);
        if (!there) return there.error();
        const auto before = items("previous_positions", previous_positions, world->second);
        if (!before) return before.error();
        const auto moving = items("velocities", velocities, room);
        if (!moving) return moving.error();
        return of.resume_cloth(id_of(id), *there, *before, *moving);
    });
}
WeftResult weft_world_set_frame(WeftWorld* world, WeftClothId id, const WeftTransform* pose) {
    return on(world, [&](weft::World& of) { return of.set_frame(id_of(id), transform_of(pose)); });
}
WeftResult weft_world_leave_frame(WeftWorld* world, WeftClothId id) {
    return on(world, [&](weft::World& of) { return of.leave_frame(id_of(id)); });
}
WeftResult weft_world_set_map(WeftWorld* world, WeftClothId id, int32_t map, WeftInput values) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        const auto which = enumerator<weft::Map>(map);
        if (!which) return which.error();
        const auto numbers = items("values", values, world->values);
        if (!numbers) return numbers.error();
        return of.set_map(id_of(id), *which, *numbers);
    });
}
WeftResult weft_world_set_skin(WeftWorld* world, WeftClothId id, WeftInput places, WeftInput normals) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        const auto there = items("places", places, world->first);
        if (!there) return there.error();
        const auto out = items("normals", normals, world->second);
        if (!out) return out.error();
        return of.set_skin(id_of(id), *there, *out);
    });
}
WeftResult weft_world_sample_air(const WeftWorld* world, WeftInput points, WeftStream velocities) {
    return on(world, [&](const weft::World& of) -> weft::Result<void> {
        std::vector<weft::Vec3> room;
        const auto places = items("points", points, room);
        if (!places) return places.error();
        std::vector<weft::Vec3> found(places->size());
        if (auto done = of.sample_air(*places, found); !done) return done;
        return write<weft::Vec3>("velocities", found, velocities);
    });
}
WeftResult weft_world_shift_origin(WeftWorld* world, WeftVec3 to) {
    return on(world, [&](weft::World& of) { return of.shift_origin(std::bit_cast<weft::Vec3>(to)); });
}
