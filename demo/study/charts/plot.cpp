#include <stdexcept>

#include "demo/study/accuracy/accuracy_chart.h"
#include "demo/study/budget/budget_chart.h"
#include "demo/study/charts/csv.h"
#include "demo/study/commands.h"
#include "demo/study/contact/contact_chart.h"
#include "demo/study/contact/contact_table.h"
#include "demo/study/contact/searches.h"
#include "demo/study/physics/physics_chart.h"
#include "demo/study/physics/physics_table.h"
#include "demo/study/stability/stability_causes.h"
#include "demo/study/stability/stability_chart.h"

namespace weft::study {

int run_plot(const PlotOptions& options) {
    for (const std::filesystem::path& file : options.csv) {
        const CsvTable table = read_csv(file);
        if (is_accuracy_table(table)) {
            draw_accuracy(table, options.out);
        } else if (is_stability_table(table)) {
            draw_stability(table, options.out);
            write_causes(table, options.out);
        } else if (is_physics_table(table)) {
            draw_physics(table, options.out);
        } else if (is_contact_table(table)) {
            draw_contact(table, options.out);
        } else if (is_searches_table(table)) {
            draw_searches(table, options.out);
        } else if (is_budget_table(table)) {
            draw_budget(table, options.out);
        } else {
            throw std::runtime_error(file.string() + " is no table that weft_study wrote");
        }
    }
    return 0;
}

}  // namespace weft::study
