#include <glad/gl.h>
#include <GLFW/glfw3.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/error_text.h"
#include "render/gl/offscreen_egl.h"
#include "weft/render/context.h"

#define GLFW_INCLUDE_NONE

namespace weft::render {

namespace {

/// Collects the debug messages of the current context. This object must outlive the context, whose driver
/// calls it.
class Complaints {
  public:
    /// Collects nothing where the driver lacks the extension. Precondition: the context is current, and its
    /// functions are loaded.
    Complaints();
    Complaints(const Complaints&) = delete;
    Complaints& operator=(const Complaints&) = delete;

    /// The messages since the last call, each once.
    [[nodiscard]] std::vector<std::string> take();
    void add(const std::string& message);

  private:
    std::vector<std::string> heard_;
};

// Performance messages are skipped: they report no errors (NVIDIA's: a shader was compiled once more).
void GLAD_API_PTR hear(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity, GLsizei /*length*/,
                       const GLchar* message, const void* to) {
    if (type == GL_DEBUG_TYPE_PERFORMANCE) return;
    if (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM) return;
    static_cast<Complaints*>(const_cast<void*>(to))->add(message);
}

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

Error glfw_error(const std::string& what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return {ErrorCode::unsupported, what + ": " + (reason != nullptr ? reason : "GLFW gives no reason") +
                                        "; start it where a display is, or use Context::offscreen()"};
}

/// GLFW's windows belong to the main thread, so the count needs no lock.
int open_windows = 0;

class Window {
  public:
    static Result<Window> open(const WindowSettings& settings) {
        if (glfwInit() != GLFW_TRUE) return glfw_error("no window system");
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, settings.checked ? GLFW_TRUE : GLFW_FALSE);
        // Multisampling and depth live in the renderer's own framebuffer; the window only receives the
        // picture.
        glfwWindowHint(GLFW_SAMPLES, 0);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        GLFWwindow* handle =
            glfwCreateWindow(settings.width, settings.height, settings.title.c_str(), nullptr, nullptr);
        if (handle == nullptr) {
            Error error = glfw_error("no window with OpenGL 3.3 core");
            if (open_windows == 0) glfwTerminate();
            return error;
        }
        ++open_windows;
        glfwMakeContextCurrent(handle);
        glfwSwapInterval(settings.vsync ? 1 : 0);
        return Window(handle);
    }

    Window(Window&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Window& operator=(Window&& other) = delete;
    ~Window() {
        if (handle_ == nullptr) return;
        glfwDestroyWindow(handle_);
        if (--open_windows == 0) glfwTerminate();
    }

    [[nodiscard]] GLFWwindow* handle() const noexcept { return handle_; }

  private:
    explicit Window(GLFWwindow* handle) : handle_(handle) {}
    GLFWwindow* handle_;
};

Result<void> load_functions(GLADloadfunc load) {
    const int version = gladLoadGL(load);
    if (version >= GLAD_MAKE_VERSION(3, 3)) return {};
    return Error{ErrorCode::unsupported,
                 "the driver gives OpenGL " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                     std::to_string(GLAD_VERSION_MINOR(version)) + "; 3.3 or later is needed"};
}

}  // namespace

struct Context::Impl {
    std::optional<Complaints> complaints;  // destroyed last: the driver calls it while its context lasts
    std::optional<Window> window;
    std::optional<OffscreenEgl> offscreen;
};

Context::Context(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

Result<Context> Context::window(const WindowSettings& settings) {
    if (settings.width <= 0) return out_of_range("WindowSettings::width", settings.width, "> 0 pixels");
    if (settings.height <= 0) return out_of_range("WindowSettings::height", settings.height, "> 0 pixels");
    auto window = Window::open(settings);
    if (!window) return window.error();
    if (auto loaded = load_functions(glfwGetProcAddress); !loaded) return loaded.error();
    auto impl = std::make_unique<Impl>();
    impl->window.emplace(std::move(*window));
    if (settings.checked) impl->complaints.emplace();
    return Context(std::move(impl));
}

Result<Context> Context::offscreen(bool checked) {
    auto egl = OffscreenEgl::create(checked);
    if (!egl) return egl.error();
    if (auto loaded = load_functions(OffscreenEgl::function); !loaded) return loaded.error();
    auto impl = std::make_unique<Impl>();
    impl->offscreen.emplace(std::move(*egl));
    if (checked) impl->complaints.emplace();
    return Context(std::move(impl));
}

GLFWwindow* Context::window_handle() const noexcept {
    return impl_->window ? impl_->window->handle() : nullptr;
}

std::vector<std::string> Context::take_complaints() {
    return impl_->complaints ? impl_->complaints->take() : std::vector<std::string>();
}

std::string Context::renderer() const {
    const auto text = [](GLenum name) {
        return std::string(reinterpret_cast<const char*>(glGetString(name)));
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace weft::render
