#pragma once
// Every method over its settings: the points of the charts.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cloth/solver/solver.h"

namespace weft {
struct Cloth;
}  // namespace weft

namespace weft::study {

struct StudyScene;

/// Another engine's cloth, in place of Weft's.
class Peer {
  public:
    Peer() = default;
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;
    virtual ~Peer() = default;
    /// Takes a step and returns its milliseconds of the processor.
    virtual double step(float seconds) = 0;
    /// In the order of Weft's particles [m].
    [[nodiscard]] virtual std::vector<Eigen::Vector3d> positions() const = 0;
};

/// One method at one setting.
struct MethodPoint {
    std::string name;     ///< of the curve it belongs to, in tables: "jacobi"
    std::string label;    ///< of that curve, in legends: "Jacobi (Kang)"
    std::string setting;  ///< "iterations=15"
    /// Sets the point's method, time scheme, substeps, tethers and finite elements.
    std::function<void(ClothSettings&)> configure;
    /// Makes the solver of a method that only the study has; empty: the library's own, as configured.
    std::function<std::unique_ptr<Solver>(const ClothModel&, const ClothSettings&)> make_solver;
    bool is_default = false;  ///< the library's default
    /// Makes another engine's cloth that starts as Weft's does; empty: Weft's is run.
    std::function<std::unique_ptr<Peer>(const StudyScene&, const Cloth&)> make_peer{};

    [[nodiscard]] ClothSettings applied_to(ClothSettings settings) const {
        configure(settings);
        return settings;
    }
};

/// How much of a method's range is covered.
enum class Coverage { all, quick };

/// All points in the order in which they are run: curve by curve, settings ascending in cost.
[[nodiscard]] std::vector<MethodPoint> method_points(Coverage coverage, const StudyScene& scene);
/// The points whose name contains `text`.
[[nodiscard]] std::vector<MethodPoint> only_named(std::vector<MethodPoint> points, const std::string& text);

}  // namespace weft::study
