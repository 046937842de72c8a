// weft_study contact: crossing triangles in scenes where cloth collides with cloth, by every method of
// self-collision.

#include <cstdio>
#include <cstdlib>
#include <future>

#include "demo/study/charts/csv.h"
#include "demo/study/contact/contact_table.h"
#include "demo/study/machine.h"
#include "demo/study/study_options.h"

namespace weft::study {

namespace {

struct Rung {
    SelfCollisionMethod method;
    CsvRow key;
};

/// A scene and the rungs that the table lacks.
struct ContactPart {
    SceneMaker maker;
    std::vector<Rung> rungs;
    double cost;
};

/// Estimated cost of a scene, for the time left: particles times seconds.
double cost_of(const ContactScene& scene) {
    std::size_t particles = 0;
    for (const PlacedCloth& cloth : scene.cloths) particles += cloth.mesh.positions.size();
    return static_cast<double>(particles) * scene.seconds;
}

constexpr int every = 4;  // a state of so many is looked at, and the last

std::vector<ContactPart> contact_parts(const StudyOptions& options, std::uint32_t particles,
                                       const CsvWriter& table) {
    std::vector<ContactPart> parts;
    for (const SceneMaker& maker : all_contact_scenes()) {
        const bool is_named_by_size = maker.name == "drape 16k";
        if ((options.quick && !maker.quick) || (particles > 0 && is_named_by_size)) continue;
        if (maker.needs_garments && std::getenv("WEFT_DATA") == nullptr) {
            std::fprintf(stderr, "%s is left out: WEFT_DATA is not set\n", maker.name.c_str());
            continue;
        }
        ContactPart part{maker, {}, 0};
        for (const SelfCollisionMethod method : self_collision_methods) {
            const std::string whole = maker.name + ", " + name_of(method);
            CsvRow key = contact_key(maker.name, method, particles, every);
            if (whole.find(options.only) != std::string::npos && table.find(key, contact_keys()) == nullptr)
                part.rungs.push_back({method, std::move(key)});
        }
        if (part.rungs.empty()) continue;
        part.cost = cost_of(maker.make(particles));
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Runs the scene by its rungs at once, each on one thread. Its time is that thread's on the processor.
std::vector<CsvRow> contact_rows(const ContactPart& part, std::uint32_t particles) {
    std::vector<std::future<CsvRow>> running;
    for (const Rung& rung : part.rungs) {
        running.push_back(std::async(std::launch::async, [&] {
            return contact_row(rung.key, measure_contact(part.maker.make(particles), rung.method, every));
        }));
    }
    std::vector<CsvRow> rows;
    for (std::future<CsvRow>& row : running) rows.push_back(row.get());
    return rows;
}

}  // namespace

int run_contact(const StudyOptions& options) {
    if (options.searches) return run_searches(options);
    const bool is_small = options.quick && options.particles == 0;
    const std::uint32_t particles = is_small ? quick_contact_particles : options.particles;
    CsvWriter table(options.csv, contact_columns(), options.resume);
    const std::vector<ContactPart> parts = contact_parts(options, particles, table);
    if (parts.empty() && !options.resume) {
        std::fprintf(stderr, "weft_study: no scene of contact has \"%s\" in its name\n",
                     options.only.c_str());
        return 1;
    }
    double total = 0;
    for (const ContactPart& part : parts) total += part.cost;
    StudyProgress progress(parts.size(), total);
    for (const ContactPart& part : parts) {
        progress.begin(part.maker.name);
        for (CsvRow& row : contact_rows(part, particles)) {
            row["machine"] = machine_name();
            row["commit"] = commit_name();
            table.append(row);
        }
        progress.end(part.cost);
    }
    std::fputs(contact_markdown(read_csv(options.csv)).c_str(), stdout);
    return 0;
}

}  // namespace weft::study
