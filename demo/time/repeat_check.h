#pragma once
// Checks that a step has the same result when it is taken twice.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "weft/world.h"

namespace weft::demo {

class RepeatCheck {
  public:
    struct Difference {
        std::uint64_t step = 0;               ///< as StepReport::step counts
        std::uint64_t first = 0, second = 0;  ///< state hashes
        std::optional<std::size_t> cloth{};   ///< the first that differs; none: other state of the World does
        std::uint32_t particle = 0;           ///< the first of that cloth that differs
    };

    bool enabled = false;
    /// Called before the second step, for tests.
    std::function<void(World&)> between;

    /// Takes the World's step; if enabled, undoes it and takes it again.
    const StepReport& step(World& world, std::span<const ClothId> cloths, float dt);

    [[nodiscard]] std::uint64_t checked() const { return checked_; }                           ///< steps
    [[nodiscard]] const std::optional<Difference>& difference() const { return difference_; }  ///< the first
    void forget();

  private:
    void note(const World& world, std::span<const ClothId> cloths, std::uint64_t first, std::uint64_t second);

    std::vector<std::byte> save_;
    std::vector<std::vector<Vec4>> first_;  // positions of each cloth after the first step
    std::uint64_t checked_ = 0;
    std::optional<Difference> difference_;
};

}  // namespace weft::demo
