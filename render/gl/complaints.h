#pragma once
// What an OpenGL driver objects to (KHR_debug).

#include <string>
#include <vector>

namespace weft::render {

/// Hears the current context as long as it lives; it must not live longer than the context.
class Complaints {
  public:
    /// Hears nothing where the driver lacks the extension. Precondition: the context is current, and its
    /// functions are loaded.
    Complaints();
    Complaints(const Complaints&) = delete;
    Complaints& operator=(const Complaints&) = delete;

    /// Those since the last call, each once.
    [[nodiscard]] std::vector<std::string> take();
    void add(const std::string& message);

  private:
    std::vector<std::string> heard_;
};

}  // namespace weft::render
