#pragma once
// Times of pictures, in parts: the cloth's steps, the drawing, and the rest.

#include <array>
#include <cstddef>

namespace weft::demo {

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

}  // namespace weft::demo
