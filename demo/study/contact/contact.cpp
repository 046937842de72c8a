// weft_study contact: crossing triangles in scenes where cloth collides with cloth, by every method of
// self-collision.

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "demo/study/charts/csv.h"
#include "demo/study/commands.h"
#include "demo/study/contact/contact_table.h"
#include "demo/study/contact/searches.h"
#include "demo/study/machine.h"
#include "demo/study/study_progress.h"

namespace weft::study {

namespace {

struct Item {
    SceneMaker maker;
    SelfCollisionMethod method;
    double cost;
};

/// Estimated cost of a scene, for the time left: particles times seconds.
double cost_of(const ContactScene& scene) {
    std::size_t particles = 0;
    for (const PlacedCloth& cloth : scene.cloths) particles += cloth.mesh.positions.size();
    return static_cast<double>(particles) * scene.seconds;
}

std::vector<Item> chosen(const StudyOptions& options, std::uint32_t particles) {
    std::vector<Item> items;
    for (const SceneMaker& maker : all_contact_scenes()) {
        if (options.quick && !maker.quick) continue;
        if (maker.needs_garments && std::getenv("WEFT_DATA") == nullptr) {
            std::fprintf(stderr, "%s is left out: WEFT_DATA is not set\n", maker.name.c_str());
            continue;
        }
        for (const SelfCollisionMethod method : self_collision_methods) {
            const std::string whole = maker.name + ", " + name_of(method);
            if (whole.find(options.only) != std::string::npos)
                items.push_back({maker, method, cost_of(maker.make(particles))});
        }
    }
    return items;
}

}  // namespace

int run_contact(const StudyOptions& options) {
    if (options.searches) return run_searches(options);
    const std::uint32_t particles =
        options.particles > 0 || !options.quick ? options.particles : quick_contact_particles;
    const int every = options.quick ? 4 : 1;
    const std::vector<Item> items = chosen(options, particles);
    if (items.empty()) {
        std::fprintf(stderr, "weft_study: no scene of contact has \"%s\" in its name\n",
                     options.only.c_str());
        return 1;
    }
    CsvWriter table(options.csv, contact_columns(), options.resume);
    double total = 0;
    for (const Item& item : items) total += item.cost;
    StudyProgress progress(items.size(), total);
    for (const auto& [maker, method, cost] : items) {
        CsvRow key = contact_key(maker.name, method, particles, every);
        if (table.find(key, contact_keys()) != nullptr) {
            progress.skip(cost);
            continue;
        }
        progress.begin(maker.name + ", " + name_of(method));
        CsvRow row = contact_row(
            key, measure_contact(maker.make(particles), method, thread_count(options.threads), every));
        row["machine"] = machine_name();
        row["commit"] = commit_name();
        table.append(row);
        progress.end(cost);
    }
    std::fputs(contact_markdown(read_csv(options.csv)).c_str(), stdout);
    return 0;
}

}  // namespace weft::study
