// The table of physics: measured beside known, and a quick run of all.

#include <gtest/gtest.h>

#include <set>

#include "demo/study/physics/physics_table.h"
#include "demo/study/physics/physics_test.h"

namespace weft::study {
namespace {

TEST(PhysicsTable, ShowsMeasuredBesideKnown) {
    const PhysicsTest test{"cantilever, Gamma 5", ForceModel::mesh, 16, true, {}};
    const Finding drop = finding("drop", "lengths", 0.5, 0.4), range{"folds", "", 7, 6, 8, 1261},
                  unknown{"f", "Hz", 3};
    CsvTable table{physics_columns(), {}};
    for (const Finding& each : {drop, range, unknown}) {
        CsvRow row = physics_row(test, &each);
        for (const std::string& column : table.columns) row.try_emplace(column, "");
        for (const auto& [column, text] : row) EXPECT_EQ(text.find(','), std::string::npos) << column;
        table.rows.push_back(row);
    }
    EXPECT_TRUE(is_physics_table(table));
    const std::string text = physics_markdown(table);
    EXPECT_NE(
        text.find("| cantilever Gamma 5 | springs mesh | 16 | drop [lengths] | 0.5 | 0.4 | +25.0 % |\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("| 1261 vertices | folds | 7 | 6 to 8 | within |\n"), std::string::npos) << text;
    EXPECT_NE(text.find("| f [Hz] | 3 | - | - |\n"), std::string::npos) << text;
}

TEST(PhysicsTests, HaveNamesOfTheirOwnAndAQuickRunOfEveryKindAndModel) {
    std::set<std::string> names, kinds, quick;
    for (const PhysicsTest& test : all_physics_tests()) {
        const std::string model = name_of(test.model);
        EXPECT_TRUE(names.insert(test.name + model + std::to_string(test.cells)).second) << test.name;
        const std::string kind = test.name.substr(0, test.name.find(',')) + model;
        kinds.insert(kind);
        if (test.quick) quick.insert(kind);
    }
    EXPECT_EQ(kinds, quick);
    EXPECT_GE(kinds.size(), 3u * 10);
}

}  // namespace
}  // namespace weft::study
