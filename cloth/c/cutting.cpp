// Cuts and tears for C.

#include <algorithm>

#include "cloth/c/handles.h"
#include "cloth/c/inputs.h"

namespace weft::c {

namespace {

/// The items at `data` as a type that has the same bytes.
template <class Of, class C>
[[nodiscard]] Result<std::span<const Of>> lying(const char* name, const C* data, std::size_t count) {
    static_assert(sizeof(Of) == sizeof(C) && alignof(Of) <= alignof(C));
    if (data == nullptr && count > 0) return no_items(name, count);
    return std::span(reinterpret_cast<const Of*>(data), count);
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

WeftResult weft_cut_mesh(const WeftMesh* mesh, const WeftMeshEdge* edges, size_t count, WeftMesh** cut) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{mesh, "mesh"}, {cut, "cut"}}); !there) return there;
        const auto along = lying<weft::MeshEdge>("edges", edges, count);
        if (!along) return along.error();
        auto made = weft::cut_mesh(mesh->mesh, *along);
        if (!made) return made.error();
        *cut = new WeftMesh{std::move(made->mesh), std::move(made->from), made->added_particles};
        return {};
    });
}

const uint32_t* weft_mesh_cut_from(const WeftMesh* cut, size_t* count) {
    return list<std::uint32_t>(cut == nullptr ? std::span<const std::uint32_t>() : std::span(cut->from),
                               count);
}
uint32_t weft_mesh_added_particles(const WeftMesh* cut) {
    return cut == nullptr ? 0 : cut->added_particles;
}

WeftResult weft_cut_stroke_create(WeftCutStroke** stroke) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{stroke, "stroke"}}); !there) return there;
        *stroke = new WeftCutStroke{};
        return {};
    });
}
void weft_cut_stroke_destroy(WeftCutStroke* stroke) {
    delete stroke;
}

WeftResult weft_edges_along(const WeftMesh* mesh, WeftInput positions, const WeftBlade* blade,
                            WeftCutStroke* stroke, const WeftMeshEdge** edges, size_t* count) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there(
                {{mesh, "mesh"}, {blade, "blade"}, {stroke, "stroke"}, {edges, "edges"}, {count, "count"}});
            !there)
            return there;
        std::vector<weft::Vec3> room;
        const auto places = items("positions", positions, room);
        if (!places) return places.error();
        auto found =
            weft::edges_along(mesh->mesh, *places, std::bit_cast<weft::Blade>(*blade), stroke->stroke);
        if (!found) return found.error();
        stroke->edges = *std::move(found);
        *edges = list<WeftMeshEdge>(std::span<const weft::MeshEdge>(stroke->edges), count);
        return {};
    });
}

WeftResult weft_edges_to_tear(const WeftMesh* mesh, WeftInput positions, const WeftStrainedEdge* strained,
                              size_t count, WeftMeshEdge* to, size_t room, size_t* found) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{mesh, "mesh"}, {to, "to"}, {found, "found"}}); !there) return there;
        std::vector<weft::Vec3> copied;
        const auto places = items("positions", positions, copied);
        if (!places) return places.error();
        const auto pulled = lying<weft::StrainedEdge>("strained", strained, count);
        if (!pulled) return pulled.error();
        const auto torn = weft::edges_to_tear(mesh->mesh, *places, *pulled);
        if (!torn) return torn.error();
        for (std::size_t k = 0; k < std::min(room, torn->size()); ++k)
            to[k] = std::bit_cast<WeftMeshEdge>((*torn)[k]);
        *found = torn->size();
        return {};
    });
}

WeftResult weft_world_recut_cloth(WeftWorld* world, WeftClothId id, const WeftMesh* cut) {
    return on(world, {{cut, "cut"}}, [&](weft::World& of) {
        return of.recut_cloth(std::bit_cast<weft::ClothId>(id), cut->mesh, cut->from);
    });
}
WeftResult weft_world_strained_edges(const WeftWorld* world, WeftClothId id, float strain,
                                     WeftStrainedEdge* to, size_t room, uint32_t* written) {
    return on(world, {{to, "to"}, {written, "written"}}, [&](const weft::World& of) -> weft::Result<void> {
        const std::span<weft::StrainedEdge> edges(reinterpret_cast<weft::StrainedEdge*>(to), room);
        const auto count = of.strained_edges(std::bit_cast<weft::ClothId>(id), strain, edges);
        if (!count) return count.error();
        *written = *count;
        return {};
    });
}
