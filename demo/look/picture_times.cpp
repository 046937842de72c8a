#include "demo/look/picture_times.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace weft::demo {

void PictureTimes::add_picture(float drawing, float whole) {
    present_.drawing = drawing;
    present_.whole = whole;
    times_[next_] = present_;
    present_ = {};
    next_ = (next_ + 1) % length;
    size_ = std::min(size_ + 1, length);
}

PictureTime PictureTimes::percentile(float p) const {
    if (size_ == 0) return {};
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(p * static_cast<float>(size_)));
    const auto of = [&](float PictureTime::*part) {
        std::vector<float> sample;
        for (std::size_t age = 0; age < size_; ++age) sample.push_back(at(age).*part);
        const auto nth = sample.begin() + std::max<std::ptrdiff_t>(rank, 1) - 1;
        std::ranges::nth_element(sample, nth);
        return *nth;
    };
    return {of(&PictureTime::cloth), of(&PictureTime::drawing), of(&PictureTime::whole)};
}

const char* what_is_slow(const PictureTime& usual, bool drawing_chosen) {
    if (usual.cloth >= usual.drawing && usual.cloth >= usual.rest())
        return "Slower than real time: the cloth takes most of a picture's time. Fewer substeps, less "
               "self-collision or a budget make it faster.";
    if (usual.drawing >= usual.rest())
        return drawing_chosen
                   ? "Slower than real time: drawing takes most of a picture's time, with all switched off "
                     "that can be. A smaller window helps."
                   : "Slower than real time: drawing takes most of a picture's time. Choose a faster "
                     "quality, or let it be chosen.";
    return "Slower than real time: neither cloth nor drawing takes the time, but the window system or other "
           "programs.";
}

}  // namespace weft::demo
