#pragma once
// Fifty curtains in gusts, round a camera that turns: a scene for budgets.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/simulation/simulation.h"

namespace weft::study {

/// How a crowd is stepped.
struct CrowdSettings {
    Method method{};
    int substeps = 1;
    float budget = 0;        ///< [ms]
    std::uint32_t rung = 0;  ///< of the budget's ladder, the same for all cloths; 0: the budget chooses
};

class Crowd {
  public:
    explicit Crowd(const CrowdSettings& settings);
    /// Takes one step and returns its processor time [ms].
    double step();
    /// Whether the camera sees the cloth, and its distance from the camera [m].
    [[nodiscard]] bool is_seen(std::size_t cloth) const;
    [[nodiscard]] float distance(std::size_t cloth) const { return distances_[cloth]; }
    [[nodiscard]] std::size_t size() const { return cloths_.size(); }
    [[nodiscard]] const Cloth& cloth(std::size_t i) const { return *cloths_[i]; }
    [[nodiscard]] const Simulation& simulation() const { return simulation_; }

  private:
    Simulation simulation_;
    std::vector<Cloth*> cloths_;
    std::vector<float> angles_, distances_;
    int steps_ = 0;
};

}  // namespace weft::study
