#include "render/gl/gl.h"

#include <string>

namespace weft::render {

namespace {

class Shader {
  public:
    explicit Shader(GLenum stage) : id_(glCreateShader(stage)) {}
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    ~Shader() { glDeleteShader(id_); }
    [[nodiscard]] GLuint id() const noexcept { return id_; }

    [[nodiscard]] bool compile(std::span<const char* const> texts) {
        glShaderSource(id_, static_cast<GLsizei>(texts.size()), texts.data(), nullptr);
        glCompileShader(id_);
        GLint compiled = GL_FALSE;
        glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
        return compiled == GL_TRUE;
    }
    [[nodiscard]] std::string log() const {
        GLint length = 0;
        glGetShaderiv(id_, GL_INFO_LOG_LENGTH, &length);
        std::string text(static_cast<std::size_t>(length), '\0');
        if (length > 0) glGetShaderInfoLog(id_, length, nullptr, text.data());
        return text;
    }

  private:
    GLuint id_;
};

std::string link_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length), '\0');
    if (length > 0) glGetProgramInfoLog(program, length, nullptr, text.data());
    return text;
}

Error shader_error(std::string_view name, const char* part, const std::string& log) {
    return {ErrorCode::unsupported, "shader program '" + std::string(name) + "': the " + part +
                                        " is refused by this OpenGL driver: " + log};
}

}  // namespace

Result<Program> Program::link(std::string_view name, std::span<const char* const> vertex,
                              std::span<const char* const> fragment) {
    Shader vertex_shader(GL_VERTEX_SHADER);
    if (!vertex_shader.compile(vertex)) return shader_error(name, "vertex shader", vertex_shader.log());
    Shader fragment_shader(GL_FRAGMENT_SHADER);
    if (!fragment_shader.compile(fragment))
        return shader_error(name, "fragment shader", fragment_shader.log());

    Program result;
    result.program_ = Handle<ProgramKind>::make();
    const GLuint id = result.program_.id();
    glAttachShader(id, vertex_shader.id());
    glAttachShader(id, fragment_shader.id());
    glLinkProgram(id);
    glDetachShader(id, vertex_shader.id());
    glDetachShader(id, fragment_shader.id());
    GLint linked = GL_FALSE;
    glGetProgramiv(id, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) return shader_error(name, "link", link_log(id));
    return result;
}

void Program::use() const {
    glUseProgram(program_.id());
}

void Program::set(const char* uniform, int value) const {
    glUniform1i(glGetUniformLocation(program_.id(), uniform), value);
}
void Program::set(const char* uniform, float value) const {
    glUniform1f(glGetUniformLocation(program_.id(), uniform), value);
}
void Program::set(const char* uniform, const Vec2& value) const {
    glUniform2f(glGetUniformLocation(program_.id(), uniform), value.x, value.y);
}
void Program::set(const char* uniform, const Vec3& value) const {
    glUniform3f(glGetUniformLocation(program_.id(), uniform), value.x, value.y, value.z);
}
void Program::set(const char* uniform, const Vec4& value) const {
    glUniform4f(glGetUniformLocation(program_.id(), uniform), value.x, value.y, value.z, value.w);
}
void Program::set(const char* uniform, const Matrix4& value) const {
    glUniformMatrix4fv(glGetUniformLocation(program_.id(), uniform), 1, GL_FALSE, value.data());
}

void Program::bind_block(const char* block, GLuint binding) const {
    const GLuint index = glGetUniformBlockIndex(program_.id(), block);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(program_.id(), index, binding);
}

}  // namespace weft::render
