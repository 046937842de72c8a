// Tables of figures, and those that are kept.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

#include "demo/study/charts/csv.h"
#include "demo/study/study_options.h"
#include "study_folder.h"

namespace weft::study {

// Tables that runs are resumed from.

namespace {

const std::vector<std::string> columns{"method", "n", "error"};

TEST(Csv, ReadsBackWhatWasAppended) {
    const StudyFolder folder;
    CsvWriter writer(folder.file("a.csv"), columns, false);
    writer.append({{"method", "jacobi"}, {"n", "32"}, {"error", "1.5"}});
    writer.append({{"method", "xpbd"}, {"n", "64"}});  // an error that is not known stays empty
    const CsvTable table = read_csv(folder.file("a.csv"));
    EXPECT_EQ(table.columns, columns);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0].at("error"), "1.5");
    EXPECT_EQ(table.rows[1].at("error"), "");
}

TEST(Csv, ResumesAfterTheLastWholeRow) {
    const StudyFolder folder;
    const auto file = folder.file("a.csv");
    { CsvWriter(file, columns, false).append({{"method", "jacobi"}, {"n", "32"}, {"error", "1.5"}}); }
    { std::ofstream(file, std::ios::app) << "xpbd,6"; }  // stopped in the middle of a row

    CsvWriter resumed(file, columns, true);
    EXPECT_NE(resumed.find({{"method", "jacobi"}, {"n", "32"}}, {"method", "n"}), nullptr);
    EXPECT_EQ(resumed.find({{"method", "jacobi"}, {"n", "64"}}, {"method", "n"}), nullptr);
    EXPECT_EQ(resumed.find({{"method", "xpbd"}, {"n", "64"}}, {"method", "n"}), nullptr);
    resumed.append({{"method", "xpbd"}, {"n", "64"}, {"error", "2"}});
    EXPECT_EQ(read_csv(file).rows.size(), 2u);
}

TEST(Csv, RefusesWhatItCannotGoOnWith) {
    const StudyFolder folder;
    const auto file = folder.file("a.csv");
    CsvWriter writer(file, columns, false);
    EXPECT_THROW(CsvWriter(file, {"other"}, true), std::runtime_error);
    EXPECT_THROW(writer.append({{"method", "with, comma"}}), std::logic_error);
    EXPECT_THROW((void)read_csv(folder.file("none.csv")), std::runtime_error);
}

// demo/charts: its pictures are those of its tables, drawn by today's program.

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
