// Shapes, colliders and bodies for C.

#include "cloth/c/handles.h"
#include "cloth/c/inputs.h"

namespace weft::c {

namespace {

/// Copies of a shape's lists that are not contiguous.
struct ShapeRoom {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<float> heights;
};

[[nodiscard]] Result<Shape> shape_of(const WeftShape* given, ShapeRoom& room) {
    WeftShape defaults;
    weft_shape_init(&defaults, sizeof defaults, WEFT_TRIANGLE_MESH);
    const Result<WeftShape> shape = taken("shape", given, defaults);
    if (!shape) return shape.error();
    const auto vertices = items("vertices", shape->vertices, room.vertices);
    if (!vertices) return vertices.error();
    const auto triangles = items("triangles", shape->triangles, room.triangles);
    if (!triangles) return triangles.error();
    const auto heights = items("heights", shape->heights, room.heights);
    if (!heights) return heights.error();
    const TriangleMesh mesh{*vertices, *triangles, shape->closed != 0};
    switch (shape->kind) {
        case WEFT_TRIANGLE_MESH:
            return Shape(mesh);
        case WEFT_CONVEX_HULL:
            return Shape(ConvexHull{*vertices});
        case WEFT_HEIGHT_FIELD:
            return Shape(HeightField{shape->rows, shape->columns, shape->spacing, *heights});
        case WEFT_DISTANCE_FIELD:
            return Shape(DistanceField{mesh, shape->cell});
        default:
            return out_of_choices("kind", shape->kind, std::variant_size_v<Shape>);
    }
}

/// Calls act(world, collider).
template <class Act>
[[nodiscard]] WeftResult with_collider(WeftWorld* world, const WeftCollider* collider,
                                       const Act& act) noexcept {
    return on(world, {{collider, "collider"}}, [&](World& of) -> Result<void> {
        const auto given = take<Collider>("collider", collider);
        if (!given) return given.error();
        return act(of, *given);
    });
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

WeftResult weft_world_add_shape(WeftWorld* world, const WeftShape* shape, WeftShapeId* id) {
    return on(world, {{shape, "shape"}, {id, "id"}}, [&](weft::World& of) -> weft::Result<void> {
        ShapeRoom room;
        const auto given = shape_of(shape, room);
        if (!given) return given.error();
        return put(of.add_shape(*given), id);
    });
}
WeftResult weft_world_deform_shape(WeftWorld* world, WeftShapeId id, WeftInput vertices) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        const auto places = items("vertices", vertices, world->first);
        if (!places) return places.error();
        return of.deform_shape(std::bit_cast<weft::ShapeId>(id), *places);
    });
}
WeftResult weft_world_remove_shape(WeftWorld* world, WeftShapeId id) {
    return on(world, [&](weft::World& of) { return of.remove_shape(std::bit_cast<weft::ShapeId>(id)); });
}
WeftResult weft_world_shape_info(const WeftWorld* world, WeftShapeId id, WeftShapeInfo* info) {
    return on(world, [&](const weft::World& of) {
        return hand("info", of.shape_info(std::bit_cast<weft::ShapeId>(id)), info);
    });
}

WeftResult weft_world_add_collider(WeftWorld* world, const WeftCollider* collider, WeftColliderId* id) {
    return with_collider(world, collider,
                         [&](weft::World& of, const weft::Collider& given) -> weft::Result<void> {
                             if (auto there = are_there({{id, "id"}}); !there) return there;
                             return put(of.add_collider(given), id);
                         });
}
WeftResult weft_world_move_collider(WeftWorld* world, WeftColliderId id, const WeftCollider* target) {
    return with_collider(world, target, [&](weft::World& of, const weft::Collider& given) {
        return of.move_collider(std::bit_cast<weft::ColliderId>(id), given);
    });
}
WeftResult weft_world_place_collider(WeftWorld* world, WeftColliderId id, const WeftCollider* place) {
    return with_collider(world, place, [&](weft::World& of, const weft::Collider& given) {
        return of.place_collider(std::bit_cast<weft::ColliderId>(id), given);
    });
}
WeftResult weft_world_remove_collider(WeftWorld* world, WeftColliderId id) {
    return on(world,
              [&](weft::World& of) { return of.remove_collider(std::bit_cast<weft::ColliderId>(id)); });
}
WeftResult weft_world_collider(const WeftWorld* world, WeftColliderId id, WeftCollider* collider) {
    return on(world, [&](const weft::World& of) {
        return hand("collider", of.collider(std::bit_cast<weft::ColliderId>(id)), collider);
    });
}

WeftResult weft_world_add_body(WeftWorld* world, const WeftBodySettings* settings, const WeftBodyState* state,
                               WeftBodyId* id) {
    return on(world, {{id, "id"}}, [&](weft::World& of) -> weft::Result<void> {
        const auto given = take<weft::BodySettings>("settings", settings);
        if (!given) return given.error();
        const auto where = take<weft::BodyState>("state", state);
        if (!where) return where.error();
        return put(of.add_body(*given, *where), id);
    });
}
WeftResult weft_world_remove_body(WeftWorld* world, WeftBodyId id) {
    return on(world, [&](weft::World& of) { return of.remove_body(std::bit_cast<weft::BodyId>(id)); });
}
WeftResult weft_world_body_settings(const WeftWorld* world, WeftBodyId id, WeftBodySettings* settings) {
    return on(world, [&](const weft::World& of) {
        return hand("settings", of.body_settings(std::bit_cast<weft::BodyId>(id)), settings);
    });
}
WeftResult weft_world_set_body_settings(WeftWorld* world, WeftBodyId id, const WeftBodySettings* settings) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        const auto given = take<weft::BodySettings>("settings", settings);
        if (!given) return given.error();
        return of.set_body_settings(std::bit_cast<weft::BodyId>(id), *given);
    });
}
WeftResult weft_world_body_state(const WeftWorld* world, WeftBodyId id, WeftBodyState* state) {
    return on(world, [&](const weft::World& of) {
        return hand("state", of.body_state(std::bit_cast<weft::BodyId>(id)), state);
    });
}
WeftResult weft_world_set_body_state(WeftWorld* world, WeftBodyId id, const WeftBodyState* state) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        const auto where = take<weft::BodyState>("state", state);
        if (!where) return where.error();
        return of.set_body_state(std::bit_cast<weft::BodyId>(id), *where);
    });
}
WeftResult weft_world_attach_collider(WeftWorld* world, WeftBodyId id, WeftColliderId collider) {
    return on(world, [&](weft::World& of) {
        return of.attach_collider(std::bit_cast<weft::BodyId>(id), std::bit_cast<weft::ColliderId>(collider));
    });
}
WeftResult weft_world_detach_collider(WeftWorld* world, WeftColliderId collider) {
    return on(world,
              [&](weft::World& of) { return of.detach_collider(std::bit_cast<weft::ColliderId>(collider)); });
}
const WeftBodyImpulse* weft_world_body_impulses(const WeftWorld* world, size_t* count) {
    return list<WeftBodyImpulse>(
        world == nullptr ? std::span<const weft::BodyImpulse>() : world->world->body_impulses(), count);
}
