#pragma once
// One cell of a stability map (one method at one stiffness and step, from one start), and the verdict on it.

#include <cstdint>
#include <string>

#include "demo/study/run.h"

namespace weft::study {

/// Measures of a run, and of the same cloth as it hangs still.
struct RunMeasures {
    bool not_a_number = false;  ///< a velocity stopped being a finite number while all positions still were
    bool ran_away = false;      ///< a particle went beyond runaway_distance
    double lasted = 0;          ///< time until one of the two, otherwise all of the run [s]

    double start_energy = 0;  ///< kinetic, elastic and of gravity [J]
    double peak_energy = 0;   ///< highest after any step
    double end_energy = 0;
    double stretch = 0;  ///< mean of max(0, length / rest length - 1) of the structural springs, at the end
    double height = 0;   ///< of the centre of mass at the end [m]

    double hang_energy = 0, hang_stretch = 0, hang_height = 0;

    /// The start's energy above the still hang's: the unit in which a gain is judged.
    [[nodiscard]] double available_energy() const { return start_energy - hang_energy; }
    [[nodiscard]] double energy_rise() const { return (peak_energy - start_energy) / available_energy(); }
    [[nodiscard]] double energy_gain() const { return (end_energy - start_energy) / available_energy(); }
};

/// Tolerances of a run. Nothing puts energy into the scene, so that energy may only fall.
struct Tolerance {
    double energy_rise = 0.1;  ///< above the start's, over available_energy()
    double stretch = 0.01;     ///< mean, from that of the still hang
    double height = 0.1;       ///< of the centre of mass, from that of the still hang [m]
};

enum class Verdict { stable, wrong, diverged, not_a_number };
inline constexpr int verdict_count = 4;

/// "stable", "wrong", "diverged", "nan": as in tables.
[[nodiscard]] std::string word(Verdict verdict);
/// The verdict of a word. Throws std::runtime_error if there is none.
[[nodiscard]] Verdict verdict_of(const std::string& word);

struct Judgement {
    Verdict verdict;
    bool energy = false, stretch = false, height = false;  ///< which tolerances were broken

    /// "energy+stretch"; empty if none was.
    [[nodiscard]] std::string broken() const;
};

/// Mean stretch beyond which a run that has gained energy counts as diverged: three times the cloth's length.
/// Solvers that gravity outruns sag steadily by less.
inline constexpr double torn_stretch = 2;

/// Diverged: ran away, or ended both torn and with more than available_energy() above the start's energy.
/// Wrong: not diverged, but a tolerance is broken.
[[nodiscard]] Judgement judge(const RunMeasures& run, const Tolerance& tolerance);

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
