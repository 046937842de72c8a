#pragma once
// Pictures of the window as files: one, or all until stop().

#include <filesystem>
#include <string>

#include "weft/render/scene_renderer.h"

namespace weft::demo {

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

}  // namespace weft::demo
