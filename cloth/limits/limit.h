#pragma once
// A limit on where particles may be, which holds after each substep whatever the solver has left unsolved.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cloth/mesh/cook.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"
#include "weft/types.h"

namespace weft {

class Limit {
  public:
    virtual ~Limit() = default;

    /// Takes the memory that other pins need, aside: commit() takes it over. May run out of memory; then
    /// nothing has changed. Pins ascend.
    virtual void prepare(const ClothModel& model, std::span<const std::uint32_t> pins) = 0;
    virtual void commit() noexcept = 0;
    /// Brings the limit up to the pins of the last commit(), without memory of its own. A step calls it
    /// before hold(), so that any number of changes between two steps are worked out only once.
    virtual void update(const ClothModel& model) noexcept = 0;
    /// The same for another cloth of the model; what is constant is shared.
    [[nodiscard]] virtual std::unique_ptr<Limit> clone() const = 0;

    /// Puts particles back that are beyond the limit, and takes the velocity at which they leave it.
    virtual void hold(Parallel& parallel, const ClothSettings& settings, std::span<Vec4> positions,
                      std::span<Vec4> velocities) const = 0;
    [[nodiscard]] virtual std::size_t bytes() const noexcept = 0;
};

/// In the order in which they hold.
using Limits = std::vector<std::unique_ptr<Limit>>;

/// Those that the settings ask for. Pins ascend.
[[nodiscard]] Limits make_limits(const ClothModel& model, const ClothSettings& settings,
                                 std::span<const std::uint32_t> pins);
/// Whether both settings ask for the same ones.
[[nodiscard]] bool have_same_limits(const ClothSettings& a, const ClothSettings& b);

}  // namespace weft
