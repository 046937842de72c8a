#include "demo/headless/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace weft::demo {

using namespace std::chrono_literals;

Progress::Progress(std::string what, int total)
    : what_(std::move(what)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
    if (line_open_) std::fputc('\n', stderr);
}

void Progress::update(int done) {
    const Clock::time_point now = Clock::now();
    if (now - last_ < (terminal_ ? 100ms : 5000ms)) return;
    last_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double left = seconds / done * (total_ - done);
    std::fprintf(stderr, "%s%s: %d of %d, %.0f s left%s", terminal_ ? "\r" : "", what_.c_str(), done, total_,
                 left, terminal_ ? "   " : "\n");
    line_open_ = terminal_;
}

}  // namespace weft::demo
