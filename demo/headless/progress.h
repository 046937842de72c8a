#pragma once
// Prints the progress of a long run on standard error.

#include <chrono>
#include <string>

namespace weft::demo {

/// On a terminal one line that is rewritten ten times a second; elsewhere a new line every five seconds. Runs
/// shorter than that print nothing.
class Progress {
  public:
    Progress(std::string what, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(int done);

  private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    int total_;
    bool terminal_;
    bool line_open_ = false;
    Clock::time_point start_, last_;
};

}  // namespace weft::demo
