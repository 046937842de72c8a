#include "render/meshes/solid_meshes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace weft::render {

namespace {

constexpr std::uint32_t sectors = 64;        // around the axis
constexpr std::uint32_t rings_per_end = 17;  // from the pole to the equator, both included

using Triangle = std::array<std::uint32_t, 3>;

/// xyz: the unit normal, axis along +Y; w: 0 at the first end, 1 at the second.
std::vector<Vec4> capsule_vertices() {
    std::vector<Vec4> vertices;
    for (std::uint32_t ring = 0; ring < 2 * rings_per_end; ++ring) {
        const bool second = ring >= rings_per_end;
        const auto step = static_cast<float>(second ? ring - 1 : ring);  // each end has its own equator ring
        const float latitude = std::numbers::pi_v<float> * (step / (2.0f * (rings_per_end - 1)) - 0.5f);
        for (std::uint32_t sector = 0; sector <= sectors; ++sector) {
            const float longitude = 2.0f * std::numbers::pi_v<float> * static_cast<float>(sector) / sectors;
            const float across = std::cos(latitude);
            vertices.push_back({across * std::sin(longitude), std::sin(latitude),
                                across * std::cos(longitude), second ? 1.0f : 0.0f});
        }
    }
    return vertices;
}

std::vector<Triangle> capsule_triangles() {
    std::vector<Triangle> triangles;
    for (std::uint32_t ring = 0; ring + 1 < 2 * rings_per_end; ++ring) {
        for (std::uint32_t sector = 0; sector < sectors; ++sector) {
            const std::uint32_t low = ring * (sectors + 1) + sector, high = low + sectors + 1;
            triangles.push_back({low, low + 1, high + 1});
            triangles.push_back({low, high + 1, high});
        }
    }
    return triangles;
}

}  // namespace

CapsuleMesh::CapsuleMesh() : vertex_array_(VertexArray::make()) {
    const std::vector<Triangle> triangles = capsule_triangles();
    glBindVertexArray(vertex_array_.id());
    vertices_ = static_buffer<Vec4>(GL_ARRAY_BUFFER, capsule_vertices());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Vec4), nullptr);
    indices_ = static_buffer<Triangle>(GL_ELEMENT_ARRAY_BUFFER, triangles);
    index_count_ = static_cast<GLsizei>(3 * triangles.size());
    glBindVertexArray(0);
}

void CapsuleMesh::draw(const Program& program, const DrawnTaperedCapsule& capsule) const {
    program.set("end_a", capsule.a);
    program.set("end_b", capsule.b);
    program.set("radius_a", capsule.radius_a);
    program.set("radius_b", capsule.radius_b);
    program.set("color", capsule.color);
    glBindVertexArray(vertex_array_.id());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

DrawnTaperedCapsule as_tapered(const DrawnSphere& sphere) {
    return {sphere.center, sphere.center, sphere.radius, sphere.radius, sphere.color};
}

DrawnTaperedCapsule as_tapered(const DrawnCapsule& capsule) {
    return {capsule.a, capsule.b, capsule.radius, capsule.radius, capsule.color};
}

Box bounds_of(const DrawnTaperedCapsule& capsule) {
    const Vector3 a = Vector3::Constant(capsule.radius_a), b = Vector3::Constant(capsule.radius_b);
    Box box(to_vector(capsule.a) - a, to_vector(capsule.a) + a);
    box.extend(Box(to_vector(capsule.b) - b, to_vector(capsule.b) + b));
    return box;
}

namespace {

constexpr GLsizei vertex_count = 36;

struct BoxVertex {
    Vec4 normal;  // w: 2 marks a box for solid.vert
    Vec4 corner;
};

/// Two triangles per face, counter-clockwise seen from outside.
std::vector<BoxVertex> box_vertices() {
    std::vector<BoxVertex> vertices;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const float side = face % 2 == 0 ? -1.0f : 1.0f;
        const Vector3 normal = side * Vector3::Unit(axis);
        const Vector3 u = Vector3::Unit((axis + 1) % 3), v = normal.cross(u);
        for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
            const Vector3 corner = normal + static_cast<float>(a) * u + static_cast<float>(b) * v;
            vertices.push_back({to_vec4(normal, 2), to_vec4(corner, 0)});
        }
    }
    return vertices;
}

}  // namespace

BoxMesh::BoxMesh() : vertex_array_(VertexArray::make()) {
    glBindVertexArray(vertex_array_.id());
    vertices_ = static_buffer<BoxVertex>(GL_ARRAY_BUFFER, box_vertices());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(BoxVertex), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(BoxVertex),
                          reinterpret_cast<const void*>(sizeof(Vec4)));
    glBindVertexArray(0);
}

void BoxMesh::draw(const Program& program, const DrawnBox& box) const {
    program.set("end_a", box.center);
    program.set("box_x", box.x);
    program.set("box_y", box.y);
    program.set("box_z", box.z);
    program.set("color", box.color);
    glBindVertexArray(vertex_array_.id());
    glDrawArrays(GL_TRIANGLES, 0, vertex_count);
}

Box bounds_of(const DrawnBox& box) {
    const Vector3 half =
        to_vector(box.x).cwiseAbs() + to_vector(box.y).cwiseAbs() + to_vector(box.z).cwiseAbs();
    return {to_vector(box.center) - half, to_vector(box.center) + half};
}

LineMesh::LineMesh() {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(sizeof(Vec3)));
    glBindVertexArray(0);
}

void LineMesh::draw(std::span<const DrawnLine> lines) {
    streamed_.clear();
    const auto stream = [&](bool solid) {
        for (const DrawnLine& line : lines) {
            if ((line.opacity >= 1) != solid) continue;
            streamed_.push_back({line.from, line.color, line.opacity});
            streamed_.push_back({line.to, line.color, line.opacity});
        }
        return static_cast<GLsizei>(streamed_.size());
    };
    const GLsizei solid = stream(true), all = stream(false);
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(streamed_.size() * sizeof(Vertex)),
                 streamed_.data(), GL_STREAM_DRAW);
    glDrawArrays(GL_LINES, 0, solid);
    if (all == solid) return;
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);  // transparent lines hide nothing
    glDrawArrays(GL_LINES, solid, all - solid);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace weft::render
