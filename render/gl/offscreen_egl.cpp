#include "render/gl/offscreen_egl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace weft::render {

namespace {

struct Platform {
    std::string name;
    EGLDisplay display;
};

/// True if `list`, names separated by blanks or null, holds `name`.
bool has_extension(const char* list, std::string_view name) {
    std::istringstream words(list != nullptr ? list : "");
    return std::find(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>(), name) !=
           std::istream_iterator<std::string>();
}

template <class Pointer>
Pointer extension_function(const char* name) {
    return reinterpret_cast<Pointer>(eglGetProcAddress(name));
}

/// Appends one display for each graphics card that EGL lists.
void append_cards(std::vector<Platform>& platforms) {
    const auto query = extension_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto describe = extension_function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    const auto open = extension_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (query == nullptr || describe == nullptr || open == nullptr) return;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (has_extension(describe(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) continue;
        platforms.push_back(
            {"card " + std::to_string(i), open(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr)});
    }
}

/// EGL's platforms in order of preference. Cards come first, since Mesa's surfaceless platform draws on the
/// processor where the card's driver is not Mesa's.
std::vector<Platform> platforms() {
    std::vector<Platform> found;
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (has_extension(extensions, "EGL_EXT_platform_device")) append_cards(found);
    const auto open = extension_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (open != nullptr && has_extension(extensions, "EGL_MESA_platform_surfaceless"))
        found.push_back({"surfaceless", open(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
    found.push_back({"default", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
    return found;
}

/// A context on `display`, or EGL_NO_CONTEXT with `reason` filled.
EGLContext make_context(EGLDisplay display, bool checked, std::string& reason) {
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || eglInitialize(display, &major, &minor) != EGL_TRUE) {
        reason = "no display";
        return EGL_NO_CONTEXT;
    }
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!has_extension(extensions, "EGL_KHR_surfaceless_context")) {
        reason = "no EGL_KHR_surfaceless_context";
        return EGL_NO_CONTEXT;
    }
    constexpr std::array wanted = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint config_count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &config_count) != EGL_TRUE || config_count == 0) {
        reason = "no configuration that draws OpenGL";
        return EGL_NO_CONTEXT;
    }
    std::vector<EGLint> version = {EGL_CONTEXT_MAJOR_VERSION,       3,
                                   EGL_CONTEXT_MINOR_VERSION,       3,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
    const bool can_check = major > 1 || minor >= 5;
    if (checked && can_check) version.insert(version.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
    version.push_back(EGL_NONE);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
    if (context == EGL_NO_CONTEXT) {
        reason = "no OpenGL 3.3 core context";
        return EGL_NO_CONTEXT;
    }
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
        eglDestroyContext(display, context);
        reason = "the context cannot be made current";
        return EGL_NO_CONTEXT;
    }
    return context;
}

}  // namespace

Result<OffscreenEgl> OffscreenEgl::create(bool checked) {
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE)
        return Error{ErrorCode::unsupported,
                     "EGL offers no OpenGL; install a driver (Debian: libegl1, libgl1-mesa-dri)"};
    std::string answers;
    for (const Platform& platform : platforms()) {
        std::string reason;
        const EGLContext context = make_context(platform.display, checked, reason);
        if (context != EGL_NO_CONTEXT) return OffscreenEgl(platform.display, context);
        answers.append(platform.name).append(": ").append(reason).append("; ");
    }
    return Error{ErrorCode::unsupported, "EGL gives no OpenGL 3.3 core without a display: " + answers +
                                             "install a driver (Debian: libgl1-mesa-dri) or run under Xvfb"};
}

OffscreenEgl::OffscreenEgl(OffscreenEgl&& other) noexcept
    : display_(other.display_), context_(std::exchange(other.context_, nullptr)) {}

OffscreenEgl& OffscreenEgl::operator=(OffscreenEgl&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    return *this;
}

// The display stays initialised: it is one for the whole process, and terminating it would pull it from under
// other contexts.
OffscreenEgl::~OffscreenEgl() {
    if (context_ == nullptr) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

OffscreenEgl::Function OffscreenEgl::function(const char* name) {
    return eglGetProcAddress(name);
}

}  // namespace weft::render
