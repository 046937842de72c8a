#pragma once
// Debug messages of an OpenGL driver (KHR_debug).

#include <string>
#include <vector>

namespace weft::render {

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

}  // namespace weft::render
