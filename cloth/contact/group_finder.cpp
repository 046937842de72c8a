#include "cloth/contact/group_finder.h"

#include <numeric>
#include <tuple>

namespace weft {

void GroupFinder::reserve(std::size_t cloths) {
    order_.reserve(cloths);
    parents_.reserve(cloths);
}

void GroupFinder::begin(std::size_t cloths) {
    parents_.resize(cloths);
    std::iota(parents_.begin(), parents_.end(), 0u);
}

void GroupFinder::sort(std::span<const Bounds> boxes) {
    order_.clear();
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].lower.x <= boxes[i].upper.x) order_.push_back(i);
    std::ranges::sort(order_, {}, [&](std::uint32_t i) { return std::tuple(boxes[i].lower.x, i); });
}

std::uint32_t GroupFinder::root(std::uint32_t cloth) {
    while (parents_[cloth] != cloth) cloth = parents_[cloth] = parents_[parents_[cloth]];
    return cloth;
}

void GroupFinder::join(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = root(i), b = root(j);
    parents_[std::max(a, b)] = std::min(a, b);
}

void GroupFinder::join(std::span<const std::uint32_t> first_of) {
    for (std::uint32_t i = 0; i < first_of.size(); ++i) join(first_of[i], i);
    end();
}

void GroupFinder::end() {
    for (std::uint32_t i = 0; i < parents_.size(); ++i) parents_[i] = root(i);
}

}  // namespace weft
