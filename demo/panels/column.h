#pragma once
// One column that holds all panels, at the right edge of the window.

#include <imgui.h>

namespace weft::demo {

/// Width of the column in a window of this size [pixels]: 23 font sizes, at most 0.45 of the window, so that
/// the scene has the larger half.
[[nodiscard]] float column_width(ImVec2 window, float font_size);

/// Opens the column's window; with `collapsed` a tab that opens it. True if panels are to follow; close with
/// ImGui::End() in either case.
bool begin_column(bool& collapsed);

/// Opens all sections and folds, whatever was clicked; for tests.
inline bool all_open = false;

/// Begins a fold, for controls that are seldom needed; if it is open, close it with ImGui::TreePop().
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
