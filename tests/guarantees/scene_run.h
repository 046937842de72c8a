#pragma once
// The demo's scenes, run as weft_demo runs them, for tests of what Weft promises in every scene.

#include <ostream>
#include <vector>

#include "demo/scene.h"

namespace weft::demo {

/// So that GoogleTest and CTest name the scene.
void PrintTo(const SceneEntry& entry, std::ostream* out);

/// All scenes, and one whose cloth meets by impact zones, as none of the demo's does.
[[nodiscard]] std::vector<SceneEntry> scenes_to_run();

/// Why the scene cannot be run here (it needs a garment and WEFT_DATA does not lead to one); empty if it can.
[[nodiscard]] std::string cannot_run(const SceneEntry& entry);

class SceneRun {
  public:
    /// Small enough for a quick test, large enough for more blocks than threads. Failures to build end the
    /// test program.
    SceneRun(const SceneEntry& entry, int threads) : SceneRun(entry, threads, {}) {}
    SceneRun(const SceneEntry& entry, const Executor& executor) : SceneRun(entry, 1, executor) {}
    /// Recorded from the start.
    SceneRun(const SceneEntry& entry, const RecordingSink& record) : SceneRun(entry, 1, {}, &record) {}

    /// What the scene moves before a step of 1/60 s, and then the step.
    void before_step();
    const StepReport& step();

    [[nodiscard]] World& world() { return world_; }

  private:
    SceneRun(const SceneEntry& entry, int threads, const Executor& executor,
             const RecordingSink* record = nullptr);

    std::unique_ptr<Scene> scene_;
    World world_;
    double time_ = 0;
};

}  // namespace weft::demo
