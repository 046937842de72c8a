#include "engine/helper_threads.h"

#include <utility>

namespace weft {

HelperThreads::HelperThreads(std::shared_ptr<LoopTeam> team, int threads) : team_(std::move(team)) {
    for (int place = 1; place < threads; ++place) {
        std::binary_semaphore& wanted = *wanted_.emplace_back(std::make_unique<std::binary_semaphore>(0));
        threads_.emplace_back([this, place, &wanted] {
            for (wanted.acquire(); !stopping_; wanted.acquire())
                team_->help(static_cast<std::uint32_t>(place));
        });
    }
}

HelperThreads::~HelperThreads() {
    stopping_ = true;
    team_->close();
    for (const auto& wanted : wanted_) wanted->release();
    for (std::thread& thread : threads_) thread.join();
}

}  // namespace weft
