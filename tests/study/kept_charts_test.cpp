// demo/charts: its pictures are those of its tables, drawn by today's program.

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "demo/study/charts/csv.h"
#include "demo/study/commands.h"
#include "study_folder.h"

namespace weft::study {
namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() != ".csv") names.insert(entry.path().filename().string());
    return names;
}

TEST(KeptCharts, AreThoseOfTheKeptTables) {
    const std::filesystem::path kept = std::filesystem::path(WEFT_SOURCE_FOLDER) / "demo" / "charts";
    const StudyFolder folder;
    PlotOptions plot{{}, folder.path()};
    for (const auto& entry : std::filesystem::directory_iterator(kept)) {
        if (entry.path().extension() != ".csv") continue;
        plot.csv.push_back(entry.path());
        std::set<std::string> commits;
        for (const CsvRow& row : read_csv(entry.path()).rows) commits.insert(row.at("commit"));
        EXPECT_EQ(commits.size(), 1u) << entry.path() << " was not measured in one run";
    }
    ASSERT_EQ(run_plot(plot), 0);
    EXPECT_EQ(names_in(kept), names_in(folder.path())) << "weft_study all --out demo/charts remakes them";
}

}  // namespace
}  // namespace weft::study
