#pragma once
// The keys that the window listens to, as Dear ImGui numbers them.

#include <imgui.h>

#if IMGUI_VERSION_NUM < 18700
#include <GLFW/glfw3.h>
#endif

namespace weft::demo {

#if IMGUI_VERSION_NUM >= 18700

using Key = ImGuiKey;
namespace key {
constexpr Key left = ImGuiKey_LeftArrow, right = ImGuiKey_RightArrow;
constexpr Key up = ImGuiKey_UpArrow, down = ImGuiKey_DownArrow;
constexpr Key space = ImGuiKey_Space, f1 = ImGuiKey_F1, r = ImGuiKey_R, n = ImGuiKey_N;
constexpr Key b = ImGuiKey_B, f = ImGuiKey_F, p = ImGuiKey_P, t = ImGuiKey_T;
constexpr Key comma = ImGuiKey_Comma, full_stop = ImGuiKey_Period;
constexpr Key first_digit = ImGuiKey_1;
}  // namespace key

#else  // keys have the numbers of the window system

using Key = int;
namespace key {
constexpr Key left = GLFW_KEY_LEFT, right = GLFW_KEY_RIGHT;
constexpr Key up = GLFW_KEY_UP, down = GLFW_KEY_DOWN;
constexpr Key space = GLFW_KEY_SPACE, f1 = GLFW_KEY_F1, r = GLFW_KEY_R, n = GLFW_KEY_N;
constexpr Key b = GLFW_KEY_B, f = GLFW_KEY_F, p = GLFW_KEY_P, t = GLFW_KEY_T;
constexpr Key comma = GLFW_KEY_COMMA, full_stop = GLFW_KEY_PERIOD;
constexpr Key first_digit = GLFW_KEY_1;
}  // namespace key

#endif

namespace key {
/// Of a number from 1 to 9.
constexpr Key digit(int number) {
    return static_cast<Key>(first_digit + number - 1);
}
}  // namespace key

}  // namespace weft::demo
