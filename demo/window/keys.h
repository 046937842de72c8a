#pragma once
// Keys that are held down, in Dear ImGui's numbers. KeyTaps records the keys that are tapped.

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
constexpr Key f = ImGuiKey_F;
}  // namespace key

#else  // keys have the numbers of the window system

using Key = int;
namespace key {
constexpr Key left = GLFW_KEY_LEFT, right = GLFW_KEY_RIGHT;
constexpr Key up = GLFW_KEY_UP, down = GLFW_KEY_DOWN;
constexpr Key f = GLFW_KEY_F;
}  // namespace key

#endif

}  // namespace weft::demo
