// Sets a cloth's maps of values per vertex. If memory runs out, nothing has changed.

#include <algorithm>
#include <utility>

#include "cloth/instance/cloth.h"
#include "cloth/instance/make_solver.h"
#include "cloth/mesh/rest/linear_bending.h"
#include "engine/memory/without_exceptions.h"

namespace weft {

void Cloth::set_map(Map map, AlignedBuffer<float>&& values, const MakeRoom& make_room) {
    if (map == Map::mass)
        set_masses(std::move(values), make_room);
    else if (map == Map::stiffness)
        set_stiffness(std::move(values), make_room);
    else
        set_worn_map(map, std::move(values));
}

/// Makes the solver anew for the changed model, with all that its steps need.
void Cloth::remake_solver(const MakeRoom& make_room) {
    std::unique_ptr<Solver> made = make_solver(model, settings, state.positions.span());
    made->reserve_pins(state.pins.size());
    if (pairs_in_equation(settings.self_collision) > 0)
        made->reserve_pairs(FeatureContact::room_for_rows(model.particle_count));
    const std::size_t bytes = scratch_of_steps(*made, history.has_value(), settings, contact_mesh.get());
    if (make_room) make_room(bytes);

    // From here on nothing can fail.
    scratch_bytes = bytes;
    solver = std::move(made);
    solver->prepare(settings);
    set_inverse_masses();
    solver->inverse_masses_changed(state.positions.span());
}

void Cloth::set_masses(AlignedBuffer<float>&& values, const MakeRoom& make_room) {
    const std::span<const float> before =
        areas_without_map.size() > 0 ? areas_without_map.span() : model.rest_area.span();
    SharedBuffer<float> areas(before);
    AlignedBuffer<float> kept;
    if (values.size() > 0) {
        kept = AlignedBuffer<float>(model.particle_count);
        std::ranges::copy(before, kept.data());
        for (std::uint32_t i = 0; i < model.particle_count; ++i) areas[i] *= values[i];
    }
    set_areas(std::move(areas), std::move(kept), make_room);
}

void Cloth::set_areas(SharedBuffer<float>&& areas, AlignedBuffer<float>&& without_map,
                      const MakeRoom& make_room) {
    std::swap(model.rest_area, areas);
    or_undo([&] { remake_solver(make_room); }, [&] { std::swap(model.rest_area, areas); });
    areas_without_map = std::move(without_map);
    bending_per_area = find_bending_per_area(model);
}

void Cloth::set_stiffness(AlignedBuffer<float>&& values, const MakeRoom& make_room) {
    SharedBuffer<float> other(std::move(values));
    std::swap(model.stiffness, other);
    or_undo([&] { remake_solver(make_room); }, [&] { std::swap(model.stiffness, other); });
}

/// The values of a map that changes neither masses nor springs.
AlignedBuffer<float>& Cloth::values_of(Map map) noexcept {
    switch (map) {
        case Map::leash:
            return worn.leash;
        case Map::backstop:
            return worn.backstop;
        case Map::backstop_radius:
            return worn.backstop_radius;
        case Map::friction:
            return side_buffers.friction_map;
        case Map::collider_mask:
            return side_buffers.masks;
        default:
            return side_buffers.thickness_map;
    }
}

void Cloth::set_worn_map(Map map, AlignedBuffer<float>&& values) {
    AlignedBuffer<float>& present = values_of(map);
    std::swap(present, values);
    SkinState skin;
    std::optional<ContactBuffers> made;
    const auto room = [&](bool needed, const AlignedBuffer<Vec4>& has) {
        return AlignedBuffer<Vec4>(needed && has.size() == 0 ? model.particle_count : 0);
    };
    or_undo(
        [&] {
            worn.reserve(model.particle_count);
            const bool has_backstop = worn.backstop.size() > 0;
            skin.places = room(worn.has_limits(), state.skin.places);
            skin.target_places = room(worn.has_limits(), state.skin.places);
            skin.normals = room(has_backstop, state.skin.normals);
            skin.target_normals = room(has_backstop, state.skin.normals);
            made = make_contacts(has_colliders_);
        },
        [&] {
            std::swap(present, values);
            if (!worn.has_limits()) worn.reserve(model.particle_count);  // no limits: frees
        });

    // From here on nothing can fail.
    side_buffers.write(settings);
    if (skin.places.size() > 0) {
        state.skin.places = std::move(skin.places);
        state.skin.target_places = std::move(skin.target_places);
    }
    if (skin.normals.size() > 0) {
        state.skin.normals = std::move(skin.normals);
        state.skin.target_normals = std::move(skin.target_normals);
        state.skin.known = 0;  // until the host sets normals
    }
    if (worn.backstop.size() == 0) {
        state.skin.normals = {};
        state.skin.target_normals = {};
    }
    if (!worn.has_limits()) state.skin = {};
    take_contacts(std::move(made), has_colliders_);
}

}  // namespace weft
