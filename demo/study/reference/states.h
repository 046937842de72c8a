#pragma once
// The references of a scene, computed once and kept in files, since they take minutes.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "demo/study/run.h"

namespace weft::study {

/// The references. Names of state files depend on these numbers: new ones go to the end.
enum class Reference {
    converged,       ///< backward Euler at the frame's step, solved to convergence
    converged_bdf2,  ///< the same by BDF2
    fine_time,       ///< the truth: tiny steps
    moved_start,     ///< the truth from a start that is a micrometre off: what the scene leaves open
};
inline constexpr std::array all_references{Reference::converged, Reference::converged_bdf2,
                                           Reference::fine_time, Reference::moved_start};
/// The references that a time step of the library has no part in.
[[nodiscard]] inline bool is_truth(Reference reference) {
    return reference == Reference::fine_time || reference == Reference::moved_start;
}
[[nodiscard]] std::string name_of(Reference reference);

/// Positions by the number of frames since the start.
using States = std::map<int, Positions>;

/// Root mean square of the distances between particles [m].
[[nodiscard]] double rms_distance(const Positions& a, const Positions& b);

/// The method of a reference, which the library's step runs unless it is_truth().
[[nodiscard]] MethodPoint method_of(Reference reference);

class ReferenceStore {
  public:
    explicit ReferenceStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The states after each of `frames` (ascending), from the file of the scene's start and settings if
    /// there is one. Throws std::runtime_error where files cannot be written.
    [[nodiscard]] States states(const StudyScene& scene, Reference reference, const std::vector<int>& frames);

  private:
    /// Uses all cores: the bytes do not depend on their number.
    [[nodiscard]] static States compute(const StudyScene& scene, Reference reference,
                                        const std::vector<int>& frames);

    std::filesystem::path folder_;
};

}  // namespace weft::study
