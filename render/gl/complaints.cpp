#include "render/gl/complaints.h"

#include <glad/gl.h>

#include <algorithm>
#include <utility>

namespace weft::render {
namespace {

// Performance messages are skipped: they report no errors (NVIDIA's: a shader was compiled once more).
void GLAD_API_PTR hear(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity, GLsizei /*length*/,
                       const GLchar* message, const void* to) {
    if (type == GL_DEBUG_TYPE_PERFORMANCE) return;
    if (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM) return;
    static_cast<Complaints*>(const_cast<void*>(to))->add(message);
}

}  // namespace

Complaints::Complaints() {
    if (GLAD_GL_KHR_debug == 0) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // messages arrive within the call at fault
    glDebugMessageCallback(hear, this);
}

std::vector<std::string> Complaints::take() {
    return std::exchange(heard_, {});
}

void Complaints::add(const std::string& message) {
    if (std::ranges::find(heard_, message) == heard_.end()) heard_.push_back(message);
}

}  // namespace weft::render
