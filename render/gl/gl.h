#pragma once
// OpenGL objects that delete themselves, and shader programs.

#include <glad/gl.h>

#include <span>
#include <string_view>
#include <utility>

#include "weft/error.h"
#include "weft/render/camera.h"
#include "weft/types.h"

namespace weft::render {

/// Owns one OpenGL name. Default-constructed it owns none.
template <class Kind>
class Handle {
  public:
    Handle() = default;
    [[nodiscard]] static Handle make() {
        Handle handle;
        handle.id_ = Kind::make();
        return handle;
    }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Handle() {
        if (id_ != 0) Kind::release(id_);
    }

    [[nodiscard]] GLuint id() const noexcept { return id_; }

  private:
    GLuint id_ = 0;
};

/// Names that OpenGL makes and deletes in arrays. glad's functions are pointers that are filled at run time,
/// so the template arguments are their addresses.
template <auto* generate, auto* destroy>
struct ArrayKind {
    static GLuint make() {
        GLuint id = 0;
        (*generate)(1, &id);
        return id;
    }
    static void release(GLuint id) { (*destroy)(1, &id); }
};
struct ProgramKind {
    static GLuint make() { return glCreateProgram(); }
    static void release(GLuint id) { glDeleteProgram(id); }
};

using Buffer = Handle<ArrayKind<&glGenBuffers, &glDeleteBuffers>>;
using Texture = Handle<ArrayKind<&glGenTextures, &glDeleteTextures>>;
using Sampler = Handle<ArrayKind<&glGenSamplers, &glDeleteSamplers>>;
using VertexArray = Handle<ArrayKind<&glGenVertexArrays, &glDeleteVertexArrays>>;
using Query = Handle<ArrayKind<&glGenQueries, &glDeleteQueries>>;
using Framebuffer = Handle<ArrayKind<&glGenFramebuffers, &glDeleteFramebuffers>>;
using Renderbuffer = Handle<ArrayKind<&glGenRenderbuffers, &glDeleteRenderbuffers>>;

/// A linked vertex and fragment shader. Precondition of set(): the program is in use.
class Program {
  public:
    Program() = default;
    /// Each stage is the concatenation of its texts. Error: the compiler's or linker's log, headed by `name`.
    [[nodiscard]] static Result<Program> link(std::string_view name, std::span<const char* const> vertex,
                                              std::span<const char* const> fragment);

    void use() const;
    // A uniform that the program does not have, or that its compiler found unused, is skipped.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const Vec2& value) const;
    void set(const char* uniform, const Vec3& value) const;
    void set(const char* uniform, const Vec4& value) const;
    void set(const char* uniform, const Matrix4& value) const;
    void bind_block(const char* block, GLuint binding) const;

  private:
    Handle<ProgramKind> program_;
};

/// Uploads `content` once, for many draws (GL_STATIC_DRAW).
template <class T>
[[nodiscard]] Buffer static_buffer(GLenum target, std::span<const T> content) {
    Buffer buffer = Buffer::make();
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(content.size_bytes()), content.data(), GL_STATIC_DRAW);
    return buffer;
}

}  // namespace weft::render
