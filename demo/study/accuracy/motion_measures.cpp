#include "demo/study/accuracy/motion_measures.h"

#include <cmath>
#include <limits>
#include <vector>

#include "cloth/fabric/springs/membrane.h"
#include "demo/study/reference/fine_time.h"
#include "demo/study/run.h"

namespace weft::study {

Energy energy_of(const Cloth& cloth, const Vec3& gravity) {
    const ClothModel& model = cloth.model;
    const Fabric& fabric = cloth.settings.fabric;
    std::vector<float> stiffness(model.neighbours.size());
    spring_stiffness(model, fabric, stiffness);
    const Eigen::Vector3d g = to_vector(gravity).cast<double>();
    Energy energy;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const Eigen::Vector3d x = xyz(cloth.state.positions[i]).cast<double>();
        const Eigen::Vector3d v = xyz(cloth.state.velocities[i]).cast<double>();
        const auto mass = static_cast<double>(cloth.mass(i));
        if (cloth.state.positions[i].w > 0) energy.kinetic += mass * v.squaredNorm() / 2;
        energy.gravity -= mass * g.dot(x);
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            if (j < i) continue;  // each spring is stored at both ends
            const double length = (xyz(cloth.state.positions[j]).cast<double>() - x).norm();
            const double extension = length - static_cast<double>(model.rest_lengths[e]);
            const double k = static_cast<double>(stiffness[e]);
            const double bending =
                static_cast<double>(fabric.bending) * static_cast<double>(model.bending[e]);
            energy.elastic += (k * extension * extension + bending * length * length) / 2;
        }
    }
    return energy;
}

namespace {

double sum_of_squared_speeds(const Cloth& cloth) {
    double sum = 0;
    for (const Vec4& v : cloth.state.velocities.span()) sum += xyz(v).cast<double>().squaredNorm();
    return sum;
}

/// Collects the figures of a Swing, frame by frame.
class SwingWatch {
  public:
    SwingWatch(const Cloth& cloth, const Vec3& gravity, int frames)
        : gravity_(gravity), first_(frames / 2), start_(energy_of(cloth, gravity).total()) {}

    void see(const Cloth& cloth, int frame) {
        if (frame <= first_) return;
        squares_ += sum_of_squared_speeds(cloth);
        count_ += static_cast<double>(cloth.state.size());
    }
    [[nodiscard]] Swing result(const Cloth& cloth) const {
        return {energy_of(cloth, gravity_).total() - start_, std::sqrt(squares_ / count_)};
    }

  private:
    Vec3 gravity_;
    int first_;
    double start_, squares_ = 0, count_ = 0;
};

int frames_in(double seconds, int hz) {
    return static_cast<int>(std::lround(seconds * hz));
}

}  // namespace

StudyScene swinging_sheet(std::uint32_t per_side) {
    StudyScene scene = hung_sheet(per_side, false);
    scene.name = "swing";
    scene.cloth.air_damping = 0;
    scene.pins.clear();
    for (std::uint32_t i = 0; i < per_side; ++i) scene.pins.push_back(i);
    return scene;
}

Swing swing(StudyScene scene, const MethodPoint& point, int hz, double seconds, int threads) {
    scene.frame = 1.0f / static_cast<float>(hz);
    Run run(scene, point, threads);
    const int frames = frames_in(seconds, hz);
    SwingWatch watch(run.cloth(), scene.world.gravity, frames);
    for (int frame = 1; frame <= frames; ++frame) {
        run.step();
        watch.see(run.cloth(), frame);
    }
    return watch.result(run.cloth());
}

// The truth's states are put into a cloth, so that both are measured alike.
Swing true_swing(StudyScene scene, int hz, double seconds, int threads) {
    scene.frame = 1.0f / static_cast<float>(hz);
    FineTime fine(scene, threads);
    MethodPoint none;
    none.configure = [](ClothSettings&) {};
    Run holder(scene, none, 1);
    const int frames = frames_in(seconds, hz), substeps = FineTime::safe_substeps(scene);
    SwingWatch watch(holder.cloth(), scene.world.gravity, frames);
    const auto show = [&] {
        const Positions x = fine.positions(), v = fine.velocities();
        StudyScene there = scene;
        there.start_positions.clear();
        there.start_velocities.clear();
        for (std::size_t i = 0; i < x.size(); ++i) {
            there.start_positions.push_back(to_vec4(x[i].cast<float>(), 0));
            there.start_velocities.push_back(to_vec4(v[i].cast<float>(), 0));
        }
        holder.restart(there);
    };
    for (int frame = 1; frame <= frames; ++frame) {
        fine.step(substeps);
        show();
        watch.see(holder.cloth(), frame);
    }
    return watch.result(holder.cloth());
}

double energy_lost(const StudyScene& scene, const Swing& swing) {
    constexpr double half_length = 0.5;  // [m]
    const double gravity = to_vector(scene.world.gravity).cast<double>().norm();
    const double mass = static_cast<double>(scene.cloth.fabric.areal_density);  // of 1 m^2
    return -swing.energy / (mass * gravity * half_length);
}

double time_to_rest(std::span<const double> speeds, double frame, double limit) {
    std::size_t moving = speeds.size();
    while (moving > 0 && speeds[moving - 1] < limit) --moving;
    if (moving == speeds.size()) return std::numeric_limits<double>::infinity();
    return static_cast<double>(moving + 1) * frame;
}

std::vector<double> peak_speeds(const StudyScene& scene, const MethodPoint& point, double seconds,
                                int threads) {
    Run run(scene, point, threads);
    std::vector<double> speeds;
    const int frames = static_cast<int>(std::lround(seconds / static_cast<double>(scene.frame)));
    for (int frame = 0; frame < frames; ++frame) {
        run.step();
        speeds.push_back(static_cast<double>(run.report().peak_speed));
    }
    return speeds;
}

}  // namespace weft::study
