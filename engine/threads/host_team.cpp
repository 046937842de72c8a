#include "engine/threads/host_team.h"

namespace weft {

void HostTeam::lend(void (*step)(void* context), void* context) noexcept {
    step_ = step;
    context_ = context;
    arrived_.store(0, std::memory_order_relaxed);
    team_.open();
    executor_.run(
        executor_.user, static_cast<std::uint32_t>(executor_.width),
        [](void* team, std::uint32_t) noexcept { static_cast<HostTeam*>(team)->arrive(); }, this);
}

void HostTeam::arrive() noexcept {
    const std::uint32_t place = arrived_.fetch_add(1, std::memory_order_relaxed);
    if (place > 0) {
        team_.help(place, LoopTeam::Duration::max());
        return;
    }
    is_lent_ = true;
    step_(context_);
    is_lent_ = false;
    team_.close();
}

void HostTeam::run(std::uint32_t block_count, Executor::Body body, void* context) {
    if (is_lent_) {
        team_.run(block_count, body, context, [](std::uint32_t) { return false; });
    } else {
        for (std::uint32_t block = 0; block < block_count; ++block) body(context, block);
    }
}

}  // namespace weft
