#pragma once
// When the driver came to each part of a picture.

#include <array>

#include "render/gl/gl.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

/// Asks for the time between parts, and reads the answers once they are there, without waiting for them.
class PassTimes {
  public:
    PassTimes();
    void begin();
    void mark();
    void end();
    [[nodiscard]] DrawTimes latest() const { return latest_; }

  private:
    static constexpr std::size_t marks = 4, pictures = 4;
    struct Picture {
        std::array<Query, marks> queries;
        bool asked = false;
    };
    void read(Picture& picture);

    std::array<Picture, pictures> pictures_;
    std::size_t picture_ = 0, mark_ = 0;
    DrawTimes latest_;
};

}  // namespace weft::render
