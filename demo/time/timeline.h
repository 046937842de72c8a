#pragma once
// The last seconds of a simulation, to go back to; and a check that a step has the same result twice.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "demo/hands/hands.h"
#include "demo/scene_simulation.h"
#include "weft/world.h"

namespace weft::demo {

/// A ring of saves, one after each step, in bounded memory: the oldest are dropped. Saves hold no settings: a
/// simulation that continues from an earlier moment keeps the present ones. A cut clears the ring, since
/// older saves do not fit the cut cloth.
class Timeline {
  public:
    static constexpr std::size_t usual_room = std::size_t{256} << 20;  ///< [bytes]

    explicit Timeline(std::size_t room = usual_room) : room_(room) {}

    /// Saves the present state, which becomes here(). Moments after the previous here() are dropped.
    Result<void> keep(const Simulation& simulation, const HandMark& mark = {});
    /// Restores the simulation to that moment, which becomes here(). Precondition: which < size(). Error: the
    /// World does not take the save, and stays where it is.
    Result<void> go_to(std::size_t which, Simulation& simulation);
    void clear();

    /// Number of moments; the oldest is 0.
    [[nodiscard]] std::size_t size() const { return moments_.size(); }
    [[nodiscard]] std::size_t here() const { return here_; }
    [[nodiscard]] double time_of(std::size_t which) const { return moments_[which].time; }  ///< [s]
    [[nodiscard]] const HandMark& mark_of(std::size_t which) const { return moments_[which].mark; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    struct Moment {
        double time = 0;
        HandMark mark{};
        std::vector<std::byte> save;
    };
    /// Gives `moment` a save of `size` bytes, for the oldest ones if needed. False: it exceeds the room.
    bool make_room(std::size_t size, Moment& moment);

    std::size_t room_, bytes_ = 0, here_ = 0;
    std::uint32_t cuts_ = 0;
    std::deque<Moment> moments_;
};

/// Checks that a step has the same result when it is taken twice.
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
