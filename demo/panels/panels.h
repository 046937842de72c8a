#pragma once
// The panels: all settings that can change while the cloth moves, and its cost.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "demo/look/look.h"
#include "demo/scene_simulation.h"
#include "demo/window/wind_control.h"
#include "weft/render/camera.h"
#include "weft/render/shown_image.h"

namespace weft::demo {

class Brush;
class Hands;

/// How time passes in the window.
struct Playback {
    bool paused = false;
    int single_steps = 0;           ///< to take while paused
    bool behind_real_time = false;  ///< the last frame had more time than it could simulate
    float speed = 1;                ///< seconds of the scene in a second
};

/// Requests of a panel to the program.
struct PanelRequests {
    const SceneEntry* scene = nullptr;  ///< to change to
    bool restart = false;
    bool reload = false;  ///< build the scene again with the present SceneOptions
};

/// The times of the stages in the last steps, for the plot.
class StageHistory {
  public:
    static constexpr std::size_t length = 240;  ///< steps: four seconds

    void add(std::span<const StageTime> stages);
    void clear();

    [[nodiscard]] std::size_t stages() const { return stages_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Time of a stage [ms], `age` steps before the last. Precondition: age < size().
    [[nodiscard]] float at(std::size_t stage, std::size_t age) const;

  private:
    std::size_t stages_ = 0, size_ = 0, next_ = 0;
    std::vector<float> times_;  // length rows of stages_
};

/// Pictures of scenes, by name: NAME.png in a folder that `demo/pictures/scenes/make` fills.
class ScenePictures {
  public:
    /// The scene's picture; null: there is none. Precondition: a render::Context is current.
    [[nodiscard]] const render::ShownImage* of(const char* scene);

  private:
    std::map<std::string, std::optional<render::ShownImage>> pictures_;
};

class Panels {
  public:
    bool visible = true;
    bool collapsed = false;  ///< to a tab
    bool help = false;
    bool gallery = false;   ///< all scenes are shown
    bool own_file = false;  ///< the choices for the user's own file are shown
    std::string message;    ///< why the last request failed, or its outcome
    /// Width of the window's right that the column covers, as last drawn [pixels].
    [[nodiscard]] float covered() const { return covered_; }
    Look look;

    /// Keeps the times of the step just taken.
    void record(const World& world);
    /// Clears the times, for a new world.
    void forget();
    /// Draws the panels and applies changes to the simulation. Called between ImGuiLayer's begin() and end().
    [[nodiscard]] PanelRequests draw(Simulation& simulation, WindControl& wind, Hands& hands,
                                     const Playback& playback, const render::OrbitCamera& camera);

  private:
    void note(const Result<void>& set);
    void draw_column(Simulation& simulation, WindControl& wind, Hands& hands,
                     const render::OrbitCamera& camera, PanelRequests& requests);
    void show_messages(const Simulation& simulation, const Playback& playback, float room);
    void note_troubles(const Simulation& simulation, const Playback& playback);

    StageHistory history_;
    ScenePictures pictures_;
    const SceneEntry* lab_ = nullptr;  // experiment that the card of the contact lab starts
    std::string troubles_;             // troubles of the last steps, in words
    float covered_ = 0;
    float residual_ = 0;         // mean over about a second
    double troubled_until_ = 0;  // end of their display [s]
};

// One function for each panel, in a file of its name. Error: the simulation refuses the change.
void scene_panel(const Simulation& simulation, ScenePictures& pictures, bool& gallery,
                 PanelRequests& requests);
/// A window over the scene, within the `room` left of the column [pixels]; the chosen scene is in view when
/// it opens. `lab`: the experiment that the card of the contact lab starts. Choosing a card closes the
/// window.
void gallery(bool& shown, const SceneEntry& chosen, const SceneEntry& lab, ScenePictures& pictures,
             float room, PanelRequests& requests);
[[nodiscard]] Result<void> wind_panel(Simulation& simulation, WindControl& wind,
                                      const render::OrbitCamera& camera);
[[nodiscard]] Result<void> method_panel(Simulation& simulation);
[[nodiscard]] Result<void> cloth_panel(Simulation& simulation);
/// `message` gets the outcome of saving.
[[nodiscard]] Result<void> paint_panel(Simulation& simulation, Brush& brush, Inside& inside,
                                       std::string& message);
void picture_panel(Look& look);
void compare_panel(const Simulation& simulation, Look& look);
void files_panel(const Simulation& simulation, Look& look, bool& own_file);
/// A window on the user's own file: its unit, its up axis, what holds it; within the `room` left of the
/// column [pixels]. `message`: the last request's outcome.
void file_window(bool& shown, Simulation& simulation, const std::string& message, float room,
                 PanelRequests& requests);
[[nodiscard]] Result<void> inside_panel(Simulation& simulation, Inside& inside);
[[nodiscard]] Result<void> times_panel(Simulation& simulation, const StageHistory& history, float residual,
                                       const Look& look);
/// A window on keys and mouse, within the `room` left of the column [pixels].
void help_window(bool& shown, float room);

/// The method panel's controls. True if something was changed.
bool method_controls(ClothSettings& settings);
/// Gives all cloths these settings: panels show the first cloth's. Error: of the first cloth that refuses.
[[nodiscard]] Result<void> set_all_cloths(Simulation& simulation, const ClothSettings& settings);

}  // namespace weft::demo
