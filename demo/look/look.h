#pragma once
// Settings of the picture, as the panels set them and the program draws them; and pictures of the window as
// files.

#include <filesystem>
#include <optional>
#include <string>

#include "demo/headless/picture.h"
#include "demo/learn/comparison.h"
#include "demo/look/inside.h"
#include "demo/look/quality_choice.h"
#include "demo/window/input.h"
#include "weft/render/scene_renderer.h"

namespace weft::demo {

/// Pictures of the window as files: one, or all until stop().
class Recorder {
  public:
    static constexpr float pictures_a_second = 30;  ///< of a film, in the scene's time

    explicit Recorder(std::filesystem::path folder = ".") : folder_(std::move(folder)) {}

    /// Writes weft-0001.png, or the next number that is free. Error: the file cannot be written.
    [[nodiscard]] Result<std::filesystem::path> save(const render::Image& image);

    /// Starts a film: add() writes its pictures into a new folder. Error: the folder cannot be made.
    [[nodiscard]] Result<void> start();
    [[nodiscard]] Result<void> add(const render::Image& image);
    /// Ends the film. Returns in words what was written: a film where ffmpeg is found, else pictures.
    [[nodiscard]] Result<std::string> stop();

    [[nodiscard]] bool recording() const { return !film_.empty(); }
    [[nodiscard]] int pictures() const { return pictures_; }

  private:
    std::filesystem::path folder_, film_;  // film_: folder of the film's pictures; empty: none is recorded
    int pictures_ = 0;
};

/// True if a program of that name is in one of $PATH's folders.
[[nodiscard]] bool program_is_there(const std::string& name);

/// Settings of the picture, as the panels set them and the program draws them.
struct Look {
    QualityChoice quality;
    Inside inside;
    Recorder recorder;
    PictureTimes times;
    bool wants_picture = false;                   ///< a picture is to be saved
    bool wants_film = false;                      ///< recording is to begin or to end
    bool wants_save = false, wants_load = false;  ///< settings, to or from settings_file
    std::string settings_file = "weft-settings.json";
    std::optional<Comparison> comparison;
    bool wants_comparison = false;  ///< the scene is to restart with a comparison
    bool ends_comparison = false;   ///< the comparison is to end, and the scene to go on
    Method compared = Xpbd{};
    Fairness fairness = Fairness::same_time;
    bool by_processor = false;  ///< a processor draws the pictures
    float text_size = 1;        ///< factor on the display's own size
};

/// Starts quality low where a processor draws; it rises later.
void begin_look(Picture& picture, Look& look);

/// Draws the view, and chooses the quality of the next picture by this one's time.
void draw_picture(Picture& picture, const render::View& view, int width, int height, Look& look);

/// Draws the inside's words over the picture. Called between the panels' begin() and end().
void draw_words(const Picture& picture, const render::OrbitCamera& camera);

/// The length of the film that is recorded, and how to end it; empty: none is.
[[nodiscard]] std::string recording_words(const Recorder& recorder);
/// Draws these words at the upper right of what panels leave free, `room` pixels wide. The
/// film does not show them. Called where draw_words() is.
void draw_recording(const Recorder& recorder, float room);

/// Draws the method's name, its cost and its error over each of the compared cloths. Called where
/// draw_words() is.
void draw_names(const Picture& picture, const Simulation& shown, const Comparison& comparison,
                const render::OrbitCamera& camera);

/// Fits the whole scene into the part of a window that panels leave free: they cover so much of its right
/// [pixels].
void make_room_for_panels(render::OrbitCamera& camera, float covered, float width, float height);

/// Moves the camera so that both compared scenes are seen; 0 moves it back. `beside`: displacement of the
/// second scene [m]; `before`: that of the last call.
void make_room_beside(render::OrbitCamera& camera, const Vec3& beside, Vec3& before);

/// Saves and records the pictures that the look asks for, at full quality and without space for panels.
/// Returns the outcome in words; empty: nothing was done.
[[nodiscard]] std::string save_pictures(Picture& picture, const render::View& view, int width, int height,
                                        Look& look);

/// Reads F2, F5 and F6. True: panels are to be shown or hidden.
[[nodiscard]] bool read_look_keys(const KeyTaps& keys, Look& look);

}  // namespace weft::demo
