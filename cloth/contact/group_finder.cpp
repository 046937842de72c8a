#include "cloth/contact/group_finder.h"

#include <tuple>

namespace weft {

void GroupFinder::reserve(std::size_t cloths) {
    order_.reserve(cloths);
    groups_.reserve(cloths);
}

void GroupFinder::sort(std::span<const Bounds> boxes) {
    order_.clear();
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].lower.x <= boxes[i].upper.x) order_.push_back(i);
    std::ranges::sort(order_, {}, [&](std::uint32_t i) { return std::tuple(boxes[i].lower.x, i); });
}

void GroupFinder::join(std::span<const std::uint32_t> first_of) {
    for (std::uint32_t i = 0; i < first_of.size(); ++i) join(first_of[i], i);
    end();
}

}  // namespace weft
