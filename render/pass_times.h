#pragma once
// Times at which the driver reached each part of a picture.

#include <array>

#include "render/gl/gl.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

/// Queries timestamps between the parts and reads those that are available, without waiting.
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
