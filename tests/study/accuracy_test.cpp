// weft_study accuracy and plot: a tiny run from end to end.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

#include "demo/study/accuracy/accuracy_rows.h"
#include "demo/study/accuracy/motion_measures.h"
#include "demo/study/run.h"
#include "demo/study/study_options.h"
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
    EXPECT_GT(parse_number(row->at("own_1s_mm")).value(), 0.1) << "one linearisation is not the step";
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
    for (const char* const name : {"accuracy-hanging-8-own-0.5s.svg", "accuracy-hanging-8-truth-1s.png"})
        EXPECT_GT(std::filesystem::file_size(plot.out / name), 1000u) << name;
    std::ifstream picture(plot.out / "accuracy-hanging-8-truth-1s.svg");
    const std::string text(std::istreambuf_iterator<char>(picture), {});
    EXPECT_NE(text.find(row->at("commit")), std::string::npos) << "a chart says where it is from";
    EXPECT_NE(text.find(row->at("machine")), std::string::npos);
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

// A method is compared with what it converges to itself, so that the converged steps have no distance of
// their own, and each has one from the truth.
TEST(Accuracy, ConvergedStepsAreTheirOwnReferences) {
    const StudyFolder folder;
    const StudyScene scene = hung_sheet(8, false);
    ReferenceStore store(folder.path());
    std::map<Reference, States> references;
    for (const Reference reference : all_references)
        references[reference] = store.states(scene, reference, compared_frames(scene));
    for (const Reference reference : {Reference::converged, Reference::converged_bdf2}) {
        const CsvRow row = measure_trajectory(scene, method_of(reference), references, 1).row;
        for (const char* const moment : {"_0.5s_mm", "_1s_mm"}) {
            EXPECT_LT(parse_number(row.at(std::string("own") + moment)).value(), 1e-3) << row.at("method");
            EXPECT_GT(parse_number(row.at(std::string("truth") + moment)).value(), 1) << row.at("method");
        }
    }
}

// The air's force is not linear, and passes take it anew: so must the step that they converge to.
TEST(Accuracy, PassesConvergeToTheConvergedStepInWind) {
    const StudyFolder folder;
    const StudyScene scene = hung_sheet(10, true);
    ReferenceStore store(folder.path());
    std::map<Reference, States> references;
    references[Reference::converged_bdf2] =
        store.states(scene, Reference::converged_bdf2, compared_frames(scene));
    const auto distance_of = [&](int passes) {
        MethodPoint point;
        point.configure = [=](ClothSettings& settings) {
            settings.method = Multilevel{.passes = passes};
            settings.time_scheme = TimeScheme::bdf2;
        };
        const CsvRow row = measure_trajectory(scene, point, references, 1).row;
        return parse_number(row.at("own_0.5s_mm")).value();
    };
    EXPECT_LT(distance_of(30), 0.2 * distance_of(1));
    EXPECT_LT(distance_of(30), 0.5) << "mm";
}

#ifdef WEFT_WITH_BULLET
TEST(Accuracy, BulletsClothNearsTheTruthWithItsIterations) {
    const StudyFolder folder;
    const StudyScene scene = hung_sheet(8, false);
    std::map<Reference, States> truth;
    truth[Reference::fine_time] =
        ReferenceStore(folder.path()).states(scene, Reference::fine_time, compared_frames(scene));
    std::vector<double> distances;
    for (const MethodPoint& point : only_named(method_points(Coverage::all, scene), "bullet")) {
        const CsvRow row = measure_trajectory(scene, point, truth, 1).row;
        distances.push_back(parse_number(row.at("truth_0.5s_mm")).value());
        EXPECT_FALSE(row.contains("own_0.5s_mm"));
    }
    ASSERT_GT(distances.size(), 1u);
    EXPECT_LT(distances.back(), distances.front());
    EXPECT_LT(distances.back(), 200);
}
#endif

// The measures of weft_study motion, on known motion.

MethodPoint implicit(TimeScheme scheme) {
    MethodPoint point;
    point.configure = [=](ClothSettings& settings) {
        settings.method = Multilevel{.passes = 20};
        settings.time_scheme = scheme;
        settings.substeps = 1;
    };
    return point;
}

TEST(SwingMeasures, TheTruthWithoutDampingKeepsItsEnergy) {
    StudyScene scene = swinging_sheet(9);
    scene.cloth.fabric.damping = 0;
    const double kept = energy_lost(scene, true_swing(scene, 60, 1, 1));
    EXPECT_NEAR(kept, 0, 5e-3);
    scene.cloth.fabric.damping = 5e-3f;
    EXPECT_GT(energy_lost(scene, true_swing(scene, 60, 1, 1)), 0.015) << "damping takes its part";
}

TEST(SwingMeasures, ASchemeOfSecondOrderLosesLessAndIsFasterThanOneOfFirst) {
    const StudyScene scene = swinging_sheet(9);
    const Swing truth = true_swing(scene, 60, 1, 1);
    const Swing second = swing(scene, implicit(TimeScheme::bdf2), 60, 1, 1);
    const Swing first = swing(scene, implicit(TimeScheme::backward_euler), 60, 1, 1);
    EXPECT_LT(energy_lost(scene, truth), energy_lost(scene, second));
    EXPECT_LT(energy_lost(scene, second), energy_lost(scene, first));
    EXPECT_GT(second.speed, first.speed);
}

TEST(TimeToRest, IsWhenSpeedsStayBelowTheLimit) {
    EXPECT_DOUBLE_EQ(time_to_rest(std::vector{3.0, 0.5, 2.0, 0.5, 0.4}, 0.1, 1), 0.4);
    EXPECT_DOUBLE_EQ(time_to_rest(std::vector{0.5, 0.5}, 0.1, 1), 0.1);
    EXPECT_EQ(time_to_rest(std::vector{0.5, 1.0}, 0.1, 1), std::numeric_limits<double>::infinity());
    EXPECT_EQ(time_to_rest(std::vector{0.5, std::nan("")}, 0.1, 1), std::numeric_limits<double>::infinity());
}

}  // namespace

}  // namespace weft::study
