#pragma once
// weft_study contact --searches: recall, distance tests and time of the broad phases of avoidance.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "collision/particles/self_contacts.h"
#include "demo/study/charts/csv.h"
#include "demo/study/study_options.h"

namespace weft::study {

/// A square sheet of 1 m, flat or crumpled, with `side` particles a side. Particles nearer than `edges` edges
/// are to be found.
struct SearchCase {
    bool crumpled = true;
    std::uint32_t side = 64;
    double edges = 0.75;
};

struct SearchResult {
    double pairs = 0;   ///< per particle, by brute force; at most a list's capacity
    double recall = 0;  ///< share of these that was found; 1 where there are none
    double tests = 0;   ///< distances computed per particle, a pair's from both sides
    double ns = 0;      ///< median time per particle of sort and search
};

/// Results of exact, shifted grids and sorted sweep, in this order, timed in turn.
[[nodiscard]] std::vector<SearchResult> measure_searches(const SearchCase& search_case, int threads,
                                                         int repeats);
[[nodiscard]] const char* name_of(SelfCollisionSearch search);

int run_searches(const StudyOptions& options);
[[nodiscard]] bool is_searches_table(const CsvTable& table);
/// searches.svg and .png: recall, and tests for a hit, over time. Throws std::runtime_error if gnuplot fails.
void draw_searches(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
