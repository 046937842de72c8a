#include <algorithm>
#include <stdexcept>

#include "demo/study/charts/charts.h"
#include "demo/study/study_options.h"

namespace weft::study {
namespace {

constexpr struct {
    bool (*recognises)(const CsvTable&);
    void (*draw)(const CsvTable&, const std::filesystem::path& folder);
} kinds[] = {{is_accuracy_table, draw_accuracy}, {is_stability_table, draw_stability},
             {is_physics_table, draw_physics},   {is_contact_table, draw_contact},
             {is_searches_table, draw_searches}, {is_budget_table, draw_budget}};

}  // namespace

int run_plot(const PlotOptions& options) {
    for (const std::filesystem::path& file : options.csv) {
        const CsvTable table = read_csv(file);
        const auto kind =
            std::ranges::find_if(kinds, [&](const auto& each) { return each.recognises(table); });
        if (kind == std::end(kinds))
            throw std::runtime_error(file.string() + " is no table that weft_study wrote");
        kind->draw(table, options.out);
    }
    return 0;
}

}  // namespace weft::study
