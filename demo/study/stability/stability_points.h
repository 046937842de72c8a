#pragma once
// The methods that have a stability map, those among them that are known to fail.

#include <functional>
#include <vector>

#include "demo/study/method_list.h"

namespace weft::study {

/// What kind of reasons a method can have to fail.
enum class Family { explicit_euler, symplectic_euler, relaxation, one_linearisation, newton, positional };
[[nodiscard]] std::string name_of(Family family);

struct StabilityPoint {
    MethodPoint method;
    Family family;
    /// Of relaxations: what a solve leaves of an error in a mode with this eigenvalue of D^-1 W.
    std::function<double(double)> left_of = {};
};

/// In the order in which their maps are drawn. The first is what Weft does if it is told nothing.
[[nodiscard]] std::vector<StabilityPoint> stability_points();

}  // namespace weft::study
