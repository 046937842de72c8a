#include "demo/study/stability/stability_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "demo/study/accuracy/motion_measures.h"
#include "demo/study/run.h"
#include "demo/study/stability/study_solvers.h"

namespace weft::study {

namespace {

constexpr std::array<const char*, verdict_count> words{"stable", "wrong", "diverged", "nan"};

/// True if a value is at most the limit; false for not-a-number.
bool is_within(double value, double limit) {
    return value <= limit;
}

}  // namespace

std::string word(Verdict verdict) {
    return words[static_cast<std::size_t>(verdict)];
}

Verdict verdict_of(const std::string& word) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (word == words[i]) return static_cast<Verdict>(i);
    throw std::runtime_error("no verdict is called " + word);
}

std::string Judgement::broken() const {
    std::string text;
    const auto add = [&](bool is_broken, const char* name) {
        if (is_broken) text += (text.empty() ? "" : "+") + std::string(name);
    };
    add(energy, "energy");
    add(stretch, "stretch");
    add(height, "height");
    return text;
}

Judgement judge(const RunMeasures& run, const Tolerance& tolerance) {
    if (run.not_a_number) return {Verdict::not_a_number};
    if (run.ran_away) return {Verdict::diverged};
    Judgement judgement{Verdict::stable};
    judgement.energy = !is_within(run.energy_rise(), tolerance.energy_rise);
    judgement.stretch = !is_within(std::abs(run.stretch - run.hang_stretch), tolerance.stretch);
    judgement.height = !is_within(std::abs(run.height - run.hang_height), tolerance.height);
    if (!is_within(run.energy_gain(), 1) && !is_within(run.stretch - run.hang_stretch, torn_stretch))
        judgement.verdict = Verdict::diverged;
    else if (judgement.energy || judgement.stretch || judgement.height)
        judgement.verdict = Verdict::wrong;
    return judgement;
}

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

/// True if the last solve left a velocity that is not finite, which the restored state no longer shows.
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
