#pragma once
// The mouse: it drags cloth by a hand, cuts it by a knife, or moves the camera.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "demo/scene_simulation.h"
#include "weft/cutting.h"
#include "weft/render/camera.h"
#include "weft/world.h"

namespace weft::demo {

/// A knife that is drawn over the picture: it cuts all layers of the cloth under the pointer.
class Knife {
  public:
    /// Begins a stroke at the ray.
    void begin(const Simulation& simulation, const render::Ray& ray);
    /// Continues the stroke to that ray and cuts between. Error: why a cloth cannot be cut; others are.
    Result<void> draw_to(const render::Ray& ray, Simulation& simulation);

  private:
    render::Ray last_{};
    std::vector<CutStroke> strokes_;  // one for each cloth of the scene
};

/// A hand on the cloth: it holds one particle and moves it with the pointer.
class Grab {
  public:
    /// The fastest that the hand moves [m/s]: a jump of the pointer must not tear at the cloth.
    static constexpr float max_speed = 8.0f;

    /// Takes hold of the particle under the ray. False if the ray meets no cloth. The hand moves in the plane
    /// through that particle normal to `forward`, the direction in which the camera looks.
    bool begin(World& world, const render::Ray& ray, const Vec3& forward);
    /// Sets the hand's target: the point of its plane on the ray.
    void aim(const render::Ray& ray);
    /// Moves the particle towards the target over the step of dt [s] that follows.
    void before_step(World& world, float dt);
    /// Lets go. A particle that the scene had pinned stays pinned.
    void end(World& world);
    /// The particle will stay pinned after end(), as though the scene had pinned it.
    void leave_pinned() { was_pinned_ = true; }
    /// Forgets the particle: its world is gone.
    void forget() { active_ = false; }

    [[nodiscard]] bool active() const { return active_; }
    [[nodiscard]] bool was_pinned() const { return was_pinned_; }
    [[nodiscard]] ClothId cloth() const { return cloth_; }
    [[nodiscard]] std::uint32_t vertex() const { return vertex_; }
    [[nodiscard]] Vec3 hand() const { return hand_; }  ///< place of the particle at the end of the step [m]

  private:
    bool active_ = false;
    bool was_pinned_ = false;
    ClothId cloth_;
    std::uint32_t vertex_ = 0;
    Vec3 forward_, hand_, target_;
};

/// The mouse in one frame.
struct Pointer {
    float x = 0, y = 0;         ///< place in the picture, in [0, 1]; (0, 0) is the upper left corner
    float right = 0, down = 0;  ///< motion since the last frame, in heights of the picture
    bool left_button = false, other_button = false;  ///< held
    float wheel = 0;                                 ///< notches, away from the hand > 0
    bool over_panel = false;
    bool has_knife = false;  ///< the key is held with which the left button cuts
};

class Interaction {
  public:
    /// The left button on cloth grabs it, beside it orbits, and with the knife cuts all cloth on its way;
    /// another button pans; the wheel zooms. A drag lasts until all buttons are up, wherever the pointer
    /// goes; one that began on a panel belongs to the panel.
    void update(const Pointer& pointer, float aspect, Simulation& simulation, render::OrbitCamera& camera);
    /// Moves the grabbed particle over the step of dt [s] that follows. Pins that the scene moves itself obey
    /// the scene.
    void before_step(Simulation& simulation, float dt) { grab_.before_step(simulation.world(), dt); }
    /// Call this when the hand's world is gone.
    void forget() {
        grab_.forget();
        if (drag_ == Drag::cut) drag_ = Drag::none;
    }
    /// The grabbed particle stays pinned when it is let go.
    void leave_pinned() { grab_.leave_pinned(); }

    [[nodiscard]] const Grab& grab() const { return grab_; }
    [[nodiscard]] bool cuts() const { return drag_ == Drag::cut; }
    /// Why cloth could not be cut, reported once; empty: it could.
    [[nodiscard]] std::string take_complaint() { return std::exchange(complaint_, {}); }

  private:
    enum class Drag { none, panel, grab, cut, orbit, pan };
    Drag begin_drag(const Pointer& pointer, float aspect, Simulation& simulation,
                    const render::OrbitCamera& camera);

    Drag drag_ = Drag::none;
    Grab grab_;
    Knife knife_;
    std::string complaint_;
};

}  // namespace weft::demo
