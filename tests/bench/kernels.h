#pragma once
// The kernels of a step one by one, each on a scene as it stands, with what it has to move and to compute.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/bench_scenes.h"

namespace weft::bench {

/// The least traffic of any implementation, per particle: each array that is read or written counted once.
struct Traffic {
    double bytes = 0;
    double flops = 0;  ///< a fused multiply-add is two; a square root or a division one
};

struct Kernel {
    std::string name;
    Traffic traffic;
    std::function<double()> seconds;  ///< runs it once
};

struct KernelName {
    std::string name;
    bool is_stage;  ///< of a frame: a run of it is one of the frame
};

/// Kernels and what they work on. Those of the linear systems and of XPBD are called by themselves; the rest
/// are the stages of whole frames, as the profiler times them.
class Kernels {
  public:
    explicit Kernels(Scene& scene);
    ~Kernels();
    Kernels(Kernels&&) noexcept;

    [[nodiscard]] const std::vector<Kernel>& list() const { return kernels_; }
    [[nodiscard]] const Kernel* find(const std::string& name) const;
    /// Without making a scene.
    [[nodiscard]] static std::vector<KernelName> names();

  private:
    struct Work;
    std::unique_ptr<Work> work_;
    std::vector<Kernel> kernels_;
};

}  // namespace weft::bench
