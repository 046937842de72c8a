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

    /// Allocates what other pins need, for commit() to take over. May run out of memory; then nothing has
    /// changed. Precondition: pins ascend.
    virtual void prepare(const ClothModel& model, std::span<const std::uint32_t> pins) = 0;
    virtual void commit() noexcept = 0;
    /// Brings the limit up to the pins of the last commit(), without allocating. A step calls it before
    /// hold(), so that any number of changes between two steps are computed only once.
    virtual void update(const ClothModel& model) noexcept = 0;
    /// Makes the limit for another cloth of the model. Constant data is shared.
    [[nodiscard]] virtual std::unique_ptr<Limit> clone() const = 0;

    /// Moves particles beyond the limit back to it, and removes the velocity at which they leave it.
    virtual void hold(Parallel& parallel, const ClothSettings& settings, std::span<Vec4> positions,
                      std::span<Vec4> velocities) const = 0;
    [[nodiscard]] virtual std::size_t bytes() const noexcept = 0;
};

/// Limits in the order in which they are applied.
using Limits = std::vector<std::unique_ptr<Limit>>;

/// Makes the limits that the settings ask for. Precondition: pins ascend.
[[nodiscard]] Limits make_limits(const ClothModel& model, const ClothSettings& settings,
                                 std::span<const std::uint32_t> pins);
/// Whether both settings ask for the same limits.
[[nodiscard]] bool have_same_limits(const ClothSettings& a, const ClothSettings& b);

}  // namespace weft
