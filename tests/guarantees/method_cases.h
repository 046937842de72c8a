#pragma once
// Every method with every option that has memory or kernels of its own, on a sheet that meets all there is:
// pins, colliders, air, and itself.

#include <ostream>
#include <string>
#include <vector>

#include "weft/weft.h"

namespace weft::test {

struct MethodCase {
    std::string name;  ///< "multilevel_bdf2": good as a part of a test's name
    ClothSettings cloth;
    WorldSettings world;
    bool grid = true;  ///< false: the same sheet as a general mesh, with another spring topology
};
void PrintTo(const MethodCase& method_case, std::ostream* out);
/// Whether it solves a linear system.
[[nodiscard]] bool is_implicit(const Method& method);

/// All of them. An option that a method ignores is left out for it.
[[nodiscard]] std::vector<MethodCase> method_cases();

/// A sheet that hangs by two corners above a sphere and the ground, and is let down onto them: it folds, and
/// after 0.5 s layers lie on each other.
class LoweredSheet {
  public:
    explicit LoweredSheet(const MethodCase& method_case, int threads = 1, std::uint32_t side = 24);

    void before_step();
    const StepReport& step();

    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] ClothId cloth() const { return cloth_; }
    [[nodiscard]] static Mesh mesh(bool grid, std::uint32_t side);

  private:
    World world_;
    ClothId cloth_;
    std::uint32_t side_;
    float lowered_ = 0;  // [m]
};

}  // namespace weft::test
