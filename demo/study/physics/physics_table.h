#pragma once
// Tests of physics: each measures cloth, and holds the known values; and the table of their findings.

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "demo/study/charts/csv.h"
#include "demo/study/physics/experiment.h"

namespace weft::study {

/// One measured figure beside its known value.
struct Finding {
    std::string quantity, unit;
    double measured = 0;
    /// The known range; its ends are equal where one number is known. Not-a-number: nothing is known.
    double least = std::numeric_limits<double>::quiet_NaN(), most = least;
    std::uint32_t cells = 0;  ///< vertices, where the test measures several resolutions; 0: it has one
};

[[nodiscard]] inline Finding finding(std::string quantity, std::string unit, double measured, double known) {
    return {std::move(quantity), std::move(unit), measured, known, known};
}

/// Relative error: 0 within the known range, beyond it the distance from the nearer end, over that end. The
/// distance itself where that end is 0. Not-a-number where nothing is known.
[[nodiscard]] double error_of(const Finding& finding);

struct PhysicsTest {
    std::string name;  ///< "cantilever, Gamma 5"
    ForceModel model;
    std::uint32_t cells;  ///< along the specimen
    bool quick;           ///< part of a run of two minutes
    std::function<std::vector<Finding>()> measure;
};

/// The tests of each family.
[[nodiscard]] std::vector<PhysicsTest> membrane_tests();
[[nodiscard]] std::vector<PhysicsTest> bending_tests();
[[nodiscard]] std::vector<PhysicsTest> drape_tests();
[[nodiscard]] std::vector<PhysicsTest> motion_tests();
[[nodiscard]] std::vector<PhysicsTest> contact_tests();
[[nodiscard]] std::vector<PhysicsTest> flutter_tests();

/// All tests, in that order.
[[nodiscard]] std::vector<PhysicsTest> all_physics_tests();

/// The columns of the CSV, which has a row for each finding.
[[nodiscard]] const std::vector<std::string>& physics_columns();

/// The columns that identify a test's rows.
[[nodiscard]] const std::vector<std::string>& physics_keys();
/// The row of a finding; without a finding (null), the keys alone.
[[nodiscard]] CsvRow physics_row(const PhysicsTest& test, const Finding* finding);

/// Markdown: measured beside known, one line for each finding.
[[nodiscard]] std::string physics_markdown(const CsvTable& table);

}  // namespace weft::study
