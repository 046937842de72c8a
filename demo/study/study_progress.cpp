#include "demo/study/study_progress.h"

#include <cstdio>

namespace weft::study {

void StudyProgress::begin(const std::string& what) {
    begun_ = Clock::now();
    ++item_;
    std::fprintf(stderr, "[%zu/%zu] %s", item_, items_, what.c_str());
    if (cost_measured_ > 0) {
        const double seconds = seconds_measured_ / cost_measured_ * cost_left_;
        std::fprintf(stderr, seconds < 120 ? ", %.0f s left" : ", %.0f min left",
                     seconds < 120 ? seconds : seconds / 60);
    }
    std::fputc('\n', stderr);
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
