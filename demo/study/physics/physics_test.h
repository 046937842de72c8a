#pragma once
// Tests of physics: each measures cloth, and says what is known of it.

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "demo/study/physics/specimen.h"

namespace weft::study {

/// One figure.
struct Finding {
    std::string quantity, unit;
    double measured = 0;
    /// What is known of it, as a range; its ends are the same where it is one number. Not-a-number: nothing.
    double least = std::numeric_limits<double>::quiet_NaN(), most = least;
    std::uint32_t cells = 0;  ///< where the test measures several resolutions; 0: its own
};

[[nodiscard]] inline Finding finding(std::string quantity, std::string unit, double measured, double known) {
    return {std::move(quantity), std::move(unit), measured, known, known};
}

/// How far it is from what is known, over that: 0 within a range, beyond it from the nearer end; where 0 is
/// known, the figure itself. Not-a-number where nothing is known.
[[nodiscard]] double error_of(const Finding& finding);

struct PhysicsTest {
    std::string name;  ///< "cantilever, Gamma 5"
    ForceModel model;
    std::uint32_t cells;  ///< along the specimen
    bool quick;           ///< part of a run of two minutes
    std::function<std::vector<Finding>()> measure;
};

/// One function for each family, in a file of its name.
[[nodiscard]] std::vector<PhysicsTest> membrane_tests();
[[nodiscard]] std::vector<PhysicsTest> bending_tests();
[[nodiscard]] std::vector<PhysicsTest> drape_tests();
[[nodiscard]] std::vector<PhysicsTest> motion_tests();
[[nodiscard]] std::vector<PhysicsTest> contact_tests();
[[nodiscard]] std::vector<PhysicsTest> flutter_tests();

/// All of them, in that order.
[[nodiscard]] std::vector<PhysicsTest> all_physics_tests();

}  // namespace weft::study
