// weft_study physics: measured figures beside known ones.

#include <chrono>
#include <cstdio>
#include <iterator>

#include "demo/study/charts/csv.h"
#include "demo/study/machine.h"
#include "demo/study/physics/physics_table.h"
#include "demo/study/study_options.h"

namespace weft::study {

std::vector<PhysicsTest> all_physics_tests() {
    std::vector<PhysicsTest> all;
    for (const auto family :
         {membrane_tests, bending_tests, drape_tests, motion_tests, contact_tests, flutter_tests})
        std::ranges::move(family(), std::back_inserter(all));
    return all;
}

namespace {

std::vector<PhysicsTest> chosen(const StudyOptions& options) {
    std::vector<PhysicsTest> tests = all_physics_tests();
    std::erase_if(tests, [&](const PhysicsTest& test) {
        const std::string whole = test.name + ", " + name_of(test.model);
        return (options.quick && !test.quick) || whole.find(options.only) == std::string::npos;
    });
    return tests;
}

}  // namespace

int run_physics(const StudyOptions& options) {
    const std::vector<PhysicsTest> tests = chosen(options);
    if (tests.empty()) {
        std::fprintf(stderr, "weft_study: no test of physics has \"%s\" in its name\n", options.only.c_str());
        return 1;
    }
    CsvWriter table(options.csv, physics_columns(), options.resume);
    const auto cost = [](const PhysicsTest& test) { return static_cast<double>(test.cells * test.cells); };
    double total = 0;
    for (const PhysicsTest& test : tests) total += cost(test);
    StudyProgress progress(tests.size(), total);
    for (const PhysicsTest& test : tests) {
        if (table.find(physics_row(test, nullptr), physics_keys()) != nullptr) {
            progress.skip(cost(test));
            continue;
        }
        progress.begin(test.name + ", " + name_of(test.model) + ", " + std::to_string(test.cells) + " cells");
        const auto begun = std::chrono::steady_clock::now();
        const std::vector<Finding> findings = test.measure();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
        for (const Finding& each : findings) {
            CsvRow row = physics_row(test, &each);
            row["machine"] = machine_name();
            row["commit"] = commit_name();
            row["seconds"] = number(took.count());
            table.append(row);
        }
        progress.end(cost(test));
    }
    std::fputs(physics_markdown(read_csv(options.csv)).c_str(), stdout);
    return 0;
}

}  // namespace weft::study
