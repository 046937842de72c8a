// The defaults of the structs for C are those of C++.

#include "cloth/c/handles.h"

namespace weft::c {

namespace {

// An invalid size leaves the struct as it is: the call that is given the struct reports it.
template <class Of, class C>
void init(C* to, std::size_t size, const Of& of = {}) noexcept {
    if (to == nullptr || size < first_size<C> || size > sizeof(C)) return;
    give(to_c<C>(of), size, to);
}

/// The defaults of the kind of that number; for an unknown number all else is 0.
template <class C, class... Kinds>
[[nodiscard]] C of_kind(std::int32_t kind, const std::variant<Kinds...>& /*which*/) noexcept {
    C c{};
    std::int32_t number = 0;
    static_cast<void>(((number++ == kind && (c = to_c<C>(Kinds{}), true)) || ...));
    c.kind = kind;
    return c;
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

void weft_world_settings_init(WeftWorldSettings* settings, size_t struct_size) {
    if (settings == nullptr || struct_size < first_size<WeftWorldSettings> || struct_size > sizeof *settings)
        return;
    WeftWorldSettings all = to_c<WeftWorldSettings>(weft::WorldSettings{});
    all.executor.width = weft::Executor{}.width;
    give(all, struct_size, settings);
}
void weft_cloth_settings_init(WeftClothSettings* settings, size_t struct_size) {
    init<weft::ClothSettings>(settings, struct_size);
}
void weft_method_init(WeftMethod* method, int32_t kind) {
    if (method != nullptr) *method = of_kind<WeftMethod>(kind, weft::Method{});
}
void weft_collider_init(WeftCollider* collider, size_t struct_size, int32_t kind) {
    init<weft::Collider>(collider, struct_size);
    if (collider == nullptr || collider->struct_size != struct_size) return;
    const WeftCollider common = to_c<WeftCollider>(weft::Collider{});
    WeftCollider all = of_kind<WeftCollider>(kind, weft::Collider{}.shape);
    all.friction = common.friction;
    all.thickness = common.thickness;
    all.restitution = common.restitution;
    all.layers = common.layers;
    all.is_trigger = common.is_trigger;
    give(all, struct_size, collider);
}
void weft_shape_init(WeftShape* shape, size_t struct_size, int32_t kind) {
    if (shape == nullptr || struct_size < first_size<WeftShape> || struct_size > sizeof *shape) return;
    WeftShape all{};
    all.kind = kind;
    all.closed = weft::TriangleMesh{}.closed;
    all.spacing = weft::HeightField{}.spacing;
    all.cell = weft::DistanceField{}.cell;
    give(all, struct_size, shape);
}
void weft_body_settings_init(WeftBodySettings* settings, size_t struct_size) {
    init<weft::BodySettings>(settings, struct_size);
}
void weft_body_state_init(WeftBodyState* state, size_t struct_size) {
    init<weft::BodyState>(state, struct_size);
}
void weft_seam_settings_init(WeftSeamSettings* settings, size_t struct_size) {
    init<weft::SeamSettings>(settings, struct_size);
}
void weft_sheet_settings_init(WeftSheetSettings* settings, size_t struct_size) {
    init<weft::SheetSettings>(settings, struct_size);
}
void weft_proxy_settings_init(WeftProxySettings* settings, size_t struct_size) {
    init<weft::ProxySettings>(settings, struct_size);
}
void weft_drawn_mesh_settings_init(WeftDrawnMeshSettings* settings, size_t struct_size) {
    init<weft::DrawnMeshSettings>(settings, struct_size);
}
void weft_fixed_step_settings_init(WeftFixedStepSettings* settings, size_t struct_size) {
    init<weft::FixedStepSettings>(settings, struct_size);
}
void weft_transform_init(WeftTransform* transform) {
    if (transform != nullptr) *transform = std::bit_cast<WeftTransform>(weft::Transform{});
}
