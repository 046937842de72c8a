#pragma once
// All that the user does to a scene by pointer and keys, besides the panels.

#include <string>
#include <utility>

#include "demo/hands/air/hand_air.h"
#include "demo/hands/air/wind_arrow.h"
#include "demo/hands/brush.h"
#include "demo/hands/held_collider.h"
#include "demo/window/interaction.h"
#include "demo/window/wind_control.h"

namespace weft::demo {

/// The hands' traces in the World at a step, needed when that step is restored.
struct HandMark {
    bool balls = false;
    ClothId held{};  ///< cloth in a hand, which restoring lets go; null: none
    std::uint32_t vertex = 0;
};

class Hands {
  public:
    /// Applies the mouse. The left button takes hold of the wind's arrow, a collider or cloth, which it
    /// paints while the brush is in hand; elsewhere it turns the camera, as Interaction does. The wheel
    /// scales a held collider. True if the wind was turned.
    bool update(const Pointer& pointer, float aspect, Simulation& simulation, render::OrbitCamera& camera,
                WindControl& wind);

    /// Pins the cloth under the pointer, or lets it go; a grabbed particle stays where it is held.
    Result<void> pin_or_unpin(Simulation& simulation, const render::Ray& ray);
    Result<void> throw_ball(Simulation& simulation, const render::Ray& ray);
    /// Places a fan 0.9 m before the point under the pointer, blowing towards it.
    void blow(const Simulation& simulation, const render::OrbitCamera& camera, const render::Ray& ray);
    void blast(const Simulation& simulation, const render::OrbitCamera& camera, const render::Ray& ray);

    /// Moves what is held over the step of dt [s] that follows, and updates the wind's air sources.
    void before_step(Simulation& simulation, float dt);
    void after_step(const Simulation& simulation, float dt);

    [[nodiscard]] HandMark mark() const;
    /// Call this before the World is restored to a step with that mark ... ...
    Result<void> prepare(Simulation& simulation, const HandMark& mark);
    /// and this after it.
    void arrive_in(Simulation& simulation, const HandMark& mark);
    /// Begins with a new world, in which nothing is held.
    void begin(const Simulation& simulation);

    Brush brush;
    Balls balls;
    HandAir air;
    Streaks streaks;

    [[nodiscard]] const WindArrow& arrow() const { return arrow_; }
    [[nodiscard]] bool holds_arrow() const { return holding_ == Holding::arrow; }
    [[nodiscard]] const Interaction& interaction() const { return interaction_; }
    /// Why cloth could not be cut or painted, reported once; empty: it could.
    [[nodiscard]] std::string take_complaint() {
        return complaint_.empty() ? interaction_.take_complaint() : std::exchange(complaint_, {});
    }

  private:
    enum class Holding { nothing, arrow, collider, brush, other };
    Holding take(const Pointer& pointer, float aspect, const Simulation& simulation,
                 const render::OrbitCamera& camera, const WindControl& wind);

    Holding holding_ = Holding::nothing;
    Vec3 eye_{};  // of the camera
    std::string complaint_;
    WindArrow arrow_;
    HeldCollider collider_;
    Interaction interaction_;
};

}  // namespace weft::demo
