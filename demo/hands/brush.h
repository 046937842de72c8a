#pragma once
// A brush that paints a map on cloth, and the file that keeps what it painted.

#include <optional>
#include <span>
#include <string>

#include "demo/scene_simulation.h"
#include "weft/render/camera.h"

namespace weft::demo {

/// A map that the brush can paint, with the range of its slider.
struct Paint {
    Map map;
    const char* name;
    const char* format;       ///< of a value in `unit`s, for a slider
    float unit, least, most;  ///< unit: of the slider over the map's own; least and most in the map's own
    float value;              ///< at first
    const char* explanation;
};
[[nodiscard]] std::span<const Paint> paints();
[[nodiscard]] const Paint& paint_of(Map map);

/// Place of a value between the slider's ends, from 0 to 1, by its logarithm.
[[nodiscard]] float share_of_range(Map map, float value);

class Brush {
  public:
    bool is_in_hand = false;
    Map map = Map::mass;
    float value = 4;       ///< in the map's own unit
    float radius = 0.06f;  ///< of a ball about the place that is pointed at [m]

    /// Keeps where the ray meets cloth, for the picture. Call this for each picture.
    void aim(const World& world, const render::Ray& ray);
    void look_away() { place_.reset(); }
    /// The place on cloth that is pointed at; none beside it.
    [[nodiscard]] const std::optional<Vec3>& place() const { return place_; }

    /// Begins a stroke: the next place is not joined to the last.
    void begin() { last_.reset(); }
    /// Paints all cloth within the radius of the way from the last place to this one. Error: the World's, or
    /// the scene's.
    Result<void> stroke(Simulation& simulation);
    /// Gives every vertex of all cloths the value, or the map's default.
    Result<void> fill(Simulation& simulation, bool with_default) const;

  private:
    std::optional<Vec3> place_, last_;
};

/// Writes the maps of the user's own garment beside its file, by that file's vertices. Returns the outcome in
/// words. Error: there is no such file, or it cannot be written.
[[nodiscard]] Result<std::string> save_maps(const Simulation& simulation);

}  // namespace weft::demo
