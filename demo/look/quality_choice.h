#pragma once
// Chooses the quality of pictures by their drawing times.

#include <array>
#include <span>

#include "weft/render/scene_renderer.h"

namespace weft::demo {

/// A level of the ladder from best to fastest.
struct QualityLevel {
    const char* name;
    render::Quality quality;
    const char* left_out;  ///< what is missing against the best, in words; "" if nothing
    bool rounded;          ///< cloth is drawn by RoundedMesh
    float cost;            ///< drawing time over that of the best, about, by a processor
};
/// The levels, from the best to the fastest.
[[nodiscard]] std::span<const QualityLevel> quality_levels();

class QualityChoice {
  public:
    bool automatic = true;
    float pictures_a_second = 30;  ///< least rate; drawing may take two thirds of a picture's time

    /// Adds a picture's drawing time at the present level [ms]. The median of eight decides: above limit()
    /// the level drops; it rises if the better level's expected time is below 0.8 limit(). Times of pictures
    /// of another number of pixels are discarded.
    void add(float milliseconds, int pixels);
    void choose(int level);    ///< chooses a level by hand: `automatic` ends
    void start_at(int level);  ///< the choice stays automatic

    [[nodiscard]] int level() const { return level_; }
    [[nodiscard]] const QualityLevel& now() const {
        return quality_levels()[static_cast<std::size_t>(level_)];
    }
    [[nodiscard]] float limit() const { return 667.0f / pictures_a_second; }  ///< [ms]

  private:
    static constexpr std::size_t sample = 8, levels = 6;
    static constexpr int settling = 4;  ///< pictures after a change whose times are ignored
    [[nodiscard]] float expected(int level, float now) const;
    void move_to(int level);

    int level_ = 0, waiting_ = settling, pixels_ = 0;
    std::size_t count_ = 0;
    std::array<float, sample> times_{};
    std::array<float, levels> measured_{};  // median of each level [ms]; 0: none yet
};

}  // namespace weft::demo
