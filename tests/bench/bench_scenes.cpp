#include "tests/bench/bench_scenes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

namespace weft::bench {

namespace {

constexpr int warm_up_frames = 45;

template <class T>
T need(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(result).value();
}

bool is_garment(SceneKind kind) {
    return kind == SceneKind::garment || kind == SceneKind::dress;
}

std::filesystem::path garment_file(SceneKind kind) {
    const char* const data = std::getenv("WEFT_DATA");
    if (data == nullptr) return {};
    const char* const name = kind == SceneKind::dress ? "dress-victor-iso-draped.obj" : "tshirt-iso.obj";
    return std::filesystem::path(data) / "garments" / name;
}

Mesh sheet(std::uint32_t side, float height) {
    return need(make_sheet({.rows = side, .columns = side, .origin = {-0.5f, height, -0.5f}}));
}

/// Garment files are +Z up.
Mesh upright_garment(SceneKind kind) {
    Mesh mesh = need(load_obj(garment_file(kind)));
    for (Vec3& p : mesh.positions) p = {p.x, p.z, -p.y};
    return mesh;
}

void pin_highest(Cloth& cloth) {
    const auto positions = std::as_const(cloth.state.positions).span();
    const float top = std::ranges::max(positions, {}, &Vec4::y).y;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        if (positions[i].y > top - 0.02f) cloth.pin(i);
}

}  // namespace

const char* name_of(SceneKind kind) {
    switch (kind) {
        case SceneKind::hanging:
            return "hanging";
        case SceneKind::hanging_self:
            return "hanging-self";
        case SceneKind::draped:
            return "draped";
        case SceneKind::dress:
            return "dress";
        case SceneKind::garment:
            break;
    }
    return "garment";
}

bool has_garment(SceneKind kind) {
    return std::filesystem::exists(garment_file(kind));
}

namespace {

WorldSettings world_of(int threads, bool air) {
    WorldSettings world;
    world.threads = threads;
    if (!air) world.wind.air_density = 0;
    return world;
}

}  // namespace

Scene::Scene(SceneKind kind, std::uint32_t side, int threads, const ClothSettings& given, bool air)
    : Scene(kind, side, world_of(threads, air), given) {}

Scene::Scene(SceneKind kind, std::uint32_t side, const WorldSettings& world, const ClothSettings& given,
             bool as_mesh)
    : simulation_(std::make_unique<Simulation>(world)) {
    ClothSettings settings = given;
    if (kind != SceneKind::hanging) settings.self_collision = {.method = SelfCollisionMethod::avoidance};
    if (!is_garment(kind)) settings.self_collision.distance = 0.8f / static_cast<float>(side - 1);
    Mesh mesh = is_garment(kind) ? upright_garment(kind) : sheet(side, kind == SceneKind::draped ? 0.32f : 0);
    if (as_mesh) mesh.rows = mesh.columns = 0;
    auto made = std::make_unique<Cloth>(need(cook(mesh)), settings);
    cloth_ = made.get();
    simulation_->prepare(*made);
    simulation_->add(std::move(made));
    const auto add = [&](const Collider& collider) {
        simulation_->state.colliders.insert({collider, collider});
        simulation_->expect_colliders(simulation_->state.colliders.size());
    };
    if (kind == SceneKind::draped) add({.shape = Sphere{{0, 0, 0}, 0.3f}, .friction = 1});
    if (is_garment(kind)) {
        pin_highest(*cloth_);
        const Vector3 middle = 0.5f * (to_vector(cloth_->extent.lower) + to_vector(cloth_->extent.upper));
        const auto at = [&](float y) { return Vec3{middle.x(), middle.y() + y, middle.z()}; };
        add({.shape = Capsule{at(-0.2f), at(0.1f), 0.08f}, .friction = 0.4f});
    }
    if (kind == SceneKind::hanging || kind == SceneKind::hanging_self) {
        cloth_->pin(0);
        cloth_->pin(side - 1);
    }
    for (int i = 0; i < warm_up_frames; ++i) frame();
}

StepEquation Scene::equation() const {
    const ClothState& state = cloth_->state;
    constexpr float h = 1.0f / 60.0f;
    return {.settings = cloth_->settings,
            .h = h,
            .gamma = h,
            .rigidity = cloth_->settings.fabric.bending,
            .positions = state.positions.span(),
            .velocities = state.velocities.span(),
            .base_positions = state.positions.span(),
            .base_velocities = state.velocities.span(),
            .external = {.gravity = to_vector(simulation_->settings.gravity),
                         .air_damping = cloth_->settings.air_damping,
                         .air = std::as_const(cloth_->air.forces).span()}};
}

Scene& cached_scene(const std::string& name, const std::function<Scene()>& make) {
    static std::string kept;
    static std::optional<Scene> scene;
    if (kept != name) {
        scene.reset();  // first, so that two large ones need not fit
        scene.emplace(make());
        kept = name;
    }
    return *scene;
}

}  // namespace weft::bench
