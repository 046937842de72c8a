#include "demo/study/study_progress.h"

#include <algorithm>
#include <cstdio>

namespace weft::study {

void StudyProgress::begin(const std::string& what) {
    begun_ = Clock::now();
    ++item_;
    std::fprintf(stderr, "[%zu/%zu] %s", item_, items_, what.c_str());
    if (const std::optional<double> seconds = seconds_left())
        std::fprintf(stderr, *seconds < 120 ? ", %.0f s left" : ", %.0f min left",
                     *seconds < 120 ? *seconds : *seconds / 60);
    std::fputc('\n', stderr);
}

// The remaining cost may round to less than 0: costs of rounds do not add up to the total to the last bit.
std::optional<double> StudyProgress::seconds_left() const {
    if (!(cost_measured_ > 0)) return std::nullopt;
    return seconds_measured_ / cost_measured_ * std::max(cost_left_, 0.0);
}

void StudyProgress::end(double cost, bool measured) {
    cost_left_ -= cost;
    if (!measured) return;
    cost_measured_ += cost;
    seconds_measured_ += std::chrono::duration<double>(Clock::now() - begun_).count();
}

void StudyProgress::skip(double cost) {
    ++item_;
    cost_left_ -= cost;
}

}  // namespace weft::study
