#pragma once
// The fixed-timestep clock of a game loop: real frame times in, whole steps and a blend factor out.

#include "weft/error.h"
#include "weft/export.h"

namespace weft {

struct FixedStepSettings {
    double step = 1.0 / 60.0;  ///< length of one simulation step [s], > 0
    /// Most steps a frame, >= 1; time beyond it is dropped, so that a slow frame does not cause a slower one.
    int max_steps_per_frame = 4;
};

/// The steps that one rendered frame has to take.
struct FixedStepFrame {
    int steps = 0;               ///< call World::step(step) this many times
    float alpha = 0;             ///< then draw previous + alpha (current - previous), alpha in [0, 1)
    double dropped_seconds = 0;  ///< > 0 when the cap cut time off: the simulation runs slower than real time
};

/// Accumulates rendered time and pays it out in steps (Fiedler 2004, "Fix your timestep!"). It reads no
/// clock: the host passes the time that its last frame took.
class WEFT_API FixedStep {
  public:
    FixedStep() = default;
    /// Error: a step that is not finite and positive, or a cap below 1.
    static Result<FixedStep> create(const FixedStepSettings& settings);

    /// `frame_seconds`: time since the last call [s]. A negative or non-finite time counts as zero.
    FixedStepFrame advance(double frame_seconds) noexcept;
    void reset() noexcept { accumulated_ = 0; }

    [[nodiscard]] const FixedStepSettings& settings() const noexcept { return settings_; }

  private:
    FixedStepSettings settings_;
    double accumulated_ = 0;  // invariant between calls: 0 <= accumulated_ < step
};

}  // namespace weft
