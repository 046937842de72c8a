#include "demo/scene_simulation.h"

#include <string>
#include <utility>

#include "demo/must.h"
#include "demo/options/method_table.h"

namespace weft::demo {

namespace {

Result<void> apply_to_cloths(World& world, const SceneContent& content, const Overrides& overrides) {
    for (const SceneCloth& cloth : content.cloths) {
        auto settings = world.cloth_settings(cloth.id);
        if (!settings) return settings.error();
        settings->method = overrides.method.value_or(settings->method);
        settings->fabric = overrides.fabric.value_or(settings->fabric);
        if (overrides.iterations) {
            if (!iterations_of(settings->method))
                return Error{ErrorCode::invalid_argument, "method " +
                                                              std::string(entry_of(settings->method).name) +
                                                              " does not iterate; leave --iterations out"};
            set_iterations(settings->method, *overrides.iterations);
        }
        if (overrides.contact) set_method(settings->self_collision, *overrides.contact);
        if (auto set = world.set_cloth_settings(cloth.id, *settings); !set) return set.error();
    }
    return {};
}

void replace(WorldSettings& settings, const Overrides& overrides) {
    settings.substeps = overrides.substeps.value_or(settings.substeps);
    settings.wind.velocity = overrides.wind.value_or(settings.wind.velocity);
}

/// Appends the positions of the vertices that are drawn.
void append_positions(const SceneCloth& cloth, const ClothView& view, std::vector<Vec3>& positions) {
    if (!cloth.drawn) {
        for (const std::uint32_t particle : view.vertex_to_particle)
            positions.push_back(
                {view.positions[particle].x, view.positions[particle].y, view.positions[particle].z});
        return;
    }
    std::vector<Vec4> drawn(cloth.drawn->size());
    cloth.drawn->update(view, {.positions = drawn});
    for (const Vec4& p : drawn) positions.push_back({p.x, p.y, p.z});
}

}  // namespace

Simulation::Simulation(const SceneEntry& entry, const SceneOptions& options, std::unique_ptr<Scene> scene,
                       World world)
    : entry_(&entry), options_(options), scene_(std::move(scene)), world_(std::move(world)) {}

Result<Simulation> Simulation::create(const SceneEntry& entry, const SceneOptions& options,
                                      const Overrides& overrides) {
    std::unique_ptr<Scene> scene = entry.make();
    WorldSettings settings = scene->world_settings();
    settings.threads = overrides.threads;
    replace(settings, overrides);
    auto world = World::create(settings);
    if (!world) return world.error();

    if (!overrides.record.empty())
        if (auto started = world->start_recording(overrides.record); !started) return started.error();

    Simulation simulation(entry, options, std::move(scene), std::move(*world));
    if (auto built = simulation.build(); !built) return built.error();
    if (auto set = apply_to_cloths(simulation.world_, simulation.content_, overrides); !set)
        return set.error();
    simulation.remember_defaults();
    return simulation;
}

Result<void> Simulation::apply(const Overrides& overrides) {
    WorldSettings settings = world_.settings();
    replace(settings, overrides);
    if (auto set = world_.set_settings(settings); !set) return set;
    return apply_to_cloths(world_, content_, overrides);
}

void Simulation::remember_defaults() {
    first_settings_ = world_.settings();
    first_cloths_.clear();
    for (const SceneCloth& cloth : content_.cloths) first_cloths_.push_back(*world_.cloth_settings(cloth.id));
}

Result<void> Simulation::restore_defaults() {
    if (auto set = world_.set_settings(first_settings_); !set) return set;
    for (std::size_t i = 0; i < content_.cloths.size(); ++i)
        if (auto set = world_.set_cloth_settings(content_.cloths[i].id, first_cloths_[i]); !set) return set;
    return {};
}

void Simulation::weave(const render::FabricLook& look) {
    for (SceneCloth& cloth : content_.cloths) {
        const render::FabricLook before = cloth.look;
        cloth.look = look;
        cloth.look.front = before.front;
        cloth.look.back = before.back;
        cloth.look.stripe = before.stripe;
        cloth.look.stripe_width = before.stripe_width;
    }
}

Result<void> Simulation::build() {
    return caught([&] {
        content_ = must(scene_->build(world_, options_));
        time_ = 0;
    });
}

Result<void> Simulation::restart() {
    auto world = World::create(world_.settings());
    if (!world) return world.error();
    Simulation fresh(*entry_, options_, entry_->make(), std::move(*world));
    if (auto built = fresh.build(); !built) return built.error();
    const std::size_t cloths = std::min(content_.cloths.size(), fresh.content_.cloths.size());
    for (std::size_t i = 0; i < cloths; ++i) {
        const auto settings = world_.cloth_settings(content_.cloths[i].id);
        if (!settings) return settings.error();
        if (auto set = fresh.world_.set_cloth_settings(fresh.content_.cloths[i].id, *settings); !set)
            return set.error();
    }
    for (std::size_t i = 0; i < cloths; ++i)
        for (PaintedMap& painted : content_.cloths[i].maps) {
            std::vector<float> values = painted.values;
            values.resize(
                fresh.content_.cloths[i].mesh.positions.size());  // cuts had added vertices at the end
            if (auto set = fresh.paint(i, painted.map, std::move(values)); !set) return set.error();
        }
    fresh.cuts_ = cuts_ + 1;  // the meshes are uncut again
    for (std::size_t i = 0; i < cloths; ++i) fresh.content_.cloths[i].look = content_.cloths[i].look;
    fresh.first_settings_ = first_settings_;
    fresh.first_cloths_ = first_cloths_;
    *this = std::move(fresh);
    return {};
}

Result<void> Simulation::cut(std::size_t cloth, std::span<const MeshEdge> edges) {
    const auto done = cut_cloth(world_, content_.cloths[cloth], edges);
    if (!done) return done.error();
    if (*done) ++cuts_;
    return {};
}

Result<void> Simulation::paint(std::size_t cloth, Map map, std::vector<float> values) {
    SceneCloth& painted = content_.cloths[cloth];
    if (auto set = world_.set_map(painted.id, map, values); !set) return set;
    if (map == Map::leash || map == Map::backstop)
        if (auto given = scene_->give_skin(world_, painted.id); !given) {
            (void)world_.set_map(painted.id, map, {});
            return given;
        }
    std::erase_if(painted.maps, [&](const PaintedMap& each) { return each.map == map; });
    painted.maps.push_back({map, std::move(values)});
    return {};
}

void Simulation::before_step(float dt) {
    scene_->before_step(world_, time_, dt);
    if (scene_->cut_before_step(world_, content_)) ++cuts_;
    time_ += static_cast<double>(dt);
}

Mesh current_mesh(const World& world, const SceneContent& content) {
    Mesh all;
    for (const SceneCloth& cloth : content.cloths) {
        const auto view = world.cloth(cloth.id);
        if (!view) continue;
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        append_positions(cloth, *view, all.positions);
        const Mesh& mesh = cloth.drawn ? cloth.fine : cloth.mesh;
        for (const auto& [a, b, c] : mesh.triangles)
            all.triangles.push_back({first + a, first + b, first + c});
        const std::vector<Vec2>& flat = mesh.pattern.empty() ? mesh.texcoords : mesh.pattern;
        all.texcoords.insert(all.texcoords.end(), flat.begin(), flat.end());
    }
    // A scene of which only some cloths have texture coordinates has none.
    if (all.texcoords.size() != all.positions.size()) all.texcoords.clear();
    return all;
}

}  // namespace weft::demo
