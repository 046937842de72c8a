// Cloth that hangs: a curtain on rings, and a sheet that is drawn apart till it tears.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "demo/cutting/cut_scene.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"
#include "demo/scenes/solids.h"

namespace weft::demo {

// A curtain in folds, hung from rings on a rod that are drawn to and fro, in a slow breeze.

namespace {

constexpr float curtain_width = 2.6f, curtain_height = 2.0f;  // of the fabric laid flat [m]
constexpr float curtain_top = 2.25f;                          // height of the fabric's upper edge [m]
constexpr std::uint32_t spans = 12;                           // between rings; a fold each
constexpr float steepest = 1.0f;                              // angle between fold and rod at a ring [rad]
constexpr float drawn_by = 0.35f;                             // the rings come nearer by this fraction ...
constexpr double period = 10.0;                               // ... and go back in this time [s]

constexpr float rod_height = curtain_top + 0.03f;  // [m]
constexpr std::uint32_t ring_sides = 18, tube_sides = 6;
constexpr float tube_radius = 0.003f;  // [m]

/// Triangles of `count` rings, whose vertices are in rows about their tubes.
std::vector<Triangle> ring_triangles(std::uint32_t count) {
    std::vector<Triangle> triangles;
    for (std::uint32_t ring = 0; ring < count; ++ring)
        for (std::uint32_t i = 0; i < ring_sides; ++i)
            for (std::uint32_t k = 0; k < tube_sides; ++k) {
                const auto at = [&](std::uint32_t side, std::uint32_t about) {
                    return (ring * ring_sides + side % ring_sides) * tube_sides + about % tube_sides;
                };
                triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
                triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
            }
    return triangles;
}

/// Appends a ring round the rod and through a point of the curtain.
void append_ring(const Vec3& through, std::vector<Vec3>& vertices) {
    const float radius = std::hypot(through.y - rod_height, through.z);
    for (std::uint32_t i = 0; i < ring_sides; ++i) {
        const float around = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / ring_sides;
        for (std::uint32_t k = 0; k < tube_sides; ++k) {
            const float about = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / tube_sides;
            const float out = radius + tube_radius * std::cos(about);
            vertices.push_back({through.x + tube_radius * std::sin(about),
                                rod_height + out * std::cos(around), out * std::sin(around)});
        }
    }
}

/// Points of the folded top edge, evenly spaced along the fabric. The angle to the rod swings as the cosine
/// of the arc length, which is the curve that a bent strip takes (the sine-generated curve of Langbein and
/// Leopold 1966).
std::vector<Vector3> folded_edge(std::uint32_t columns) {
    const float spacing = curtain_width / static_cast<float>(columns - 1);
    std::vector<Vector3> edge(columns, Vector3::Zero());
    for (std::uint32_t c = 1; c < columns; ++c) {
        const float halfway = (static_cast<float>(c) - 0.5f) / static_cast<float>(columns - 1);
        const float angle =
            steepest * std::cos(std::numbers::pi_v<float> * static_cast<float>(spans) * halfway);
        edge[c] = edge[c - 1] + spacing * Vector3(std::cos(angle), 0, std::sin(angle));
    }
    const float middle = 0.5f * edge.back().x();
    for (Vector3& point : edge) point += Vector3(-middle, curtain_top, 0);
    return edge;
}

class Curtain final : public OneCloth {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.velocity = {0.15f, 0, 0.6f}, .gust = 0.6f}};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        make_mesh(options.particles_or(3000));

        ClothSettings settings;
        settings.self_collision.method = SelfCollisionMethod::contact;
        SceneContent content =
            add_cloth(world, settings, two_sided({0.10f, 0.22f, 0.42f}, 0.13f),
                      {.target = {0, 1.22f, 0}, .distance = 3.9f, .yaw = 0.35f, .pitch = 0.08f});
        for (std::uint32_t ring = 0; ring <= spans; ++ring) must(world.pin(cloth_, ring_vertex(ring)));

        const float reach = 0.5f * curtain_width + 0.05f;
        const auto rod = must(
            world.add_collider({.shape = Capsule{{-reach, rod_height, 0}, {reach, rod_height, 0}, 0.015f}}));

        content.drawn_colliders = {rod};
        place_rings(0);
        content.solids.push_back({.mesh = {.positions = *rings_, .triangles = ring_triangles(spans + 1)},
                                  .colour = {0.55f, 0.42f, 0.18f},
                                  .place = [rings = rings_](std::span<Vec3> to, SolidMoment) {
                                      std::ranges::copy(*rings, to.begin());
                                  }});
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        time_ = time + static_cast<double>(dt);
        for (std::uint32_t ring = 0; ring <= spans; ++ring)
            (void)world.move_pin(cloth_, ring_vertex(ring), ring_place(ring, time_));
        place_rings(time_);
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        for (std::uint32_t ring = 0; ring <= spans; ++ring)
            checks.pinned_at(view, ring_vertex(ring), ring_place(ring, time_));
        checks.stretch(mesh_, view, 1.2f, 1.01f);

        float hem = 0;
        for (const std::uint32_t vertex : row_of(mesh_, mesh_.rows - 1))
            hem += vertex_position(view, vertex).y() / static_cast<float>(mesh_.columns);
        checks.at_least("the hem's mean height [m]", hem, curtain_top - 1.06f * curtain_height);
        checks.at_most("the hem's mean height [m]", hem, curtain_top - 0.92f * curtain_height);
        return checks.result();
    }

  private:
    void make_mesh(std::uint32_t particles) {
        mesh_ = sheet_of(particles, {0, curtain_height, 0}, {curtain_width, 0, 0}, {0, -curtain_height, 0});
        const std::vector<Vector3> edge = folded_edge(mesh_.columns);
        for (std::uint32_t vertex = 0; vertex < mesh_.positions.size(); ++vertex) {
            const Vec3 flat = mesh_.positions[vertex];
            mesh_.pattern.push_back({flat.x, flat.y});
            mesh_.positions[vertex] =
                to_vec3(edge[vertex % mesh_.columns] - Vector3(0, curtain_height - flat.y, 0));
        }
    }

    [[nodiscard]] std::uint32_t ring_vertex(std::uint32_t ring) const {
        return (ring * (mesh_.columns - 1) + spans / 2) / spans;  // rounded to the nearest column
    }

    /// Place of a ring [m]. The rings slide towards the first, and back.
    [[nodiscard]] Vec3 ring_place(std::uint32_t ring, double time) const {
        const double phase = 2 * std::numbers::pi * time / period;
        const float scale = 1.0f - drawn_by * static_cast<float>(0.5 - 0.5 * std::cos(phase));
        const float first = mesh_.positions[0].x;
        Vec3 place = mesh_.positions[ring_vertex(ring)];
        place.x = first + scale * (place.x - first);
        return place;
    }

    void place_rings(double time) {
        rings_->clear();
        for (std::uint32_t ring = 0; ring <= spans; ++ring) append_ring(ring_place(ring, time), *rings_);
    }

    double time_ = 0;
    std::shared_ptr<std::vector<Vec3>> rings_ = std::make_shared<std::vector<Vec3>>();
};

}  // namespace

std::unique_ptr<Scene> make_curtain_scene() {
    return std::make_unique<Curtain>();
}

// A sheet that is drawn apart at both ends, with a nick in its upper border: it tears from there, and falls.

namespace {

constexpr float sheet_width = 1.6f, sheet_height = 1.0f;  // [m]
constexpr float upper_border = 1.5f;                      // height of the sheet's upper border [m]
constexpr float pull_speed = 0.12f;                       // of each end [m/s]
constexpr float farthest = 0.4f;                          // distance that each end moves [m]
constexpr double pull_begins = 0.5;                       // time at which the ends start to move [s]
constexpr float irregular = 0.5f;  // spread of vertices about the grid, over its spacing
constexpr float nick = 0.06f;      // depth, over the sheet's height
constexpr Tearing tearing{.strain = 0.12f, .edges = 3};

class Tear final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.velocity = {0.4f, 0, 1.2f}, .gust = 0.5f}};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const Mesh grid = sheet_of(options.particles_or(1500), {-0.5f * sheet_width, upper_border, 0},
                                   {sheet_width, 0, 0}, {0, -sheet_height, 0});
        whole_ = scattered(grid);

        ClothSettings settings;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        cloth_ = must(world.add_cloth(whole_, settings));
        left_ = column_of(grid, 0);
        right_ = column_of(grid, grid.columns - 1);
        for (const auto* end : {&left_, &right_}) must(world.pin(cloth_, *end));
        must(world.add_collider({.shape = Plane{}, .friction = 0.6f}));

        SceneContent content;
        content.cloths.push_back({cloth_, whole_, two_sided({0.55f, 0.14f, 0.12f})});
        content.camera = {.target = {0, 0.95f, 0}, .distance = 3.3f, .yaw = 0.3f, .pitch = 0.1f};
        must(cut_cloth(world, content.cloths[0], nick_of(grid)));
        triangles_ = whole_.triangles.size();
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        const double end = time + static_cast<double>(dt) - pull_begins;
        const float way = std::min(farthest, pull_speed * static_cast<float>(std::max(0.0, end)));
        for (const auto& [vertices, side] : {std::pair(&left_, -1.0f), std::pair(&right_, 1.0f)}) {
            std::vector<Vec3> to;
            for (const std::uint32_t v : *vertices) {
                const Vec3& from = whole_.positions[v];
                to.push_back({from.x + side * way, from.y, from.z});
            }
            (void)world.move_pins(cloth_, *vertices, to);
        }
    }

    bool cut_before_step(World& world, SceneContent& content) override {
        const auto torn = tear_cloth(world, content.cloths[0], tearing);
        return torn && *torn;
    }

    void annotate(const World& world, Annotation& to) const override {
        for (const auto* end : {&left_, &right_})
            draw_holder(world.cloth(cloth_).value(), *end, Holder::rod, to);
    }

    [[nodiscard]] int check_steps() const override { return 420; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        const ClothInfo info = world.cloth_info(cloth_).value();
        checks.at_least("parts", static_cast<float>(info.components), 2);
        checks.at_most("parts: it tears, and does not crumble", static_cast<float>(info.components), 40);
        checks.at_least("triangles", static_cast<float>(info.triangles), static_cast<float>(triangles_));
        checks.at_most("crossings", static_cast<float>(world.report().crossings), 0);
        std::vector<StrainedEdge> worst(1);
        const auto count = must(world.strained_edges(cloth_, tearing.strain, worst));
        if (count > 0) checks.at_most("the worst strain left", worst[0].strain, 4 * tearing.strain);
        checks.at_least("the sheet's width, once torn [m]", view.bounds.upper.x - view.bounds.lower.x,
                        sheet_width + 2 * farthest - 0.01f);
        return checks.result();
    }

  private:
    /// The mesh with inner vertices moved off the grid. Tears follow edges, and would look cut along rows.
    static Mesh scattered(Mesh mesh) {
        std::mt19937 random(11);
        const auto draw = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f - 0.5f; };
        const float dx = irregular * sheet_width / static_cast<float>(mesh.columns - 1),
                    dy = irregular * sheet_height / static_cast<float>(mesh.rows - 1);
        for (std::uint32_t row = 1; row + 1 < mesh.rows; ++row)
            for (std::uint32_t column = 1; column + 1 < mesh.columns; ++column) {
                Vec3& p = mesh.positions[row * mesh.columns + column];
                p.x += dx * draw();
                p.y += dy * draw();
            }
        mesh.rows = mesh.columns = 0;
        return mesh;
    }
    /// The edges of the nick, down from the middle of the upper border.
    static std::vector<MeshEdge> nick_of(const Mesh& grid) {
        std::vector<MeshEdge> edges;
        const auto deep = std::max(1.0f, nick * static_cast<float>(grid.rows));
        const std::uint32_t column = grid.columns / 2;
        for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(deep); ++row)
            edges.push_back({row * grid.columns + column, (row + 1) * grid.columns + column});
        return edges;
    }

    ClothId cloth_;
    Mesh whole_;
    std::size_t triangles_ = 0;
    std::vector<std::uint32_t> left_, right_;
};

}  // namespace

std::unique_ptr<Scene> make_tear_scene() {
    return std::make_unique<Tear>();
}

}  // namespace weft::demo
