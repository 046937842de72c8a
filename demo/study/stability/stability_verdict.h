#pragma once
// The verdict on a run from a hard start: one of four words.

#include <string>

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

}  // namespace weft::study
