#include "engine/threads/helper_threads.h"

#include <utility>

#include "engine/memory/without_exceptions.h"

namespace weft {

HelperThreads::HelperThreads(std::shared_ptr<LoopTeam> team, int threads, LoopTeam::Duration patience)
    : team_(std::move(team)) {
    or_undo([&] { start(threads, patience); }, [&] { stop(); });
}

void HelperThreads::start(int threads, LoopTeam::Duration patience) {
    const auto helpers = static_cast<std::size_t>(threads - 1);
    wanted_.reserve(helpers);
    threads_.reserve(helpers);
    for (int place = 1; place < threads; ++place) {
        std::binary_semaphore& wanted = *wanted_.emplace_back(std::make_unique<std::binary_semaphore>(0));
        threads_.emplace_back([this, place, patience, &wanted] {
            for (wanted.acquire(); !stopping_; wanted.acquire())
                team_->help(static_cast<std::uint32_t>(place), patience);
        });
    }
}

HelperThreads::~HelperThreads() {
    stop();
}

void HelperThreads::stop() noexcept {
    stopping_ = true;
    team_->close();
    for (const auto& wanted : wanted_) wanted->release();
    for (std::thread& thread : threads_) thread.join();
}

}  // namespace weft
