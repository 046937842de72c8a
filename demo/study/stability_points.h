#pragma once
// The methods that have a stability map, those among them that are known to fail.

#include <vector>

#include "demo/study/method_list.h"

namespace weft::study {

/// In the order in which their maps are drawn. The first is what Weft does if it is told nothing.
[[nodiscard]] std::vector<MethodPoint> stability_points();

}  // namespace weft::study
