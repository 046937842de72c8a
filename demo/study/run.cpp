#include "demo/study/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>
#include <stdexcept>
#include <thread>
#include <utility>

#include "demo/character/garment/garment_mesh.h"
#include "demo/must.h"
#include "demo/study/study_options.h"

namespace weft::study {

namespace {

ClothModel cooked(const StudyScene& scene) {
    Result<ClothModel> result = cook(scene.mesh);
    if (!result) throw std::runtime_error(scene.name + ": " + result.error().message);
    return std::move(result).value();
}

WorldSettings with_threads(WorldSettings settings, int threads) {
    settings.threads = threads;
    return settings;
}

void place(const StudyScene& scene, ClothState& state) {
    for (std::size_t i = 0; i < scene.start_positions.size(); ++i) {
        const Vector3 x = xyz(scene.start_positions[i]);
        set_xyz(state.positions[i], x);
        set_xyz(state.previous_positions[i], x);
    }
    for (std::size_t i = 0; i < scene.start_velocities.size(); ++i)
        set_xyz(state.velocities[i], xyz(scene.start_velocities[i]));
}

double wall_time() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

double processor_time() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

int thread_count(int threads) {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return threads > 0 ? threads : std::clamp(cores, 1, 256);
}

Run::Run(const StudyScene& scene, const MethodPoint& point, int threads)
    : frame_(scene.frame), simulation_(with_threads(scene.world, thread_count(threads))) {
    auto made = std::make_unique<Cloth>(cooked(scene), point.applied_to(scene.cloth));
    cloth_ = made.get();
    if (point.make_solver) {
        cloth_->take_solver(point.make_solver(cloth_->model, cloth_->settings));
        cloth_->solver->inverse_masses_changed(std::as_const(cloth_->state).positions.span());
    }
    place(scene, cloth_->state);
    for (const std::uint32_t vertex : scene.pins) cloth_->pin(cloth_->model.vertex_to_particle[vertex]);
    simulation_.prepare(*cloth_);
    simulation_.add(std::move(made));
}

void Run::restart(const StudyScene& scene) {
    std::ranges::fill(cloth_->state.velocities.span(), Vec4{});
    place(scene, cloth_->state);
    cloth_->state.record.h = 0;
}

double Run::step() {
    const bool by_processor = simulation_.settings.threads == 1;
    const double start = by_processor ? processor_time() : wall_time();
    simulation_.step(frame_);
    const double milliseconds = (by_processor ? processor_time() : wall_time()) - start;
    restored_ += static_cast<int>(simulation_.report.restored_cloths);
    return milliseconds;
}

Positions positions_of(const Cloth& cloth) {
    Positions positions;
    for (const Vec4& x : cloth.state.positions.span()) positions.emplace_back(xyz(x).cast<double>());
    return positions;
}

double kappa(const Cloth& cloth, double frame) {
    const ClothInfo info = cloth.info();
    const double mass = static_cast<double>(info.mass) / info.particles;
    return static_cast<double>(cloth.settings.fabric.warp) * frame * frame / mass;
}

namespace {

/// Height of the bump [m], in double precision from the mesh's floats: machines differ by a last bit or so.
float bump(const Vec3& p) {
    const double x = static_cast<double>(p.x) + 0.5, z = static_cast<double>(p.z) + 0.5;
    const double pi = std::numbers::pi;
    const double waves = std::sin(2.3 * pi * x + 0.4) * std::sin(3.1 * pi * z + 0.9) +
                         0.5 * std::sin(5.7 * pi * (x + 0.6 * z) + 1.7);
    return static_cast<float>(1e-4 / 1.5 * waves);
}

}  // namespace

StudyScene hung_sheet(std::uint32_t per_side, bool wind) {
    StudyScene scene;
    scene.name = wind ? "wind" : "hanging";
    scene.per_side = per_side;
    scene.mesh = must(make_sheet({.rows = per_side, .columns = per_side}));
    for (const Vec3& p : scene.mesh.positions) scene.start_positions.push_back({p.x, p.y + bump(p), p.z, 0});
    scene.cloth.method = Jacobi{};
    if (wind)
        scene.world.wind.velocity = {1.0f, 0, 3.0f};
    else
        scene.world.wind.air_density = 0;
    scene.pins = {0, per_side - 1};
    return scene;
}

StudyScene hung_garment(const std::filesystem::path& obj, const std::string& name) {
    StudyScene scene;
    scene.name = name;
    scene.mesh = must(load_obj(obj, {.texcoords_are_pattern = true}));
    demo::drop_unfit_pattern(scene.mesh);
    demo::stand_upright(scene.mesh, 0.45f);
    scene.world.wind.air_density = 0;
    scene.pins = demo::highest_opening(scene.mesh);
    return scene;
}

}  // namespace weft::study
