#pragma once
// How many objects OpenGL has, by asking for names one after another.

#include <glad/gl.h>

#include <array>

namespace weft::render {

/// Buffers, textures, samplers, vertex arrays, queries, framebuffers, renderbuffers, programs, shaders.
/// Precondition: a context is current.
inline std::array<int, 9> count_gl_objects() {
    std::array<int, 9> counts{};
    for (GLuint name = 1; name < 3000; ++name) {
        const std::array<GLboolean, 9> is{glIsBuffer(name),       glIsTexture(name), glIsSampler(name),
                                          glIsVertexArray(name),  glIsQuery(name),   glIsFramebuffer(name),
                                          glIsRenderbuffer(name), glIsProgram(name), glIsShader(name)};
        for (std::size_t k = 0; k < is.size(); ++k) counts[k] += is[k] == GL_TRUE ? 1 : 0;
    }
    return counts;
}

}  // namespace weft::render
