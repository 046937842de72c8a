#include "tests/guarantees/scene_run.h"

#include <cstdlib>
#include <stdexcept>

#include "demo/self_collision.h"

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

/// The stack of cloths.
class StackByZones final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override { return stack_->world_settings(); }
    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        auto content = stack_->build(world, options);
        if (!content) return content;
        for (const SceneCloth& cloth : content->cloths) {
            ClothSettings settings = need(world.cloth_settings(cloth.id));
            set_method(settings.self_collision, SelfCollisionMethod::impact_zones);
            settings.self_collision.restitution = 0.3f;
            if (auto set = world.set_cloth_settings(cloth.id, settings); !set) return set.error();
        }
        return content;
    }
    void before_step(World& world, double time, float step) override {
        stack_->before_step(world, time, step);
    }
    [[nodiscard]] Result<void> check(const World& /*world*/) const override { return {}; }

  private:
    std::unique_ptr<Scene> stack_ = find_scene("stack")->make();
};

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

std::vector<SceneEntry> scenes_to_run() {
    std::vector<SceneEntry> scenes(all_scenes().begin(), all_scenes().end());
    scenes.push_back({"stack_zones", "The stack, by impact zones",
                      []() -> std::unique_ptr<Scene> { return std::make_unique<StackByZones>(); },
                      SceneGroup::lab});
    return scenes;
}

std::string cannot_run(const SceneEntry& entry) {
    if (!entry.needs_garment || std::filesystem::exists(garment())) return {};
    return "set WEFT_DATA to a folder that holds garments/tshirt-iso.obj to run the scene " +
           std::string(entry.name);
}

SceneRun::SceneRun(const SceneEntry& entry, int threads, const Executor& executor,
                   const RecordingSink* record)
    : scene_(entry.make()), world_(need(World::create(settings_of(*scene_, threads, executor)))) {
    if (record != nullptr)
        if (auto started = world_.start_recording(*record); !started)
            throw std::runtime_error(started.error().message);
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
