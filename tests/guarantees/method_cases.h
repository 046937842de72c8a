#pragma once
// Every method with every option that has memory or kernels of its own, on a sheet that meets all there is:
// pins, colliders, air, and itself.

#include <ostream>
#include <string>
#include <utility>
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

/// Which particles of a square sheet are pinned.
struct PinPattern {
    std::string name;
    std::vector<std::uint32_t> vertices;
};
[[nodiscard]] PinPattern corners(std::uint32_t side);
/// None, the corners, a row, two rows, and 30 % at random.
[[nodiscard]] std::vector<PinPattern> pin_patterns(std::uint32_t side);

/// A sheet above a sphere and the ground that is let down onto them by its pins: by two corners it folds, and
/// after 0.5 s layers lie on each other.
class LoweredSheet {
  public:
    explicit LoweredSheet(const MethodCase& method_case, int threads = 1, std::uint32_t side = 24)
        : LoweredSheet(method_case, threads, side, corners(side)) {}
    LoweredSheet(const MethodCase& method_case, int threads, std::uint32_t side, const PinPattern& pins);

    void before_step();
    const StepReport& step();

    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] ClothId cloth() const { return cloth_; }
    [[nodiscard]] static Mesh mesh(bool grid, std::uint32_t side);

  private:
    World world_;
    ClothId cloth_;
    std::vector<std::pair<std::uint32_t, Vec3>> pins_;  // and where they start
    float lowered_ = 0;                                 // [m]
};

}  // namespace weft::test
