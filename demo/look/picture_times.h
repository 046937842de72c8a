#pragma once
// Where the time of a picture goes: the cloth's steps, the drawing, and the rest.

#include <array>
#include <cstddef>

namespace weft::demo {

struct PictureTime {
    float cloth = 0;    ///< all steps that were taken for it [ms]
    float drawing = 0;  ///< [ms]
    float whole = 0;    ///< from the last picture to it [ms]
    [[nodiscard]] float rest() const { return whole > cloth + drawing ? whole - cloth - drawing : 0; }
};

class PictureTimes {
  public:
    static constexpr std::size_t length = 180;

    void add_step(float milliseconds) { present_.cloth += milliseconds; }
    /// The picture is done.
    void add_picture(float drawing, float whole);
    void clear() { *this = {}; }

    [[nodiscard]] std::size_t size() const { return size_; }
    /// `age` pictures before the last. Precondition: age < size().
    [[nodiscard]] const PictureTime& at(std::size_t age) const {
        return times_[(next_ + length - 1 - age) % length];
    }
    /// The value that a share `p` of the pictures does not exceed; zeros while there is none.
    [[nodiscard]] PictureTime percentile(float p) const;

  private:
    PictureTime present_;
    std::array<PictureTime, length> times_{};
    std::size_t size_ = 0, next_ = 0;
};

/// Why time is lost, in words: what of a picture takes most, and what helps. `drawing_chosen`: pictures are
/// made as fast as they can be by themselves.
[[nodiscard]] const char* what_is_slow(const PictureTime& usual, bool drawing_chosen);

}  // namespace weft::demo
