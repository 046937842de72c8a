#include "weft/fixed_step.h"

#include <algorithm>
#include <cmath>

#include "engine/error_text.h"

namespace weft {

namespace {

// A step is paid out when no more than this fraction of it is missing, so that rounding never holds a due
// step back by a frame: three frames of a third of a step are one step. It is also wide enough that what
// remains, below (1 - tolerance) of a step, cannot round to an alpha of 1 in float.
constexpr double tolerance = 1e-7;

}  // namespace

Result<FixedStep> FixedStep::create(const FixedStepSettings& settings) {
    if (!std::isfinite(settings.step) || settings.step <= 0)
        return out_of_range("FixedStepSettings::step", settings.step, "finite and > 0 s");
    if (settings.max_steps_per_frame < 1)
        return out_of_range("FixedStepSettings::max_steps_per_frame", settings.max_steps_per_frame, ">= 1");
    FixedStep clock;
    clock.settings_ = settings;
    return clock;
}

FixedStepFrame FixedStep::advance(double frame_seconds) noexcept {
    const double step = settings_.step;
    if (std::isfinite(frame_seconds) && frame_seconds > 0) accumulated_ += frame_seconds;

    FixedStepFrame frame;
    const double due = std::floor(accumulated_ / step + tolerance);
    if (due > settings_.max_steps_per_frame) {
        frame.steps = settings_.max_steps_per_frame;
        frame.dropped_seconds = accumulated_ - frame.steps * step;
        accumulated_ = 0;
    } else {
        frame.steps = static_cast<int>(due);
        accumulated_ = std::max(0.0, accumulated_ - frame.steps * step);
    }
    frame.alpha = static_cast<float>(accumulated_ / step);
    return frame;
}

}  // namespace weft
