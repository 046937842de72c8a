// A sheet that is drawn apart at both ends, with a nick in its upper border: it tears from there, and falls.

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "demo/cutting/cut_scene.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"
#include "demo/scenes/solids.h"

namespace weft::demo {
namespace {

constexpr float sheet_width = 1.6f, sheet_height = 1.0f;  // [m]
constexpr float top = 1.5f;                               // height of the sheet's upper border [m]
constexpr float pull_speed = 0.12f;                       // of each end [m/s]
constexpr float farthest = 0.4f;                          // distance that each end moves [m]
constexpr double begins = 0.5;                            // time at which the ends start to move [s]
constexpr float irregular = 0.5f;  // spread of vertices about the grid, over its spacing
constexpr float nick = 0.06f;      // depth, over the sheet's height
constexpr Tearing tearing{.strain = 0.12f, .edges = 3};

class Tear final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.velocity = {0.4f, 0, 1.2f}, .gust = 0.5f}};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const Mesh grid = sheet_of(options.particles_or(1500), {-0.5f * sheet_width, top, 0},
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
        const double end = time + static_cast<double>(dt) - begins;
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
