#include "render/meshes/cloth_mesh.h"

#include <algorithm>
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

/// A picture that repeats, in sRGB, with levels for cloth far away.
Texture texture_of(const Image& image) {
    assert(image.rgb.size() ==
           3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    Texture texture = Texture::make();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 image.rgb.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
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
    : look(surface.look), vertex_array_(VertexArray::make()), textured_(!surface.texcoords.empty()) {
    assert(surface.texcoords.empty() || surface.texcoords.size() == surface.vertex_to_particle.size());
    glBindVertexArray(vertex_array_.id());
    vertices_ = static_buffer<Vertex>(GL_ARRAY_BUFFER, vertices_of(surface));
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(0, 1, GL_UNSIGNED_INT, sizeof(Vertex),
                           reinterpret_cast<const void*>(offsetof(Vertex, particle)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offsetof(Vertex, texcoord)));
    const std::vector<std::array<std::uint32_t, 3>> triangles = take_parts(surface);
    index_count_ = static_cast<GLsizei>(3 * triangles.size());
    indices_ = static_buffer<std::array<std::uint32_t, 3>>(GL_ELEMENT_ARRAY_BUFFER, triangles);
    glBindVertexArray(0);
}

std::vector<std::array<std::uint32_t, 3>> ClothMesh::take_parts(const ClothSurface& surface) {
    std::vector<std::array<std::uint32_t, 3>> sorted(surface.triangles.begin(), surface.triangles.end());
    if (surface.parts.empty() || surface.part_of_triangle.size() != sorted.size()) return sorted;
    sorted.clear();
    std::vector<const Image*> known;
    for (std::size_t k = 0; k < surface.parts.size(); ++k) {
        const ClothPart& from = surface.parts[k];
        Part part{.first = static_cast<GLsizei>(3 * sorted.size()), .front = from.front, .back = from.back};
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            if (surface.part_of_triangle[t] == k) sorted.push_back(surface.triangles[t]);
        part.count = static_cast<GLsizei>(3 * sorted.size()) - part.first;
        if (part.count == 0) continue;
        const Image* const image = textured_ ? from.picture.get() : nullptr;
        if (image != nullptr) {
            const auto found = std::ranges::find(known, image);
            part.picture = static_cast<std::size_t>(found - known.begin()) + 1;
            if (found == known.end()) {
                known.push_back(image);
                pictures_.push_back(texture_of(*image));
            }
        }
        parts_.push_back(part);
    }
    return sorted;
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

bool ClothMesh::bind(const Program& program, float alpha) const {
    if (bounds_.isEmpty()) return false;  // nothing streamed yet
    positions_.bind(unit::positions);
    previous_positions_.bind(unit::previous_positions);
    normals_.bind(unit::normals);
    colours_.bind(unit::colours);
    program.set("coloured", coloured_ ? 1 : 0);
    program.set("alpha", alpha);
    program.set("textured", textured_ ? 1 : 0);
    glBindVertexArray(vertex_array_.id());
    return true;
}

void ClothMesh::draw(const Program& program, float alpha) const {
    if (bind(program, alpha)) glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void ClothMesh::draw_shaded(const Program& program, float alpha) const {
    program.set("printed", 0);
    if (parts_.empty()) return draw(program, alpha);
    if (!bind(program, alpha)) return;
    for (const Part& part : parts_) {
        program.set("front", part.front);
        program.set("back", part.back);
        program.set("printed", part.picture > 0 ? 1 : 0);
        if (part.picture > 0) {
            glActiveTexture(GL_TEXTURE0 + unit::print);
            glBindTexture(GL_TEXTURE_2D, pictures_[part.picture - 1].id());
        }
        glDrawElements(
            GL_TRIANGLES, part.count, GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(sizeof(std::uint32_t) * static_cast<std::size_t>(part.first)));
    }
}

}  // namespace weft::render
