#pragma once
// One cell of a stability map: one method at one stiffness and step, from one start.

#include <cstdint>
#include <string>

#include "demo/study/run.h"
#include "demo/study/stability/stability_verdict.h"

namespace weft::study {

/// Start positions of the particles of a sheet hung by two corners, at rest.
enum class Start {
    flat,       ///< horizontal, but for a bump of 0.1 mm
    crumpled,   ///< flat, each free particle off by up to 5 mm on each axis
    collapsed,  ///< each free particle within 0.1 mm of one point, the pins half a metre away
};
inline constexpr Start starts[] = {Start::flat, Start::crumpled, Start::collapsed};
[[nodiscard]] std::string name_of(Start start);
/// The start of this name. Throws std::runtime_error if there is none.
[[nodiscard]] Start start_named(const std::string& name);
/// Without collisions, a collapsed sheet comes to rest in a tangle that its springs cannot undo: its stretch
/// may differ more from the hang's, and its height says nothing.
[[nodiscard]] Tolerance tolerance_of(Start start);

/// The sheet and the time that all cells of a map share.
struct StabilitySheet {
    std::uint32_t per_side = 24;
    double seconds = 2;
};

/// The sheet at rest as it hangs.
struct Hang {
    double energy = 0, stretch = 0, height = 0;  ///< as in RunMeasures
};
/// The state of rest that exact linearly implicit steps reach after 4 s. Beyond 100 times the default they
/// would need longer: there stretch is scaled from 100 times in inverse proportion to stiffness.
[[nodiscard]] Hang still_hang(const StabilitySheet& sheet, double stiffness);

/// The scene, its fabric `stiffness` times stiffer than the default. Drag takes 3 of the velocity per second,
/// so that sound motion has come to rest at the end. Speed is not limited: the limit would hide growth.
[[nodiscard]] StudyScene stability_scene(const StabilitySheet& sheet, Start start, double stiffness);

/// Runs one cell with a frame of `step` seconds. Substeps are taken one by one, and the run ends at the first
/// after which the World has restored the state.
[[nodiscard]] RunMeasures measure_cell(const StabilitySheet& sheet, const MethodPoint& point, Start start,
                                       double stiffness, double step, const Hang& hang);

}  // namespace weft::study
