#include "demo/headless/frame_table.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <utility>

namespace weft::demo {

void FrameTable::add(std::span<const StageTime> stages, const StepReport& report) {
    if (stages_.empty()) {
        for (const StageTime& stage : stages) {
            stages_.emplace_back(stage.name);
            depths_.push_back(stage.depth);
        }
    }
    for (const StageTime& stage : stages) times_.push_back(stage.last);
    rows_.push_back({report.particles, report.collider_contacts, report.self_contacts});
}

Result<void> FrameTable::write_csv(const std::filesystem::path& file) const {
    std::ofstream out(file);
    out << "frame";
    for (std::size_t s = 0; s + 1 < stages_.size(); ++s) out << ',' << stages_[s] << "_ms";
    out << ",total_ms,particles,collider_contacts,self_contacts\n";
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        out << row;
        for (std::size_t s = 0; s < stages_.size(); ++s) out << ',' << times_[row * stages_.size() + s];
        out << ',' << rows_[row].particles << ',' << rows_[row].collider_contacts << ','
            << rows_[row].self_contacts << '\n';
    }
    out.close();
    if (!out) return Error{ErrorCode::file_not_found, file.string() + " cannot be written"};
    return {};
}

std::vector<float> FrameTable::times(std::size_t stage) const {
    std::vector<float> times;
    for (std::size_t row = 0; row < rows_.size(); ++row)
        times.push_back(times_[row * stages_.size() + stage]);
    return times;
}

std::string FrameTable::summary() const {
    constexpr std::size_t line_size = 96;
    char line[line_size];
    std::snprintf(line, line_size, "%-22s %9s %9s %9s %9s\n", "stage [ms]", "p50", "p95", "p99", "max");
    std::string text = line;
    for (std::size_t s = 0; s < stages_.size(); ++s) {
        const std::vector<float> stage_times = times(s);
        const auto at = [&](double p) { return static_cast<double>(percentile(stage_times, p)); };
        const std::string name = std::string(2 * static_cast<std::size_t>(depths_[s]), ' ') + stages_[s];
        std::snprintf(line, line_size, "%-22s %9.3f %9.3f %9.3f %9.3f\n", name.c_str(), at(0.5), at(0.95),
                      at(0.99), at(1.0));
        text += line;
    }
    return text;
}

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
