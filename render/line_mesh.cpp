#include "render/line_mesh.h"

namespace weft::render {

LineMesh::LineMesh() {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(sizeof(Vec3)));
    glBindVertexArray(0);
}

void LineMesh::draw(std::span<const DrawnLine> lines) {
    streamed_.clear();
    for (const DrawnLine& line : lines) {
        streamed_.push_back({line.from, line.color});
        streamed_.push_back({line.to, line.color});
    }
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(streamed_.size() * sizeof(Vertex)),
                 streamed_.data(), GL_STREAM_DRAW);
    glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(streamed_.size()));
}

}  // namespace weft::render
