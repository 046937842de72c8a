#pragma once
// A file that is dragged from another program onto the window, by the protocol that X programs have for it
// (XDND 5).

#include <memory>
#include <string>

namespace weft::demo {

class FileDrop {
  public:
    /// Onto the window of that title.
    FileDrop(std::string file, const std::string& title);
    ~FileDrop();
    FileDrop(const FileDrop&) = delete;
    FileDrop& operator=(const FileDrop&) = delete;

    /// Answers what the window asks. True once it has taken the file; call it until then.
    [[nodiscard]] bool goes_on();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft::demo
