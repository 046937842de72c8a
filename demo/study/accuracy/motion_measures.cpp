#include "demo/study/accuracy/motion_measures.h"

#include <cmath>
#include <limits>

#include "demo/study/reference/fine_time.h"
#include "demo/study/study_scenes.h"

namespace weft::study {

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
