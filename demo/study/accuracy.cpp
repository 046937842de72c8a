#include <stdexcept>

#include "demo/study/commands.h"

namespace weft::study {

int run_accuracy(const StudyOptions& /*options*/) {
    throw std::runtime_error("accuracy is not built yet");
}

}  // namespace weft::study
