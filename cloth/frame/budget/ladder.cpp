#include "cloth/frame/budget/ladder.h"

#include <algorithm>

namespace weft {

const std::array<Rung, rung_count> ladder{
    {{0, 1, 1.0f, 0.0f}, {2, 1, 0.7f, 0.25f}, {1, 1, 0.5f, 0.5f}, {1, 2, 0.28f, 0.75f}, {1, 4, 0.17f, 1.0f}}};

namespace {

const Rung& rung_at(std::uint32_t rung) noexcept {
    return ladder[std::min(rung, rung_count - 1)];
}

}  // namespace

std::uint32_t rate_of(std::uint32_t rung) noexcept {
    return rung_at(rung).rate;
}

Method reduced(const Method& method, std::uint32_t rung) {
    const auto* const own = std::get_if<Multilevel>(&method);
    if (rung == 0 || own == nullptr) return method;
    Multilevel less = *own;
    less.passes = std::min(own->passes, rung_at(rung).passes);
    less.iterations = 1;
    less.effort = 1;
    return less;
}

}  // namespace weft
