#pragma once
// Times of pictures in parts, and the quality that is chosen by them.

#include <array>
#include <cstddef>
#include <span>

#include "weft/render/scene_renderer.h"

namespace weft::demo {

/// Times of pictures, in parts: the cloth's steps, the drawing, and the rest.
struct PictureTime {
    float cloth = 0;    ///< all steps taken for the picture [ms]
    float drawing = 0;  ///< [ms]
    float whole = 0;    ///< since the last picture [ms]
    [[nodiscard]] float rest() const { return whole > cloth + drawing ? whole - cloth - drawing : 0; }
};

class PictureTimes {
  public:
    static constexpr std::size_t length = 180;

    void add_step(float milliseconds) { present_.cloth += milliseconds; }
    /// Ends a picture. Times in [ms].
    void add_picture(float drawing, float whole);
    void clear() { *this = {}; }

    [[nodiscard]] std::size_t size() const { return size_; }
    /// The times `age` pictures before the last. Precondition: age < size().
    [[nodiscard]] const PictureTime& at(std::size_t age) const {
        return times_[(next_ + length - 1 - age) % length];
    }
    /// The value that a share `p` of the pictures does not exceed; zeros without pictures.
    [[nodiscard]] PictureTime percentile(float p) const;

  private:
    PictureTime present_;
    std::array<PictureTime, length> times_{};
    std::size_t size_ = 0, next_ = 0;
};

/// The slowest part of a picture and its remedy, in words. `drawing_chosen`: pictures are drawn at the
/// fastest quality already.
[[nodiscard]] const char* what_is_slow(const PictureTime& usual, bool drawing_chosen);

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
