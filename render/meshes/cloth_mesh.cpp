#include "render/meshes/cloth_mesh.h"

#include <cassert>
#include <cstddef>

#include "render/gl/programs.h"

namespace weft::render {

namespace {

Box box_of(std::span<const Vec4> points) {
    Box box;
    for (const Vec4& p : points) box.extend(xyz(p));
    return box;
}

}  // namespace

ParticleTexture::ParticleTexture() : texture_(Texture::make()) {
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void ParticleTexture::upload(std::span<const Vec4> particles) {
    const auto count = static_cast<GLsizei>(particles.size());
    const GLsizei full_rows = count / width, rest = count % width;
    const GLsizei height = full_rows + (rest > 0 ? 1 : 0);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    if (height != height_) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
        height_ = height;
    }
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, full_rows, GL_RGBA, GL_FLOAT, particles.data());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, full_rows, rest, rest > 0 ? 1 : 0, GL_RGBA, GL_FLOAT,
                    particles.data() + static_cast<std::ptrdiff_t>(full_rows) * width);
}

void ParticleTexture::bind(int texture_unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(texture_unit));
    glBindTexture(GL_TEXTURE_2D, texture_.id());
}

std::vector<ClothMesh::Vertex> ClothMesh::vertices_of(const ClothSurface& surface) {
    std::vector<Vertex> vertices(surface.vertex_to_particle.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        vertices[i].particle = surface.vertex_to_particle[i];
        if (!surface.texcoords.empty()) vertices[i].texcoord = surface.texcoords[i];
    }
    return vertices;
}

ClothMesh::ClothMesh(const ClothSurface& surface)
    : look(surface.look),
      vertex_array_(VertexArray::make()),
      index_count_(static_cast<GLsizei>(3 * surface.triangles.size())),
      textured_(!surface.texcoords.empty()) {
    assert(surface.texcoords.empty() || surface.texcoords.size() == surface.vertex_to_particle.size());
    glBindVertexArray(vertex_array_.id());
    vertices_ = static_buffer<Vertex>(GL_ARRAY_BUFFER, vertices_of(surface));
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(0, 1, GL_UNSIGNED_INT, sizeof(Vertex),
                           reinterpret_cast<const void*>(offsetof(Vertex, particle)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offsetof(Vertex, texcoord)));
    indices_ = static_buffer(GL_ELEMENT_ARRAY_BUFFER, surface.triangles);
    glBindVertexArray(0);
}

void ClothMesh::stream(const ClothFrame& frame) {
    assert(frame.normals.size() == frame.positions.size());
    assert(frame.previous_positions.size() == frame.positions.size());
    positions_.upload(frame.positions);
    previous_positions_.upload(frame.previous_positions);
    normals_.upload(frame.normals);
    coloured_ = !frame.colours.empty();
    if (coloured_) colours_.upload(frame.colours);
    bounds_ = box_of(frame.positions);
    bounds_.extend(box_of(frame.previous_positions));
}

void ClothMesh::draw(const Program& program, float alpha) const {
    if (bounds_.isEmpty()) return;  // nothing streamed yet
    positions_.bind(unit::positions);
    previous_positions_.bind(unit::previous_positions);
    normals_.bind(unit::normals);
    colours_.bind(unit::colours);
    program.set("coloured", coloured_ ? 1 : 0);
    program.set("alpha", alpha);
    program.set("textured", textured_ ? 1 : 0);
    glBindVertexArray(vertex_array_.id());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace weft::render
