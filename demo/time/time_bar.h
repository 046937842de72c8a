#pragma once
// The panel of time: runs, stops, slows down, goes back.

#include <optional>

#include "demo/panels/panels.h"
#include "demo/time/repeat_check.h"
#include "demo/time/timeline.h"

namespace weft::demo {

/// What it asks of the program.
struct TimeRequests {
    std::optional<std::size_t> go_to;  ///< moment of the timeline
    bool restart = false;              ///< the scene afresh, with the settings as they are
    bool defaults = false;             ///< likewise, with the scene's own
};

/// At the bottom, within `room` from the left edge on [pixels].
[[nodiscard]] TimeRequests time_bar(const Timeline& timeline, Playback& playback, RepeatCheck& check,
                                    float room);

/// What the check has found, in words.
[[nodiscard]] std::string words_of(const RepeatCheck& check);

}  // namespace weft::demo
