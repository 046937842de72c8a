#pragma once
// Every method over its settings: the points of the charts.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cloth/solver/solver.h"

namespace weft::study {

struct StudyScene;

/// One method at one setting.
struct MethodPoint {
    std::string name;     ///< of the curve it belongs to, in tables: "jacobi"
    std::string label;    ///< of that curve, in legends: "Jacobi (Kang)"
    std::string setting;  ///< "iterations=15"
    /// Sets method, time scheme, substeps, tethers: all of ClothSettings that the point is about.
    std::function<void(ClothSettings&)> configure;
    /// Of methods that only the study has; empty: the library's own, as configured.
    std::function<std::unique_ptr<Solver>(const ClothModel&, const ClothSettings&)> make_solver;
    bool is_default = false;  ///< what Weft does if it is told nothing

    [[nodiscard]] ClothSettings applied_to(ClothSettings settings) const {
        configure(settings);
        return settings;
    }
};

/// How much of a method's range is covered.
enum class Coverage { all, quick };

/// In the order in which they are run, curve by curve, settings ascending in cost.
[[nodiscard]] std::vector<MethodPoint> method_points(Coverage coverage, const StudyScene& scene);
/// Those of `points` whose name contains `text`.
[[nodiscard]] std::vector<MethodPoint> only_named(std::vector<MethodPoint> points, const std::string& text);

}  // namespace weft::study
