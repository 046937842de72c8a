#pragma once
// The methods that have a stability map, among them some that are known to fail.

#include <functional>
#include <vector>

#include "demo/study/method_list.h"

namespace weft::study {

/// Methods grouped by the reasons for which they can fail.
enum class Family { explicit_euler, symplectic_euler, relaxation, one_linearisation, newton, positional };
[[nodiscard]] std::string name_of(Family family);

struct StabilityPoint {
    MethodPoint method;
    Family family;
    /// For relaxations: share of an error that a solve leaves in a mode with this eigenvalue of D^-1 W.
    std::function<double(double)> left_of = {};
};

/// All points in the order in which their maps are drawn. The first is the library's default.
[[nodiscard]] std::vector<StabilityPoint> stability_points();

}  // namespace weft::study
