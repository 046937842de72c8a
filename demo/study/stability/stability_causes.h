#pragma once
// The causes for which cells of the stability maps fail, and the eigenvalues that they are derived from.

#include <filesystem>
#include <string>

#include "demo/study/charts/csv.h"
#include "demo/study/run.h"

namespace weft::study {

/// The cause of a row that is not stable, as a sentence.
[[nodiscard]] std::string cause_of(const CsvRow& row, const CsvTable& table);

/// Writes stability-causes.txt: for each method cells by verdict, and the causes of those not stable.
void write_causes(const CsvTable& table, const std::filesystem::path& folder);

/// Frequency of the flat sheet's stiffest mode [rad/s].
[[nodiscard]] double stiffest_frequency(const StudyScene& scene);

/// Largest eigenvalue of D^-1 W of the flat sheet at the scene's frame.
[[nodiscard]] double largest_relaxed(const StudyScene& scene);

/// Share of an error that k Jacobi iterations leave in a mode of D^-1 W with eigenvalue lambda (Kang's first
/// guess is the first of k + 1): (1 - lambda)^(k + 1).
[[nodiscard]] double left_by_jacobi(int iterations, double lambda);
/// Backward Euler amplifies a stiff mode if each solve leaves this share p of its error, or less: x += h v,
/// v += (1 - p)(-v - x / h) has the amplification p - sqrt(p (p - 1)) < -1.
inline constexpr double feeding_part = -1.0 / 3;

}  // namespace weft::study
