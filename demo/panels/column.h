#pragma once
// One column that holds all panels, at the right edge of the window.

#include <imgui.h>

namespace weft::demo {

/// Of the column at this size of the window: about 24 letters wide where there is room, never more than
/// what leaves the scene the larger half [pixels].
[[nodiscard]] float column_width(ImVec2 window, float font_size);

/// Opens the column's window; with `collapsed` a tab that opens it. True if panels are to follow; close with
/// ImGui::End() in either case.
bool begin_column(bool& collapsed);

/// All sections and folds are open, whatever was clicked: for tests.
inline bool all_open = false;

/// What is seldom wanted, under a title of its own; close with ImGui::TreePop() where it is open.
[[nodiscard]] bool begin_fold(const char* title);

/// A part of the column under a title that folds it away.
class Section {
  public:
    explicit Section(const char* title, bool open_at_first = false);
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;
    ~Section();
    explicit operator bool() const { return open_; }

  private:
    bool open_;
};

}  // namespace weft::demo
