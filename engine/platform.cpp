#include "engine/platform.h"

#ifndef WEFT_WITHOUT_THREADS
#include <thread>
#endif

namespace weft {

#ifdef WEFT_WITHOUT_THREADS
int hardware_threads() noexcept {
    return 1;
}

void yield_thread() noexcept {}
#else
int hardware_threads() noexcept {
    return static_cast<int>(std::thread::hardware_concurrency());
}

void yield_thread() noexcept {
    std::this_thread::yield();
}
#endif

}  // namespace weft
