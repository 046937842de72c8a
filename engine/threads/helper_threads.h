#pragma once
// Helpers of a LoopTeam on threads from the standard library, in place of a oneTBB arena's: without oneTBB
// (WEFT_TBB=OFF), and where every synchronisation has to be visible to the thread sanitizer.

#include <atomic>
#include <memory>
#include <semaphore>
#include <thread>
#include <vector>

#include "engine/threads/loop_team.h"

namespace weft {

class HelperThreads {
  public:
    HelperThreads(std::shared_ptr<LoopTeam> team, int threads, LoopTeam::Duration patience);
    ~HelperThreads();
    HelperThreads(const HelperThreads&) = delete;
    HelperThreads& operator=(const HelperThreads&) = delete;

    /// Wakes the thread of a place, 1 to threads - 1, to call LoopTeam::help(place).
    bool send(std::uint32_t place) noexcept {
        wanted_[place - 1]->release();
        return true;
    }

  private:
    void start(int threads, LoopTeam::Duration patience);
    void stop() noexcept;

    std::shared_ptr<LoopTeam> team_;
    std::atomic<bool> stopping_ = false;
    std::vector<std::unique_ptr<std::binary_semaphore>> wanted_;
    std::vector<std::thread> threads_;
};

}  // namespace weft
