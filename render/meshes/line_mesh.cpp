#include "render/meshes/line_mesh.h"

namespace weft::render {

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
