#include "cloth/world/write_vertices.h"

#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "cloth/mesh/rest/rest_elements.h"
#include "engine/vector.h"

namespace weft {

namespace {

/// Visits the streams with their names and their numbers of floats a vertex.
template <class Visit>
void for_each_stream(const VertexStreams& to, const Visit& visit) {
    visit("positions", to.positions, 3u);
    visit("previous_positions", to.previous_positions, 3u);
    visit("normals", to.normals, 3u);
    visit("previous_normals", to.previous_normals, 3u);
    visit("tangents", to.tangents, 4u);
    visit("texcoords", to.texcoords, 2u);
    visit("strains", to.strains, 2u);
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

/// The normal at a particle, as the view's normals are computed, but from these positions.
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

using Vector3d = Eigen::Vector3d;

/// Directions in which the texture coordinates grow round a vertex, weighted by area, over the particle's
/// triangles that have this vertex. In double precision, since texture coordinates may have any float's size.
struct Growth {
    Vector3d along_u = Vector3d::Zero(), along_v = Vector3d::Zero();
};

/// A side of a triangle from its first corner, in space and in texture coordinates.
struct Side {
    Vector3d way;
    double u, v;
};

Side side_of(const ClothView& view, std::uint32_t triangle, std::size_t corner) noexcept {
    const Triangle &particles = view.triangles[triangle], &vertices = view.vertex_triangles[triangle];
    const Vector3 way = xyz(view.positions[particles[corner]]) - xyz(view.positions[particles[0]]);
    const Vec2 &from = view.texcoords[vertices[0]], &to = view.texcoords[vertices[corner]];
    return {way.cast<double>(), static_cast<double>(to.x) - static_cast<double>(from.x),
            static_cast<double>(to.y) - static_cast<double>(from.y)};
}

/// Says whether the vertex is a corner of the triangle of its particle; true if the mesh does not tell
/// vertices of one particle apart.
bool has_vertex(const ClothView& view, std::uint32_t triangle, std::uint32_t vertex) noexcept {
    if (view.vertex_triangles.empty()) return true;
    const Triangle& vertices = view.vertex_triangles[triangle];
    return vertices[0] == vertex || vertices[1] == vertex || vertices[2] == vertex;
}

Growth growth_at(const ClothView& view, const ClothModel& model, std::uint32_t vertex) noexcept {
    Growth growth;
    for (const std::uint32_t t : triangles_at(model, view.vertex_to_particle[vertex])) {
        if (!has_vertex(view, t, vertex)) continue;
        const Side one = side_of(view, t, 1), two = side_of(view, t, 2);
        const double turn = one.u * two.v - two.u * one.v < 0 ? -1 : 1;
        growth.along_u += turn * (two.v * one.way - one.v * two.way);
        growth.along_v += turn * (one.u * two.way - two.u * one.way);
    }
    return growth;
}

std::array<float, 4> tangent_at(const ClothView& view, const ClothModel& model,
                                std::uint32_t vertex) noexcept {
    const Vector3 normal = xyz(view.normals[view.vertex_to_particle[vertex]]);
    const Vector3d out = normal.cast<double>();
    const Growth growth = growth_at(view, model, vertex);
    const Vector3d level = growth.along_u - growth.along_u.dot(out) * out;
    const double length = level.norm();
    const Vector3 tangent =
        length > 1e-100 ? Vector3((level / length).cast<float>()) : normal.unitOrthogonal();
    const float handedness = out.cross(tangent.cast<double>()).dot(growth.along_v) < 0 ? -1.0f : 1.0f;
    return {tangent.x(), tangent.y(), tangent.z(), handedness};
}

/// The mean strain along warp and weft of a vertex's triangles, by rest areas. A triangle's sides are F times
/// those at rest, and the columns of F are its threads over their lengths at rest.
std::array<float, 2> strain_at(const ClothView& view, const ClothModel& model,
                               std::uint32_t vertex) noexcept {
    Eigen::Vector2f sum = Eigen::Vector2f::Zero();
    float areas = 0;
    for (const std::uint32_t t : triangles_at(model, view.vertex_to_particle[vertex])) {
        if (!has_vertex(view, t, vertex)) continue;
        const auto [to1, to2] = rest_sides(model, t);
        const float turn = to1.x() * to2.y() - to2.x() * to1.y(), area = std::abs(turn);
        if (!(area > 0)) continue;
        const Triangle& corners = view.triangles[t];
        const Vector3 origin = xyz(view.positions[corners[0]]);
        const Vector3 one = xyz(view.positions[corners[1]]) - origin,
                      two = xyz(view.positions[corners[2]]) - origin;
        sum.x() += (to2.y() * one - to1.y() * two).norm() - area;
        sum.y() += (to1.x() * two - to2.x() * one).norm() - area;
        areas += area;
    }
    if (!(areas > 0)) return {};
    return {sum.x() / areas, sum.y() / areas};
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
    each(to.strains, [&](std::uint32_t v, std::uint32_t) { return strain_at(view, model, v); });
}

}  // namespace weft
