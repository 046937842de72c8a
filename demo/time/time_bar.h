#pragma once
// The panel that runs, stops, slows down and rewinds time.

#include <optional>

#include "demo/panels/panels.h"
#include "demo/time/timeline.h"

namespace weft::demo {

/// Requests of the panel to the program.
struct TimeRequests {
    std::optional<std::size_t> go_to;  ///< moment of the timeline
    bool restart = false;              ///< restart the scene with the present settings
    bool defaults = false;             ///< restart the scene with its own settings
};

/// Draws the panel at the bottom, within `room` from the left edge [pixels].
[[nodiscard]] TimeRequests time_bar(const Timeline& timeline, Playback& playback, RepeatCheck& check,
                                    float room);

/// The check's result, in words.
[[nodiscard]] std::string words_of(const RepeatCheck& check);

}  // namespace weft::demo
