#include "demo/hands/key_taps.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace weft::demo {

void KeyTaps::listen_to(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int /*code*/, int action, int /*modifiers*/) {
        if (action == GLFW_RELEASE) return;
        static_cast<KeyTaps*>(glfwGetWindowUserPointer(from))->taps_.push_back({key, action == GLFW_REPEAT});
    });
}

int KeyTaps::count(int key, bool repeats) const {
    return static_cast<int>(std::ranges::count_if(
        taps_, [&](const Tap& tap) { return tap.key == key && (repeats || !tap.is_repeat); }));
}

}  // namespace weft::demo
