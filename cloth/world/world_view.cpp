// The World's calls that return cloths' vertices, and the air's velocity.

#include <algorithm>
#include <array>
#include <string>

#include "cloth/record/world_calls.h"
#include "cloth/settings/validate.h"
#include "cloth/world/write_vertices.h"

namespace weft {

namespace {

template <class Buffers>
ClothView view_of(const Buffers& buffers, const Bounds& bounds, const ClothModel& model) {
    return {.positions = buffers.positions.span(),
            .previous_positions = buffers.previous_positions.span(),
            .velocities = buffers.velocities.span(),
            .normals = buffers.normals.span(),
            .triangles = model.triangles.span(),
            .vertex_to_particle = model.vertex_to_particle.span(),
            .texcoords = model.texcoords.span(),
            .vertex_triangles = vertex_triangles_of(model),
            .bounds = bounds};
}

ClothView view_of(const Cloth& cloth, bool in_step) {
    if (in_step) return view_of(*cloth.shown, cloth.shown->bounds, cloth.model);
    return view_of(cloth.state, {cloth.extent.lower, cloth.extent.upper}, cloth.model);
}

}  // namespace

Result<const ClothView&> World::cloth(ClothId id) const {
    const Simulation& simulation = impl_->simulation;
    return with_cloth(simulation, id, [&](const Cloth& cloth) -> Result<const ClothView&> {
        if (auto ready = impl_->refuse_beside_step("cloth"); !ready) return ready.error();
        ClothView& view = *simulation.views[id.index];
        view = view_of(cloth, impl_->is_in_step());
        return Result<const ClothView&>(view);
    });
}

Result<void> World::write_vertices(ClothId id, const VertexStreams& to, std::size_t first,
                                   std::size_t count) const {
    return with_cloth(impl_->simulation, id, [&](const Cloth& cloth) -> Result<void> {
        if (auto ready = impl_->refuse_beside_step("write_vertices"); !ready) return ready;
        const ClothView view = view_of(cloth, impl_->is_in_step());
        if (auto valid = check_streams(view, to); !valid) return valid;
        const std::size_t vertices = view.vertex_to_particle.size(), begin = std::min(first, vertices);
        const std::size_t end = begin + std::min(count, vertices - begin);
        weft::write_vertices(view, cloth.model, to, static_cast<std::uint32_t>(begin),
                             static_cast<std::uint32_t>(end));
        return {};
    });
}

Result<void> World::sample_air(std::span<const Vec3> points, std::span<Vec3> velocities) const {
    return impl_->read("sample_air", [&]() -> Result<void> {
        if (velocities.size() != points.size())
            return Error{ErrorCode::invalid_argument, "sample_air: there is room for " +
                                                          std::to_string(velocities.size()) +
                                                          " velocities, of " + std::to_string(points.size()) +
                                                          " points; there must be one of each"};
        const auto lost = std::ranges::find_if_not(points, is_within_reach);
        if (lost != points.end())
            return validate_point(("points[" + std::to_string(lost - points.begin()) + "]").c_str(), *lost);
        Parallel serial(1);
        alignas(64) std::array<Vec4, block_size> at{}, air{};
        for (std::size_t begin = 0; begin < points.size(); begin += block_size) {
            const std::size_t count = std::min<std::size_t>(block_size, points.size() - begin);
            for (std::size_t k = 0; k < count; ++k) at[k] = to_vec4(to_vector(points[begin + k]), 0);
            impl_->simulation.find_air(serial, std::span(at).first(count), std::span(air).first(count));
            for (std::size_t k = 0; k < count; ++k) velocities[begin + k] = {air[k].x, air[k].y, air[k].z};
        }
        return {};
    });
}

}  // namespace weft
