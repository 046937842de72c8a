#pragma once
// How good pictures are, chosen by what they take.

#include <array>
#include <span>

#include "weft/render/scene_renderer.h"

namespace weft::demo {

/// A step of the ladder from good to fast.
struct QualityLevel {
    const char* name;
    render::Quality quality;
    const char* left_out;  ///< in words, what the best has and this has not; "" if nothing
    bool rounded;          ///< cloth is drawn by more triangles than it is made of
    float cost;            ///< about, over that of the best, where a processor draws
};
/// From the best to the fastest.
[[nodiscard]] std::span<const QualityLevel> quality_levels();

class QualityChoice {
  public:
    bool automatic = true;
    float pictures_a_second = 30;  ///< at least; drawing may take two thirds of a picture's time

    /// What drawing a picture at the present level took [ms]. Levels change by the median of some pictures:
    /// down as soon as it is too much, up where what the better one will take is clearly within the limit.
    void add(float milliseconds);
    void choose(int level);    ///< by hand
    void start_at(int level);  ///< it stays automatic
    /// The window has another size: what was measured does not hold any more.
    void forget();

    [[nodiscard]] int level() const { return level_; }
    [[nodiscard]] const QualityLevel& now() const {
        return quality_levels()[static_cast<std::size_t>(level_)];
    }
    [[nodiscard]] float limit() const { return 667.0f / pictures_a_second; }  ///< [ms]

  private:
    static constexpr std::size_t sample = 8, levels = 6;
    static constexpr int settling = 4;  ///< pictures after a change whose times are not its own yet
    [[nodiscard]] float expected(int level, float now) const;
    void move_to(int level);

    int level_ = 0, waiting_ = settling;
    std::size_t count_ = 0;
    std::array<float, sample> times_{};
    std::array<float, levels> measured_{};  // 0: not yet
};

}  // namespace weft::demo
