// For C: hooks, drawn meshes, named fabrics, and the clock of a game loop.

#include "cloth/c/handles.h"
#include "cloth/c/inputs.h"

namespace weft::c {

namespace {

WeftHooks hooks_of_host{};

void log_to_host(void* /*user*/, LogLevel level, const char* line) {
    hooks_of_host.log(hooks_of_host.user, static_cast<std::int32_t>(level), line);
}

[[nodiscard]] const std::vector<WeftNamedFabric>& named_fabrics() {
    static const std::vector<WeftNamedFabric> all = [] {
        std::vector<WeftNamedFabric> made;
        for (const NamedFabric& of : fabrics())
            made.push_back({of.name, to_c<WeftFabric>(of.fabric), of.source});
        return made;
    }();
    return all;
}

/// Error: `to` is not aligned to 16 bytes.
[[nodiscard]] Result<std::span<Vec4>> aligned_vertices(const char* name, WeftVec4* to, std::size_t count) {
    if (to == nullptr) return std::span<Vec4>();
    if (reinterpret_cast<std::uintptr_t>(to) % alignof(Vec4) != 0)
        return Error{ErrorCode::invalid_argument, std::string(name) + " is not aligned to 16 bytes"};
    return std::span(reinterpret_cast<Vec4*>(to), count);
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

const WeftNamedFabric* weft_fabrics(size_t* count) {
    const WeftNamedFabric* all = nullptr;
    std::size_t found = 0;
    const WeftResult done = guarded([&]() -> weft::Result<void> {
        all = named_fabrics().data();
        found = named_fabrics().size();
        return {};
    });
    if (count != nullptr) *count = done == WEFT_OK ? found : 0;
    return all;
}
WeftResult weft_fabric_named(const char* name, WeftFabric* fabric) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{name, "name"}, {fabric, "fabric"}}); !there) return there;
        const auto found = weft::Fabric::named(name);
        if (!found) return found.error();
        *fabric = to_c<WeftFabric>(*found);
        return {};
    });
}
int32_t weft_resolved_time_scheme(const WeftClothSettings* settings) {
    weft::TimeScheme scheme = weft::TimeScheme::of_method;
    const WeftResult done = guarded([&]() -> weft::Result<void> {
        const auto of = take<weft::ClothSettings>("settings", settings);
        if (!of) return of.error();
        scheme = weft::resolved(of->time_scheme, of->method);
        return {};
    });
    return done == WEFT_OK ? static_cast<std::int32_t>(scheme) : WEFT_TIME_OF_METHOD;
}

WeftResult weft_drawn_mesh_bind(const WeftWorld* world, WeftClothId cloth, const WeftDrawnSurface* surface,
                                const WeftDrawnMeshSettings* settings, WeftDrawnMesh** mesh) {
    return on(
        world, {{surface, "surface"}, {mesh, "mesh"}}, [&](const weft::World& of) -> weft::Result<void> {
            const auto view = of.cloth(std::bit_cast<weft::ClothId>(cloth));
            if (!view) return view.error();
            const auto given = taken("surface", surface, WeftDrawnSurface{});
            if (!given) return given.error();
            const auto how = take<weft::DrawnMeshSettings>("settings", settings);
            if (!how) return how.error();
            std::vector<weft::Vec3> vertex_room, normal_room;
            std::vector<weft::Triangle> triangle_room;
            std::vector<weft::Vec2> texcoord_room;
            const auto vertices = items("vertices", given->vertices, vertex_room);
            if (!vertices) return vertices.error();
            const auto triangles = items("triangles", given->triangles, triangle_room);
            if (!triangles) return triangles.error();
            const auto texcoords = items("texcoords", given->texcoords, texcoord_room);
            if (!texcoords) return texcoords.error();
            const auto normals = items("normals", given->normals, normal_room);
            if (!normals) return normals.error();
            return put_handle(
                weft::DrawnMesh::bind(*view, {*vertices, *triangles, *texcoords, *normals}, *how), mesh);
        });
}
size_t weft_drawn_mesh_size(const WeftDrawnMesh* mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.size();
}
WeftResult weft_drawn_mesh_update(const WeftDrawnMesh* mesh, const WeftWorld* world, WeftClothId cloth,
                                  WeftVec4* positions, WeftVec4* normals, WeftVec4* tangents, size_t first,
                                  size_t count) {
    return on(world, {{mesh, "mesh"}}, [&](const weft::World& of) -> weft::Result<void> {
        const auto view = of.cloth(std::bit_cast<weft::ClothId>(cloth));
        if (!view) return view.error();
        const std::size_t room = mesh->mesh.size();
        const auto to_positions = aligned_vertices("positions", positions, room);
        if (!to_positions) return to_positions.error();
        const auto to_normals = aligned_vertices("normals", normals, room);
        if (!to_normals) return to_normals.error();
        const auto to_tangents = aligned_vertices("tangents", tangents, room);
        if (!to_tangents) return to_tangents.error();
        mesh->mesh.update(*view, {*to_positions, *to_normals, *to_tangents}, first, count);
        return {};
    });
}
WeftResult weft_drawn_mesh_begin_blend(WeftDrawnMesh* mesh, const WeftWorld* world, WeftClothId cloth,
                                       const WeftVec4* positions, const WeftVec4* normals) {
    return on(world, {{mesh, "mesh"}, {positions, "positions"}},
              [&](const weft::World& of) -> weft::Result<void> {
                  const auto view = of.cloth(std::bit_cast<weft::ClothId>(cloth));
                  if (!view) return view.error();
                  const std::size_t count = mesh->mesh.size();
                  const auto from = [&](const WeftVec4* rows) {
                      std::vector<weft::Vec4> read;
                      for (std::size_t v = 0; rows != nullptr && v < count; ++v)
                          read.push_back(std::bit_cast<weft::Vec4>(rows[v]));
                      return read;
                  };
                  return mesh->mesh.begin_blend(*view, from(positions), from(normals));
              });
}
WeftResult weft_drawn_mesh_blend(WeftDrawnMesh* mesh, float left) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{mesh, "mesh"}}); !there) return there;
        return mesh->mesh.blend(left);
    });
}
const WeftDrawnBond* weft_drawn_mesh_bonds(const WeftDrawnMesh* mesh) {
    static_assert(sizeof(WeftDrawnBond) == sizeof(weft::DrawnBond));
    static_assert(offsetof(WeftDrawnBond, handedness) == offsetof(weft::DrawnBond, handedness));
    return mesh == nullptr ? nullptr : reinterpret_cast<const WeftDrawnBond*>(mesh->mesh.bonds().data());
}
float weft_drawn_mesh_rounding(const WeftDrawnMesh* mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.rounding();
}
size_t weft_drawn_mesh_save_size(const WeftDrawnMesh* mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.save_size();
}
WeftResult weft_drawn_mesh_save(const WeftDrawnMesh* mesh, void* to, size_t bytes) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{mesh, "mesh"}, {to, "to"}}); !there) return there;
        return mesh->mesh.save({static_cast<std::byte*>(to), bytes});
    });
}
WeftResult weft_drawn_mesh_load(const void* saved, size_t bytes, const WeftWorld* world, WeftClothId cloth,
                                WeftDrawnMesh** mesh) {
    return on(world, {{saved, "saved"}, {mesh, "mesh"}}, [&](const weft::World& of) -> weft::Result<void> {
        const auto view = of.cloth(std::bit_cast<weft::ClothId>(cloth));
        if (!view) return view.error();
        return put_handle(weft::DrawnMesh::load({static_cast<const std::byte*>(saved), bytes}, *view), mesh);
    });
}
WeftResult weft_carry_state(WeftWorld* world, WeftClothId from, WeftClothId to, const WeftDrawnMesh* bonds) {
    return on(world, {{bonds, "bonds"}}, [&](weft::World& of) {
        return weft::carry_state(of, std::bit_cast<weft::ClothId>(from), std::bit_cast<weft::ClothId>(to),
                                 bonds->mesh);
    });
}
void weft_drawn_mesh_destroy(WeftDrawnMesh* mesh) {
    delete mesh;
}

WeftResult weft_fixed_step_create(const WeftFixedStepSettings* settings, WeftFixedStep** clock) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{clock, "clock"}}); !there) return there;
        const auto of = take<weft::FixedStepSettings>("settings", settings);
        if (!of) return of.error();
        return put_handle(weft::FixedStep::create(*of), clock);
    });
}
WeftFixedStepFrame weft_fixed_step_advance(WeftFixedStep* clock, double frame_seconds) {
    if (clock == nullptr) return {};
    const weft::FixedStepFrame frame = clock->clock.advance(frame_seconds);
    return {frame.steps, frame.alpha, frame.dropped_seconds};
}
void weft_fixed_step_reset(WeftFixedStep* clock) {
    if (clock != nullptr) clock->clock.reset();
}
WeftResult weft_fixed_step_settings(const WeftFixedStep* clock, WeftFixedStepSettings* settings) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{clock, "clock"}}); !there) return there;
        return fill("settings", to_c<WeftFixedStepSettings>(clock->clock.settings()), settings);
    });
}
void weft_fixed_step_destroy(WeftFixedStep* clock) {
    delete clock;
}

WeftResult weft_set_hooks(const WeftHooks* hooks) {
    return guarded([&]() -> weft::Result<void> {
        const auto given = taken("hooks", hooks, WeftHooks{});
        if (!given) return given.error();
        auto done = weft::set_hooks({.user = given->user,
                                     .allocate = given->allocate,
                                     .release = given->release,
                                     .log = given->log == nullptr ? nullptr : log_to_host,
                                     .failed_assertion = given->failed_assertion,
                                     .begin_zone = given->begin_zone,
                                     .end_zone = given->end_zone});
        if (done) hooks_of_host = *given;
        return done;
    });
}
WeftMemoryUse weft_memory_in_use(void) {
    const weft::MemoryUse use = weft::memory_in_use();
    return {use.bytes, use.blocks};
}
