#include "cloth/frame/view/write_vertices.h"

#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "engine/vector.h"

namespace weft {

namespace {

/// Kinds, with how many floats each has.
template <class Visit>
void for_each_stream(const VertexStreams& to, const Visit& visit) {
    visit("positions", to.positions, 3u);
    visit("previous_positions", to.previous_positions, 3u);
    visit("normals", to.normals, 3u);
    visit("previous_normals", to.previous_normals, 3u);
    visit("tangents", to.tangents, 4u);
    visit("texcoords", to.texcoords, 2u);
}

template <std::size_t N>
void put(const VertexStream& to, std::size_t vertex, const std::array<float, N>& value) noexcept {
    const std::size_t stride = to.stride == 0 ? sizeof value : to.stride;
    std::memcpy(to.bytes.data() + vertex * stride, value.data(), sizeof value);
}

void put(const VertexStream& to, std::size_t vertex, const Vector3& value) noexcept {
    put(to, vertex, std::array{value.x(), value.y(), value.z()});
}

Vector3 unit_or_other(const Vector3& v, const Vector3& otherwise) noexcept {
    const float squared = v.squaredNorm();
    return squared > 1e-36f ? Vector3(v / std::sqrt(squared)) : otherwise;
}

/// Triangles round a particle.
std::span<const std::uint32_t> triangles_at(const ClothModel& model, std::uint32_t particle) noexcept {
    const std::uint32_t begin = model.corner_offsets[particle];
    return model.corner_triangles.span().subspan(begin, model.corner_offsets[particle + 1] - begin);
}

/// As the view's normals are made, of other positions.
Vector3 normal_at(const ClothModel& model, std::span<const Vec4> positions, std::uint32_t particle) noexcept {
    Vector3 sum = Vector3::Zero();
    for (const std::uint32_t t : triangles_at(model, particle)) {
        const Triangle& corners = model.triangles[t];
        const Vector3 origin = xyz(positions[corners[0]]);
        const Vector3 one = xyz(positions[corners[1]]) - origin, two = xyz(positions[corners[2]]) - origin;
        sum += one.cross(two);
    }
    return unit_or_other(sum, Vector3::UnitY());
}

/// Ways along which the texture coordinates grow round a vertex, by area: those of triangles at a particle
/// that know it by this vertex.
struct Growth {
    Vector3 along_u = Vector3::Zero(), along_v = Vector3::Zero();
};

Growth growth_at(const ClothView& view, const ClothModel& model, std::uint32_t vertex) noexcept {
    Growth growth;
    for (const std::uint32_t t : triangles_at(model, view.vertex_to_particle[vertex])) {
        const Triangle& vertices = view.vertex_triangles[t];
        if (vertices[0] != vertex && vertices[1] != vertex && vertices[2] != vertex) continue;
        const Triangle& corners = view.triangles[t];
        const Vector3 origin = xyz(view.positions[corners[0]]);
        const Vector3 one = xyz(view.positions[corners[1]]) - origin,
                      two = xyz(view.positions[corners[2]]) - origin;
        const Vec2 &o = view.texcoords[vertices[0]], &p = view.texcoords[vertices[1]],
                   &q = view.texcoords[vertices[2]];
        const float u1 = p.x - o.x, v1 = p.y - o.y, u2 = q.x - o.x, v2 = q.y - o.y;
        const float turn = u1 * v2 - u2 * v1 < 0 ? -1.0f : 1.0f;
        growth.along_u += turn * (v2 * one - v1 * two);
        growth.along_v += turn * (u1 * two - u2 * one);
    }
    return growth;
}

std::array<float, 4> tangent_at(const ClothView& view, const ClothModel& model,
                                std::uint32_t vertex) noexcept {
    const Vector3 normal = xyz(view.normals[view.vertex_to_particle[vertex]]);
    const Growth growth = growth_at(view, model, vertex);
    const Vector3 level = growth.along_u - growth.along_u.dot(normal) * normal;
    const Vector3 tangent = unit_or_other(level, normal.unitOrthogonal());
    const float handedness = normal.cross(tangent).dot(growth.along_v) < 0 ? -1.0f : 1.0f;
    return {tangent.x(), tangent.y(), tangent.z(), handedness};
}

}  // namespace

std::span<const Triangle> vertex_triangles_of(const ClothModel& model) {
    const bool are_the_same = model.rows > 0 || !model.texcoords.empty();
    return model.vertex_triangles.empty() && are_the_same ? model.triangles.span()
                                                          : model.vertex_triangles.span();
}

Result<void> check_streams(const ClothView& view, const VertexStreams& to) {
    const std::size_t vertices = view.vertex_to_particle.size();
    Result<void> valid;
    for_each_stream(to, [&](const char* name, const VertexStream& stream, std::size_t floats) {
        const std::size_t size = floats * sizeof(float);
        const std::size_t stride = stream.stride == 0 ? size : stream.stride;
        if (!valid || stream.bytes.empty()) return;
        if (stride < size) {
            valid = Error{ErrorCode::invalid_argument, "VertexStreams::" + std::string(name) +
                                                           " has a stride of " + std::to_string(stride) +
                                                           " bytes; a value takes " + std::to_string(size)};
        } else if (stream.bytes.size() < size || (stream.bytes.size() - size) / stride + 1 < vertices) {
            valid = Error{ErrorCode::invalid_argument, "VertexStreams::" + std::string(name) + " has " +
                                                           std::to_string(stream.bytes.size()) + " bytes; " +
                                                           std::to_string(vertices) + " vertices take " +
                                                           std::to_string((vertices - 1) * stride + size)};
        }
    });
    if (!valid || !view.texcoords.empty()) return valid;
    if (!to.tangents.bytes.empty() || !to.texcoords.bytes.empty())
        return Error{ErrorCode::invalid_argument,
                     "the cloth has no texture coordinates, so no tangents; give it a mesh with "
                     "Mesh::texcoords"};
    return valid;
}

void write_vertices(const ClothView& view, const ClothModel& model, const VertexStreams& to,
                    std::uint32_t first, std::uint32_t last) noexcept {
    const auto each = [&](const VertexStream& stream, const auto& value_of) {
        if (stream.bytes.empty()) return;
        for (std::uint32_t v = first; v < last; ++v) put(stream, v, value_of(v, view.vertex_to_particle[v]));
    };
    const auto each_of = [&](const VertexStream& stream, std::span<const Vec4> values) {
        each(stream, [&](std::uint32_t, std::uint32_t particle) { return Vector3(xyz(values[particle])); });
    };
    each_of(to.positions, view.positions);
    each_of(to.previous_positions, view.previous_positions);
    each_of(to.normals, view.normals);
    each(to.previous_normals, [&](std::uint32_t, std::uint32_t particle) {
        return normal_at(model, view.previous_positions, particle);
    });
    each(to.tangents, [&](std::uint32_t v, std::uint32_t) { return tangent_at(view, model, v); });
    each(to.texcoords, [&](std::uint32_t v, std::uint32_t) {
        return std::array{view.texcoords[v].x, view.texcoords[v].y};
    });
}

}  // namespace weft
