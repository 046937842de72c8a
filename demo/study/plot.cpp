#include <stdexcept>

#include "demo/study/commands.h"

namespace weft::study {

int run_plot(const PlotOptions& /*options*/) {
    throw std::runtime_error("plot is not built yet");
}

}  // namespace weft::study
