#include "render/meshes/box_mesh.h"

#include <vector>

namespace weft::render {

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

}  // namespace weft::render
