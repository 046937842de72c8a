// weft_study contact --searches: recall, distance tests and time of the broad phases of avoidance.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

#include "cloth/mesh/cook.h"
#include "collision/particles/rest_neighbours.h"
#include "collision/particles/self_contacts.h"
#include "demo/must.h"
#include "demo/study/charts/charts.h"
#include "demo/study/charts/csv.h"
#include "demo/study/charts/gnuplot.h"
#include "demo/study/machine.h"
#include "demo/study/study_options.h"
#include "weft/mesh.h"

namespace weft::study {

namespace {

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

constexpr std::array searches{SelfCollisionSearch::exact, SelfCollisionSearch::shifted_grids,
                              SelfCollisionSearch::sorted_sweep};

const char* name_of(SelfCollisionSearch search) {
    switch (search) {
        case SelfCollisionSearch::exact:
            return "exact";
        case SelfCollisionSearch::shifted_grids:
            return "shifted grids";
        case SelfCollisionSearch::sorted_sweep:
            return "sorted sweep";
    }
    return "";
}

/// The positions of a sheet, and its pairs that are near at rest.
struct SearchedSheet {
    explicit SearchedSheet(const SearchCase& of)
        : model(must(cook(must(make_sheet({.rows = of.side, .columns = of.side}))))),
          distance(static_cast<float>(of.edges / (of.side - 1))),
          near_at_rest(must(RestNeighbours::find(
              {model.spring_offsets.span(), model.neighbours.span(), model.rest_lengths.span()}, distance))),
          positions(model.positions.span().begin(), model.positions.span().end()) {
        if (of.crumpled) crumple();
    }

    /// Bends the sheet over itself by waves of random direction, the same ones each time.
    void crumple() {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> uniform(-1, 1);
        for (Vec4& p : positions) p.x *= 0.2f, p.z *= 0.2f, p.y = 0;
        for (int k = 0; k < 24; ++k) {
            const float frequency = 4 + 1.5f * static_cast<float>(k), angle = 3.14159265f * uniform(random);
            const float phase = 3.14159265f * uniform(random), size = 1.1f / frequency;
            const Vec3 amplitude{size * uniform(random), size * uniform(random), size * uniform(random)};
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const Vec4& rest = model.positions[i];
                const float along = std::cos(angle) * rest.x + std::sin(angle) * rest.z;
                const float height = std::sin(frequency * along + phase);
                positions[i].x += amplitude.x * height;
                positions[i].y += amplitude.y * height;
                positions[i].z += amplitude.z * height;
            }
        }
    }

    ClothModel model;
    float distance;
    RestNeighbours near_at_rest;
    std::vector<Vec4> positions;
};

/// Number of entries that brute force would put into the particles' lists, up to their capacity.
double listed_by_brute_force(const SearchedSheet& sheet) {
    const auto n = static_cast<std::uint32_t>(sheet.positions.size());
    const RestFilter filter = sheet.near_at_rest.filter();
    double sum = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        const Vec4& a = sheet.positions[i];
        std::uint32_t count = 0;
        for (std::uint32_t j = 0; j < n && count < SelfContacts::capacity; ++j) {
            const Vec4& b = sheet.positions[j];
            const float dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
            const bool is_close = dx * dx + dy * dy + dz * dz < sheet.distance * sheet.distance;
            count += is_close && i != j && !filter.leaves_alone(i, j) ? 1 : 0;
        }
        sum += count;
    }
    return sum;
}

Bounds bounds_of(const std::vector<Vec4>& positions) {
    Bounds box{to_vec3(xyz(positions.front())), to_vec3(xyz(positions.front()))};
    for (const Vec4& p : positions) {
        box.lower = to_vec3(to_vector(box.lower).cwiseMin(xyz(p)));
        box.upper = to_vec3(to_vector(box.upper).cwiseMax(xyz(p)));
    }
    return box;
}

/// Distance tests by patches: sixteen for each particle within the distance of a patch's box. Crowded patches
/// are left to the grid, whose tests are not counted.
double tests_of_patches(Parallel& parallel, const SearchedSheet& sheet) {
    Patches patches(sheet.model.positions.span());
    patches.place(parallel, sheet.positions);
    const PatchesView view = patches.view();
    double sum = 0;
    for (std::size_t p = 0; p < view.patches.size(); ++p) {
        const Boxes& boxes = view.patch_boxes[p / 16];
        const std::size_t k = p % 16;
        const auto outside = [](float x, float lower, float upper) {
            return std::max({lower - x, x - upper, 0.0f});
        };
        if (!(boxes.lower_x[k] <= boxes.upper_x[k])) continue;
        for (const Vec4& q : sheet.positions) {
            const float x = outside(q.x, boxes.lower_x[k], boxes.upper_x[k]),
                        y = outside(q.y, boxes.lower_y[k], boxes.upper_y[k]),
                        z = outside(q.z, boxes.lower_z[k], boxes.upper_z[k]);
            sum += std::max({x, y, z}) <= sheet.distance ? patch_size : 0;
        }
    }
    return sum;
}

double tests_of_shifted_grids(Parallel& parallel, const SearchedSheet& sheet) {
    HashGrid grid(static_cast<std::uint32_t>(sheet.positions.size()));
    double sum = 0;
    for (const float shift : {0.0f, 0.5f}) {
        grid.build_cubes(parallel, sheet.positions, bounds_of(sheet.positions), sheet.distance, shift);
        for (const Vec4& p : sheet.positions) {
            const SlotRange bucket = grid.own_bucket(p.x, p.y, p.z);
            sum += bucket.end - bucket.begin - 1;
        }
    }
    return sum;
}

double tests_of_sweep(Parallel& parallel, const SearchedSheet& sheet) {
    SweepGrid grid(static_cast<std::uint32_t>(sheet.positions.size()));
    grid.build(parallel, sheet.positions, bounds_of(sheet.positions), sheet.distance);
    double sum = 0;
    SlotRanges ranges;
    for (std::uint32_t begin = 0; begin < grid.size(); begin += block_size) {
        const BlockRange block{begin, std::min(begin + block_size, grid.size()), begin / block_size};
        grid.find_ranges(block, ranges);
        for (std::uint32_t slot = block.begin; slot < block.end; ++slot)
            for (const SlotRange& range : ranges.of[slot - block.begin]) sum += range.end - range.begin;
    }
    return sum - grid.size();
}

double tests_of(SelfCollisionSearch search, const SearchedSheet& sheet) {
    Parallel serial(1);
    switch (search) {
        case SelfCollisionSearch::exact:
            return tests_of_patches(serial, sheet);
        case SelfCollisionSearch::shifted_grids:
            return tests_of_shifted_grids(serial, sheet);
        case SelfCollisionSearch::sorted_sweep:
            return tests_of_sweep(serial, sheet);
    }
    return 0;
}

std::vector<SearchCase> chosen(bool quick) {
    std::vector<SearchCase> all;
    for (const bool crumpled : {false, true})
        for (const std::uint32_t side : {32u, 64u, 128u})
            for (const double edges : {0.3, 0.75, 1.5, 3.0})
                if (!quick || (side < 128 && edges < 2)) all.push_back({crumpled, side, edges});
    return all;
}

const std::vector<std::string>& columns() {
    static const std::vector<std::string> names{"machine", "commit",  "state",         "particles",
                                                "edges",   "threads", "search",        "pairs",
                                                "recall",  "tests",   "tests_per_hit", "ns"};
    return names;
}

CsvRow row_of(const SearchCase& of, int threads, SelfCollisionSearch search, const SearchResult& result) {
    const double hits = result.recall * result.pairs;
    return {{"machine", machine_name()},
            {"commit", commit_name()},
            {"state", of.crumpled ? "crumpled" : "flat"},
            {"particles", std::to_string(of.side * of.side)},
            {"edges", number(of.edges)},
            {"threads", std::to_string(threads)},
            {"search", name_of(search)},
            {"pairs", number(result.pairs)},
            {"recall", number(result.recall)},
            {"tests", number(result.tests)},
            {"tests_per_hit", hits > 0 ? number(result.tests / hits) : ""},
            {"ns", number(result.ns)}};
}

/// Results of exact, shifted grids and sorted sweep, in this order, timed in turn.
std::vector<SearchResult> measure_searches(const SearchCase& search_case, int threads, int repeats) {
    using Clock = std::chrono::steady_clock;
    const SearchedSheet sheet(search_case);
    const auto n = static_cast<double>(sheet.positions.size());
    const double listed = listed_by_brute_force(sheet);
    Parallel parallel(threads);
    std::vector<SelfContacts> contacts;
    for (const SelfCollisionSearch search : searches)
        contacts.emplace_back(sheet.model.positions.span(), search);
    std::array<std::vector<double>, searches.size()> times;
    for (int repeat = 0; repeat < repeats + 1; ++repeat) {
        for (std::size_t s = 0; s < searches.size(); ++s) {
            const auto begun = Clock::now();
            contacts[s].find(parallel, sheet.positions, sheet.near_at_rest.filter(), sheet.distance,
                             searches[s]);
            const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
            if (repeat > 0) times[s].push_back(1e9 * seconds / n);  // the first warms up
        }
    }
    std::vector<SearchResult> results;
    for (std::size_t s = 0; s < searches.size(); ++s) {
        double found = 0;
        for (std::uint32_t i = 0; i < sheet.positions.size(); ++i)
            found += static_cast<double>(contacts[s].contacts(i).size());
        std::ranges::sort(times[s]);
        results.push_back({.pairs = listed / n,
                           .recall = listed > 0 ? found / listed : 1,
                           .tests = tests_of(searches[s], sheet) / n,
                           .ns = times[s][times[s].size() / 2]});
    }
    return results;
}

}  // namespace

int run_searches(const StudyOptions& options) {
    const std::vector<SearchCase> cases = chosen(options.quick);
    const int threads = std::max(options.threads, 1), repeats = options.quick ? 11 : 101;
    CsvWriter table(options.csv, columns(), options.resume);
    StudyProgress progress(cases.size(), static_cast<double>(cases.size()));
    const std::vector<std::string> keys{"state", "particles", "edges", "threads", "search"};
    std::printf(
        "| state | particles | edges | search | pairs | recall | tests a particle | a hit | ns |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    for (const SearchCase& each : cases) {
        if (table.find(row_of(each, threads, searches.back(), {}), keys) != nullptr) {
            progress.skip(1);
            continue;
        }
        progress.begin(std::to_string(each.side * each.side) + " at " + number(each.edges) + " edges");
        const std::vector<SearchResult> results = measure_searches(each, threads, repeats);
        for (std::size_t s = 0; s < searches.size(); ++s) {
            const CsvRow row = row_of(each, threads, searches[s], results[s]);
            table.append(row);
            for (const char* column :
                 {"state", "particles", "edges", "search", "pairs", "recall", "tests", "tests_per_hit", "ns"})
                std::printf("| %s ", row.at(column).empty() ? "-" : row.at(column).c_str());
            std::printf("|\n");
        }
        progress.end(1);
    }
    return 0;
}

bool is_searches_table(const CsvTable& table) {
    return table.columns == columns();
}

void draw_searches(const CsvTable& table, const std::filesystem::path& folder) {
    constexpr std::array<const char*, 3> colours{"#d62728", "#1f77b4", "#2ca02c"};
    std::ostringstream settings, recall, work;
    for (std::size_t s = 0; s < searches.size(); ++s) {
        settings << "$search" << s << " << EOD\n";
        for (const CsvRow& row : table.rows)
            if (row.at("search") == name_of(searches[s]) && !row.at("tests_per_hit").empty())
                settings << row.at("ns") << ' ' << row.at("recall") << ' ' << row.at("tests_per_hit") << ' '
                         << 0.5 + parse_number(row.at("edges")).value_or(0) / 1.5 << '\n';
        settings << "EOD\n";
        const std::string style = std::string(" with points pointtype 7 pointsize variable linecolor rgb ") +
                                  quoted(colours[s]) + " title " + quoted(name_of(searches[s]));
        recall << (s > 0 ? ", " : "plot ") << "$search" << s << " using 1:2:4" << style;
        work << (s > 0 ? ", " : "plot ") << "$search" << s << " using 1:3:4" << style;
    }
    settings << "set logscale x\nset grid\nset key outside top center horizontal\nset xlabel "
             << quoted("ns a particle; larger marks are larger distances") << '\n';
    const std::string plot =
        "set multiplot layout 1,2\nset yrange [0:1.05]\nset ylabel 'part of the pairs found'\n" +
        recall.str() + "\nset logscale y\nset yrange [*:*]\nset ylabel 'distances computed for a hit'\n" +
        work.str() + "\nunset multiplot\n";
    draw_with_gnuplot(folder / "searches", {1100, 420, origin_of(table, "contact --searches")},
                      settings.str(), plot);
}

}  // namespace weft::study
