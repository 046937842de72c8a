#include "weft/render/imgui_layer.h"

#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "render/gl/gl_state.h"

namespace weft::render {

namespace {

// Fonts that read better than Dear ImGui's built-in bitmap, where Debian and others keep them.
constexpr const char* fonts[] = {
    "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
};

void load_font(float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    std::error_code missing;
    for (const char* font : fonts) {
        if (!std::filesystem::exists(font, missing)) continue;
        if (atlas.AddFontFromFileTTF(font, 15.0f * scale) != nullptr) return;
    }
    ImFontConfig config;
    config.SizePixels = 13.0f * scale;
    atlas.AddFontDefault(&config);
}

ImVec4 gray(float light, float opacity) {
    return {light * 0.94f, light * 0.97f, light * 1.05f, opacity};
}
ImVec4 accent(float opacity) {
    return {0.30f, 0.62f, 0.86f, opacity};
}

/// Sets dark, slightly transparent panels, and one blue for active and chosen widgets.
void set_style(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    ImGui::StyleColorsDark(&style);
    style.WindowRounding = 8;
    style.ChildRounding = style.FrameRounding = style.PopupRounding = 5;
    style.GrabRounding = style.ScrollbarRounding = style.TabRounding = 5;
    style.WindowBorderSize = style.FrameBorderSize = 0;
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.GrabMinSize = 10;
    style.WindowTitleAlign = {0.5f, 0.5f};

    ImVec4* colors = style.Colors;
    colors[ImGuiCol_Text] = gray(0.93f, 1);
    colors[ImGuiCol_TextDisabled] = gray(0.55f, 1);
    colors[ImGuiCol_WindowBg] = gray(0.085f, 0.86f);
    colors[ImGuiCol_PopupBg] = gray(0.10f, 1.0f);
    colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgCollapsed] = gray(0.06f, 0.90f);
    colors[ImGuiCol_TitleBgActive] = gray(0.12f, 0.94f);
    colors[ImGuiCol_FrameBg] = gray(0.20f, 0.75f);
    colors[ImGuiCol_FrameBgHovered] = gray(0.28f, 0.85f);
    colors[ImGuiCol_FrameBgActive] = gray(0.32f, 0.95f);
    colors[ImGuiCol_Button] = gray(0.24f, 0.85f);
    colors[ImGuiCol_ButtonHovered] = accent(0.55f);
    colors[ImGuiCol_ButtonActive] = accent(0.85f);
    colors[ImGuiCol_Header] = accent(0.22f);
    colors[ImGuiCol_HeaderHovered] = accent(0.40f);
    colors[ImGuiCol_HeaderActive] = accent(0.60f);
    colors[ImGuiCol_SliderGrab] = accent(0.50f);
    colors[ImGuiCol_SliderGrabActive] = colors[ImGuiCol_CheckMark] = accent(1);
    colors[ImGuiCol_Separator] = gray(0.45f, 0.25f);
    colors[ImGuiCol_PlotLines] = colors[ImGuiCol_PlotHistogram] = accent(0.90f);
    style.ScaleAllSizes(scale);
}

float content_scale(GLFWwindow* window) {
    float across = 1, along = 1;
    if (window != nullptr) glfwGetWindowContentScale(window, &across, &along);
    return std::clamp(across, 1.0f, 4.0f);
}

/// Makes a Dear ImGui context current; the destructor restores the host's.
class CurrentContext {
  public:
    explicit CurrentContext(ImGuiContext* context) : host_(ImGui::GetCurrentContext()) {
        ImGui::SetCurrentContext(context);
    }
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;
    ~CurrentContext() { ImGui::SetCurrentContext(host_); }

  private:
    ImGuiContext* host_;
};

/// Creates a context and leaves the current one current.
ImGuiContext* make_context() {
    const CurrentContext host(ImGui::GetCurrentContext());
    return ImGui::CreateContext();
}

/// A window's callbacks. The layer's callbacks pass each event on to the host's, in the host's own context.
struct Callbacks {
    GLFWwindowfocusfun focus = nullptr;
    GLFWcursorenterfun enter = nullptr;
    GLFWcursorposfun position = nullptr;
    GLFWmousebuttonfun button = nullptr;
    GLFWscrollfun scroll = nullptr;
    GLFWkeyfun key = nullptr;
    GLFWcharfun character = nullptr;

    /// Sets these callbacks and returns the previous ones.
    [[nodiscard]] Callbacks exchange(GLFWwindow* window) const {
        return {glfwSetWindowFocusCallback(window, focus),  glfwSetCursorEnterCallback(window, enter),
                glfwSetCursorPosCallback(window, position), glfwSetMouseButtonCallback(window, button),
                glfwSetScrollCallback(window, scroll),      glfwSetKeyCallback(window, key),
                glfwSetCharCallback(window, character)};
    }
};

/// The layer that receives its window's events. GLFW delivers events on the main thread alone.
struct Listener {
    ImGuiContext* context = nullptr;
    Callbacks host;

    template <class... Values>
    void pass(void (*to_layer)(GLFWwindow*, Values...), void (*to_host)(GLFWwindow*, Values...),
              GLFWwindow* window, Values... values) const {
        {
            const CurrentContext current(context);
            to_layer(window, values...);
        }
        if (to_host != nullptr) to_host(window, values...);
    }
};
Listener listener;

Callbacks layer_callbacks() {
    Callbacks own;
    own.focus = [](GLFWwindow* w, int focused) {
        listener.pass(ImGui_ImplGlfw_WindowFocusCallback, listener.host.focus, w, focused);
    };
    own.enter = [](GLFWwindow* w, int entered) {
        listener.pass(ImGui_ImplGlfw_CursorEnterCallback, listener.host.enter, w, entered);
    };
#if IMGUI_VERSION_NUM >= 18700  // older versions poll the pointer's position each frame
    own.position = [](GLFWwindow* w, double x, double y) {
        listener.pass(ImGui_ImplGlfw_CursorPosCallback, listener.host.position, w, x, y);
    };
#else
    own.position = [](GLFWwindow* w, double x, double y) {
        if (listener.host.position != nullptr) listener.host.position(w, x, y);
    };
#endif
    own.button = [](GLFWwindow* w, int button, int action, int mods) {
        listener.pass(ImGui_ImplGlfw_MouseButtonCallback, listener.host.button, w, button, action, mods);
    };
    own.scroll = [](GLFWwindow* w, double x, double y) {
        listener.pass(ImGui_ImplGlfw_ScrollCallback, listener.host.scroll, w, x, y);
    };
    own.key = [](GLFWwindow* w, int key, int code, int action, int mods) {
        listener.pass(ImGui_ImplGlfw_KeyCallback, listener.host.key, w, key, code, action, mods);
    };
    own.character = [](GLFWwindow* w, unsigned character) {
        listener.pass(ImGui_ImplGlfw_CharCallback, listener.host.character, w, character);
    };
    return own;
}

}  // namespace

struct ImGuiLayer::Impl {
    explicit Impl(GLFWwindow* context_window) : window(context_window), context(make_context()) {
        const CurrentContext current(context);
        ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
        scale = content_scale(window);
        set_style(scale);
        load_font(scale);
        if (window != nullptr) {
            ImGui_ImplGlfw_InitForOpenGL(window, false);
            listener.context = context;
            listener.host = layer_callbacks().exchange(window);
        }
        ImGui_ImplOpenGL3_Init("#version 330 core");
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        frame.reset();
        {
            const CurrentContext current(context);
            ImGui_ImplOpenGL3_Shutdown();
            if (window != nullptr) {
                (void)std::exchange(listener, {}).host.exchange(window);
                ImGui_ImplGlfw_Shutdown();
            }
        }
        ImGui::DestroyContext(context);
    }

    /// Adopts the scale of the window's display: the window may have moved to another.
    void follow_scale() {
        const float present = content_scale(window);
        if (present == scale) return;
        scale = present;
        ImGui::GetStyle() = ImGuiStyle();
        set_style(scale);
        ImGui::GetIO().Fonts->Clear();
        load_font(scale);
#if IMGUI_VERSION_NUM < 19200  // later versions update the texture themselves
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
    }

    GLFWwindow* window;  // null offscreen
    float scale = 1;
    ImGuiContext* context;
    std::optional<CurrentContext> frame;  // set from begin() to end()
};

ImGuiLayer::ImGuiLayer(Context& context) : impl_(std::make_unique<Impl>(context.window_handle())) {}
ImGuiLayer::ImGuiLayer(ImGuiLayer&&) noexcept = default;
ImGuiLayer& ImGuiLayer::operator=(ImGuiLayer&&) noexcept = default;
ImGuiLayer::~ImGuiLayer() = default;

void ImGuiLayer::begin(int width, int height, float seconds_since_last) {
    impl_->frame.emplace(impl_->context);
    const SavedBindings bindings;  // the first frame uploads the font
    impl_->follow_scale();
    ImGui_ImplOpenGL3_NewFrame();
    if (impl_->window != nullptr) {
        ImGui_ImplGlfw_NewFrame();
    } else {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
        io.DeltaTime = std::max(seconds_since_last, 1e-4f);
    }
    ImGui::NewFrame();
}

void ImGuiLayer::end() {
    ImGui::Render();
    {
        const SavedDrawing host;
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }
    impl_->frame.reset();
}

bool ImGuiLayer::wants_mouse() const {
    const CurrentContext current(impl_->context);
    return ImGui::GetIO().WantCaptureMouse;
}
bool ImGuiLayer::wants_keyboard() const {
    const CurrentContext current(impl_->context);
    return ImGui::GetIO().WantCaptureKeyboard;
}

}  // namespace weft::render
