#include "cloth/frame/budget/ladder.h"

#include <algorithm>

namespace weft {

// As fifty curtains had them: weft_study budget.
const std::array<Rung, rung_count> ladder{{{0, 1, 1.0f, 0.0f},
                                           {2, 1, 0.76f, 0.2f},
                                           {1, 1, 0.58f, 0.31f},
                                           {1, 2, 0.34f, 0.46f},
                                           {1, 4, 0.2f, 1.0f}}};

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
    return less;
}

}  // namespace weft
