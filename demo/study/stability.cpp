#include <stdexcept>

#include "demo/study/commands.h"

namespace weft::study {

int run_stability(const StudyOptions& /*options*/) {
    throw std::runtime_error("stability is not built yet");
}

}  // namespace weft::study
