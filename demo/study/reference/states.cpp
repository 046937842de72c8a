#include "demo/study/reference/states.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>

#include "demo/study/reference/fine_time.h"
#include "demo/study/reference/newton.h"
#include "engine/state_hash.h"

namespace weft::study {

namespace {

constexpr int all_cores = 0;
constexpr std::uint64_t file_version = 4;  // raise it when the format or the references' results change

/// Hash of everything that the states depend on, and of the order of particles in them.
std::uint64_t fingerprint(const StudyScene& scene, Reference reference, const std::vector<int>& frames) {
    const Fabric& fabric = scene.cloth.fabric;
    const Wind& wind = scene.world.wind;
    const std::array numbers{fabric.areal_density,
                             fabric.warp,
                             fabric.weft,
                             fabric.shear,
                             fabric.bending,
                             fabric.damping,
                             scene.cloth.air_damping,
                             scene.frame,
                             wind.velocity.x,
                             wind.velocity.y,
                             wind.velocity.z,
                             wind.gust,
                             wind.air_density,
                             wind.drag,
                             wind.lift,
                             scene.world.gravity.x,
                             scene.world.gravity.y,
                             scene.world.gravity.z};
    const std::array codes{file_version, static_cast<std::uint64_t>(reference)};
    const Mesh& mesh = scene.mesh;
    StateHash hash;
    hash.add(std::span<const std::uint64_t>(codes));
    hash.add(std::span<const float>(numbers));
    hash.add(std::span<const int>(frames));
    hash.add(std::span<const Vec3>(mesh.positions));
    hash.add(std::span<const Triangle>(mesh.triangles));
    hash.add(std::span<const Vec2>(mesh.pattern));
    hash.add(std::span<const std::uint32_t>(scene.pins));
    hash.add(std::span<const Vec4>(scene.start_positions));
    hash.add(std::span<const Vec4>(scene.start_velocities));
    if (mesh.rows == 0) hash.add(std::span<const std::uint32_t>(cook(mesh).value().vertex_to_particle));
    return hash.value();
}

std::filesystem::path file_of(const std::filesystem::path& folder, const StudyScene& scene,
                              Reference reference, const std::vector<int>& frames) {
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx",
                  static_cast<unsigned long long>(fingerprint(scene, reference, frames)));
    const std::string size = scene.per_side > 0 ? "-" + std::to_string(scene.per_side) : "";
    return folder / (scene.name + size + "-" + name_of(reference) + "-" + hash + ".states");
}

/// Reads states as they lie in memory, frame after frame. None if the file is not complete.
States read(const std::filesystem::path& file, const std::vector<int>& frames, std::size_t particles) {
    const std::size_t bytes = particles * sizeof(Eigen::Vector3d);
    std::error_code none;
    if (std::filesystem::file_size(file, none) != frames.size() * bytes || none) return {};
    std::ifstream in(file, std::ios::binary);
    States states;
    for (const int frame : frames) {
        Positions& positions = states[frame];
        positions.resize(particles);
        in.read(reinterpret_cast<char*>(positions.data()), static_cast<std::streamsize>(bytes));
    }
    return in ? states : States{};
}

/// Writes under another name first, so that a stop leaves no incomplete file.
void write(const std::filesystem::path& file, const States& states) {
    std::filesystem::create_directories(file.parent_path());
    const std::filesystem::path unfinished = file.string() + ".part";
    {
        std::ofstream out(unfinished, std::ios::binary);
        for (const auto& [frame, positions] : states) {
            out.write(reinterpret_cast<const char*>(positions.data()),
                      static_cast<std::streamsize>(positions.size() * sizeof(Eigen::Vector3d)));
        }
        if (!out.flush()) throw std::runtime_error(unfinished.string() + " cannot be written");
    }
    std::filesystem::rename(unfinished, file);
}

/// Particles start up to a micrometre higher or lower, each by its own amount.
StudyScene moved(StudyScene scene) {
    if (scene.start_positions.empty()) {
        const ClothModel model = cook(scene.mesh).value();
        scene.start_positions.assign(model.positions.span().begin(), model.positions.span().end());
    }
    std::mt19937 random(1);
    for (Vec4& x : scene.start_positions) x.y += 1e-6f * (static_cast<float>(random() >> 8) * 0x1p-23f - 1);
    return scene;
}

std::size_t particles_of(const StudyScene& scene) {
    return cook(scene.mesh).value().particle_count;
}

}  // namespace

std::string name_of(Reference reference) {
    switch (reference) {
        case Reference::converged:
            return "converged";
        case Reference::converged_bdf2:
            return "converged-bdf2";
        case Reference::fine_time:
            return "fine-time";
        case Reference::moved_start:
            break;
    }
    return "moved-start";
}

double rms_distance(const Positions& a, const Positions& b) {
    double squared = 0;
    for (std::size_t i = 0; i < a.size(); ++i) squared += (a[i] - b[i]).squaredNorm();
    return std::sqrt(squared / static_cast<double>(a.size()));
}

MethodPoint method_of(Reference reference) {
    MethodPoint point{name_of(reference), "Reference", "", {}, {}, false};
    point.configure = [=](ClothSettings& settings) {
        settings.method = Jacobi{};  // its solver is replaced
        settings.substeps = 1;
        settings.time_scheme =
            reference == Reference::converged_bdf2 ? TimeScheme::bdf2 : TimeScheme::backward_euler;
    };
    point.make_solver = [](const ClothModel& model,
                           const ClothSettings& settings) -> std::unique_ptr<Solver> {
        return std::make_unique<ConvergedSolver>(model, settings);
    };
    return point;
}

States ReferenceStore::states(const StudyScene& scene, Reference reference, const std::vector<int>& frames) {
    const std::filesystem::path file = file_of(folder_, scene, reference, frames);
    States states = read(file, frames, particles_of(scene));
    if (states.empty()) {
        states = compute(scene, reference, frames);
        write(file, states);
    }
    return states;
}

States ReferenceStore::compute(const StudyScene& scene, Reference reference, const std::vector<int>& frames) {
    States states;
    if (is_truth(reference)) {
        FineTime fine(reference == Reference::moved_start ? moved(scene) : scene, all_cores);
        const int substeps = FineTime::safe_substeps(scene);
        for (int frame = 1; frame <= frames.back(); ++frame) {
            fine.step(substeps);
            if (std::ranges::find(frames, frame) != frames.end()) states[frame] = fine.positions();
        }
        return states;
    }
    Run run(scene, method_of(reference), all_cores);
    int unconverged = 0;
    float most_left = 0;
    for (int frame = 1; frame <= frames.back(); ++frame) {
        run.step();
        const float left = run.report().residual;
        if (left > static_cast<float>(ConvergedSolver::converged)) ++unconverged;
        most_left = std::max(most_left, left);
        if (std::ranges::find(frames, frame) != frames.end()) states[frame] = positions_of(run.cloth());
    }
    if (unconverged > 0)
        std::fprintf(stderr, "weft_study: %s of %s: in %d of %d frames up to %.1e of the residual is left\n",
                     name_of(reference).c_str(), scene.name.c_str(), unconverged, frames.back(),
                     static_cast<double>(most_left));
    return states;
}

}  // namespace weft::study
