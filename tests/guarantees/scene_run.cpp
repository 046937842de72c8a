#include "tests/guarantees/scene_run.h"

#include <cstdlib>
#include <stdexcept>

namespace weft::demo {

namespace {

constexpr float dt = 1.0f / 60.0f;

constexpr std::uint32_t particles = WEFT_GUARANTEE_PARTICLES;

std::filesystem::path garment() {
    const char* const data = std::getenv("WEFT_DATA");
    return data ? std::filesystem::path(data) / "garments" / "tshirt-iso.obj" : std::filesystem::path();
}

// A test that cannot build its scene has failed, and an exception is how GoogleTest hears of it from here.
template <class T>
T need(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

WorldSettings settings_of(const Scene& scene, int threads, const Executor& executor) {
    WorldSettings settings = scene.world_settings();
    settings.threads = threads;
    settings.executor = executor;
    return settings;
}

}  // namespace

void PrintTo(const SceneEntry& entry, std::ostream* out) {
    *out << entry.name;
}

std::string cannot_run(const SceneEntry& entry) {
    if (!entry.needs_garment || std::filesystem::exists(garment())) return {};
    return "set WEFT_DATA to a folder that holds garments/tshirt-iso.obj to run the scene " +
           std::string(entry.name);
}

SceneRun::SceneRun(const SceneEntry& entry, int threads, const Executor& executor)
    : scene_(entry.make()), world_(need(World::create(settings_of(*scene_, threads, executor)))) {
    const SceneOptions options{.particles = particles,
                               .garment = entry.needs_garment ? garment() : std::filesystem::path()};
    need(scene_->build(world_, options));
}

void SceneRun::before_step() {
    scene_->before_step(world_, time_, dt);
    time_ += static_cast<double>(dt);
}

const StepReport& SceneRun::step() {
    return world_.step(dt);
}

}  // namespace weft::demo
