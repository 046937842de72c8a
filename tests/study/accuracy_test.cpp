// weft_study accuracy and plot: a tiny run from end to end.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "demo/study/accuracy/accuracy_rows.h"
#include "demo/study/commands.h"
#include "demo/study/study_scenes.h"
#include "study_folder.h"

namespace weft::study {
namespace {

StudyOptions tiny(const StudyFolder& folder) {
    StudyOptions options;
    options.csv = folder.file("accuracy.csv");
    options.quick = true;
    options.threads = 1;
    options.sizes = {8};
    options.scenes = {"hanging"};
    options.only = "cholesky";
    return options;
}

TEST(Accuracy, TinyRunFillsTheTableAndResumes) {
    const StudyFolder folder;
    StudyOptions options = tiny(folder);
    ASSERT_EQ(run_accuracy(options), 0);
    const CsvTable first = read_csv(options.csv);
    const auto row = std::ranges::find(first.rows, std::string("cholesky"),
                                       [](const CsvRow& r) { return r.at("method"); });
    ASSERT_NE(row, first.rows.end());
    EXPECT_EQ(row->at("status"), "ok");
    // A1 is the same linear system solved as exactly, so only rounding parts them.
    EXPECT_LT(parse_number(row->at("error_a1_1s_mm")).value(), 0.1);
    EXPECT_GT(parse_number(row->at("error_a_1s_mm")).value(), 0.1);
    EXPECT_GT(parse_number(row->at("median_ms")).value(), 0);

    options.resume = true;
    options.only = "jacobi";
    ASSERT_EQ(run_accuracy(options), 0);
    const CsvTable second = read_csv(options.csv);
    EXPECT_GT(second.rows.size(), first.rows.size());
    EXPECT_TRUE(
        std::equal(first.rows.begin(), first.rows.end(), second.rows.begin()));  // none measured again

    PlotOptions plot{{options.csv}, folder.file("charts")};
    ASSERT_EQ(run_plot(plot), 0);
    for (const char* const name : {"accuracy-hanging-8-a-1s.svg", "accuracy-hanging-8-b-0.5s.png"})
        EXPECT_GT(std::filesystem::file_size(plot.out / name), 1000u) << name;
}

TEST(Accuracy, EveryMethodRunsAndHasItsOwnKey) {
    const StudyScene scene = hung_sheet(8, false);
    std::set<std::string> keys;
    for (const MethodPoint& point : method_points(Coverage::all, scene)) {
        EXPECT_TRUE(keys.insert(point.name + " " + point.setting).second) << point.name << point.setting;
        study::Run run(scene, point, 1);
        run.step();
        EXPECT_EQ(run.restored_frames(), 0) << point.name << point.setting;
    }
}

// The converged reference as a method has no error and no gap; having done nothing, a gap near 1.
TEST(GarmentSteps, JudgeTheConvergedStepAsPerfect) {
    const StudyFolder folder;
    StudyScene sheet = hung_sheet(10, false);
    ReferenceStore store(folder.path(), 1);
    const GarmentSteps steps(sheet, store, 1);
    study::Run converged(steps.start(1), method_of(Reference::converged), 1);
    converged.step();
    EXPECT_LT(steps.judge(1, converged.cloth()).rms, 1e-7);
    EXPECT_NEAR(steps.judge(1, converged.cloth()).energy_gap, 0, 1e-6);

    MethodPoint weak = method_of(Reference::converged);
    weak.make_solver = {};
    weak.configure = [](ClothSettings& settings) { settings.method = Jacobi{1}; };
    study::Run jacobi(steps.start(1), weak, 1);
    jacobi.step();
    EXPECT_GT(steps.judge(1, jacobi.cloth()).energy_gap, 1e-4);
    EXPECT_LT(steps.judge(1, jacobi.cloth()).energy_gap, 1);
}

}  // namespace
}  // namespace weft::study
