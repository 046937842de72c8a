#include "demo/study/stability/stability_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "demo/study/accuracy/energy.h"
#include "demo/study/stability/cholesky.h"
#include "demo/study/study_scenes.h"

namespace weft::study {

namespace {

/// Uniform in [-extent, extent] on each axis, the same floats on every machine.
Vector3 noise(std::mt19937& random, float extent) {
    const auto next = [&] { return extent * (static_cast<float>(random() >> 8) * 0x1p-23f - 1); };
    const float x = next(), y = next(), z = next();
    return {x, y, z};
}

void soften_motion(StudyScene& scene) {
    scene.cloth.air_damping = 3;
    scene.world.max_speed = std::numeric_limits<float>::infinity();
}

void stiffen(Fabric& fabric, float times) {
    for (float* k : {&fabric.warp, &fabric.weft, &fabric.shear, &fabric.bending}) *k *= times;
}

/// Mean of max(0, strain) of the structural springs: slack that folds take up does not offset stretch.
double tensile_stretch(const Cloth& cloth) {
    const ClothModel& model = cloth.model;
    double sum = 0;
    std::size_t springs = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            if (model.kinds[e] != SpringKind::structural) continue;
            const Vector3 separation =
                xyz(cloth.state.positions[model.neighbours[e]]) - xyz(cloth.state.positions[i]);
            sum += static_cast<double>(std::max(0.0f, separation.norm() / model.rest_lengths[e] - 1));
            ++springs;
        }
    }
    return sum / static_cast<double>(springs);
}

double height(const Cloth& cloth) {
    double sum = 0, mass = 0;
    for (std::uint32_t i = 0; i < cloth.model.particle_count; ++i) {
        sum += static_cast<double>(cloth.mass(i)) * static_cast<double>(cloth.state.positions[i].y);
        mass += static_cast<double>(cloth.mass(i));
    }
    return sum / mass;
}

/// Whether the last solve left a velocity that is not finite, which the restored state no longer shows.
bool is_broken(const Cloth& cloth) {
    return std::ranges::any_of(cloth.scratch_velocities.span(),
                               [](const Vec4& v) { return !xyz(v).allFinite(); });
}

/// The method with one substep a frame, so that the state is checked after each substep.
MethodPoint by_single_substeps(MethodPoint point) {
    point.configure = [configure = point.configure](ClothSettings& settings) {
        configure(settings);
        settings.substeps = 1;
    };
    return point;
}

}  // namespace

std::string name_of(Start start) {
    switch (start) {
        case Start::flat:
            return "flat";
        case Start::crumpled:
            return "crumpled";
        case Start::collapsed:
            return "collapsed";
    }
    return {};
}

Start start_named(const std::string& name) {
    for (const Start start : starts)
        if (name_of(start) == name) return start;
    throw std::runtime_error("no start is called " + name);
}

Tolerance tolerance_of(Start start) {
    if (start != Start::collapsed) return {};
    return {.stretch = 0.05, .height = std::numeric_limits<double>::infinity()};
}

StudyScene stability_scene(const StabilitySheet& sheet, Start start, double stiffness) {
    StudyScene scene = hung_sheet(sheet.per_side, false);
    soften_motion(scene);
    stiffen(scene.cloth.fabric, static_cast<float>(stiffness));
    std::mt19937 random(1);
    for (std::uint32_t i = 0; i < scene.start_positions.size(); ++i) {
        if (std::ranges::find(scene.pins, i) != scene.pins.end()) continue;
        Vec4& x = scene.start_positions[i];
        if (start == Start::crumpled) set_xyz(x, xyz(x) + noise(random, 5e-3f));
        if (start == Start::collapsed) set_xyz(x, noise(random, 1e-4f));
    }
    return scene;
}

Hang still_hang(const StabilitySheet& sheet, double stiffness) {
    const double simulated = std::min(stiffness, 100.0);
    StudyScene scene = stability_scene(sheet, Start::flat, simulated);
    MethodPoint point;
    point.configure = [](ClothSettings&) {};
    point.make_solver = [](const ClothModel& model, const ClothSettings& settings) {
        return std::make_unique<CholeskySolver>(model, settings);
    };
    Run run(scene, point, 1);
    for (int frame = 0; frame < 240; ++frame) run.step();
    const Cloth& cloth = run.cloth();
    return {energy_of(cloth, scene.world.gravity).total(), tensile_stretch(cloth) * simulated / stiffness,
            height(cloth)};
}

RunMeasures measure_cell(const StabilitySheet& sheet, const MethodPoint& point, Start start, double stiffness,
                         double step, const Hang& hang) {
    StudyScene scene = stability_scene(sheet, start, stiffness);
    const int substeps = point.applied_to(scene.cloth).substeps;
    const double h = step / substeps;
    scene.frame = static_cast<float>(h);
    Run run(scene, by_single_substeps(point), 1);
    const auto total_energy = [&] { return energy_of(run.cloth(), scene.world.gravity).total(); };

    RunMeasures measures{.lasted = sheet.seconds, .start_energy = total_energy()};
    measures.peak_energy = measures.start_energy;
    measures.hang_energy = hang.energy;
    measures.hang_stretch = hang.stretch;
    measures.hang_height = hang.height;
    const int all = substeps * static_cast<int>(std::lround(sheet.seconds / step));
    for (int taken = 1; taken <= all; ++taken) {
        run.step();
        if (run.restored_frames() > 0) {
            measures.not_a_number = is_broken(run.cloth());
            measures.ran_away = !measures.not_a_number;
            measures.lasted = taken * h;
            break;
        }
        if (taken % substeps != 0) continue;
        measures.end_energy = total_energy();
        measures.peak_energy = std::max(measures.peak_energy, measures.end_energy);
    }
    measures.stretch = tensile_stretch(run.cloth());
    measures.height = height(run.cloth());
    return measures;
}

}  // namespace weft::study
