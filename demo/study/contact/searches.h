#pragma once
// weft_study contact --searches: what the broad phases of avoidance find, what they test for it, and in what
// time.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "demo/study/charts/csv.h"
#include "demo/study/study_options.h"
#include "weft/self_collision.h"

namespace weft::study {

/// A square sheet of 1 m, flat or crumpled, of so many particles a side; particles nearer than so many edges
/// are to be found.
struct SearchCase {
    bool crumpled = true;
    std::uint32_t side = 64;
    double edges = 0.75;
};

struct SearchResult {
    double pairs = 0;   ///< per particle and its list: brute force's, but no more than a list holds
    double recall = 0;  ///< part of these that was found; 1 where there are none
    double tests = 0;   ///< distances computed per particle, a pair's from both sides
    double ns = 0;      ///< per particle, sort and search: the median
};

/// By exact, shifted grids and sorted sweep, timed in turn.
[[nodiscard]] std::vector<SearchResult> measure_searches(const SearchCase& search_case, int threads,
                                                         int repeats);
[[nodiscard]] const char* name_of(SelfCollisionSearch search);

int run_searches(const StudyOptions& options);
[[nodiscard]] bool is_searches_table(const CsvTable& table);
/// searches.svg and .png: recall, and tests for a hit, over time. Throws std::runtime_error if gnuplot fails.
void draw_searches(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
