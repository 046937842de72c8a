// The time of each call of a World.

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include "tests/bench/frames.h"
#include "tests/bench/stopwatch.h"
#include "weft/weft.h"

namespace weft::bench {

namespace {

constexpr float step_length = 1.0f / 60;

template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(result).value();
}
void must(const Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().message);
}

/// A sheet by two corners over a ball, by the default method, that has moved for half a second.
struct Host {
    Mesh mesh;
    World world;
    ClothId cloth;
    ColliderId ball;
    std::vector<std::uint32_t> row;  // vertices of the upper border
    std::vector<Vec3> places;        // where these are
    std::vector<Vec4> vertices;      // as a renderer wants them

    explicit Host(std::uint32_t side)
        : mesh(must(make_sheet({.rows = side, .columns = side}))),
          world(must(World::create({.threads = 1}))) {
        cloth = must(world.add_cloth(mesh));
        for (std::uint32_t vertex = 0; vertex < side; ++vertex) {
            row.push_back(vertex);
            places.push_back(mesh.positions[vertex]);
        }
        must(world.pin(cloth, 0));
        must(world.pin(cloth, side - 1));
        ball = must(world.add_collider(ball_at(0)));
        for (int frame = 0; frame < 30; ++frame) world.step(step_length);
    }
    /// For a kind of value of all vertices.
    [[nodiscard]] std::span<std::byte> room(std::size_t kind) {
        vertices.resize(2 * mesh.positions.size());
        const std::span<std::byte> bytes = std::as_writable_bytes(std::span(vertices));
        return bytes.subspan(kind * bytes.size() / 2, bytes.size() / 2);
    }
    void write(const VertexStreams& to) const { must(world.write_vertices(cloth, to)); }
    [[nodiscard]] static Collider ball_at(float x) { return {.shape = Sphere{{x, -0.4f, 0.3f}, 0.2f}}; }
};

struct Row {
    const char* name;
    std::function<void(Host&)> call;
    std::function<void(Host&)> after = [](Host&) {};  ///< not timed
};

/// Median, in microseconds of the thread's own time.
double cost_of(const Row& row, Host& host) {
    std::vector<double> seconds;
    double sum = 0;
    while (seconds.size() < 5 || (sum < 0.2 && seconds.size() < 200)) {
        seconds.push_back(seconds_of(1, [&] { row.call(host); }));
        sum += seconds.back();
        row.after(host);
    }
    std::ranges::sort(seconds);
    return 1e6 * seconds[seconds.size() / 2];
}

void set_method(Host& host, const Method& method) {
    ClothSettings settings = must(host.world.cloth_settings(host.cloth));
    settings.method = method;
    must(host.world.set_cloth_settings(host.cloth, settings));
}

std::vector<Row> rows_of_a_frame() {
    return {
        {"step", [](Host& h) { h.world.step(step_length); }},
        {"cloth", [](Host& h) { (void)h.world.cloth(h.cloth); }},
        {"write_vertices (positions, normals)",
         [](Host& h) { h.write({.positions = {h.room(0)}, .normals = {h.room(1)}}); }},
        {"write_vertices (previous normals)", [](Host& h) { h.write({.previous_normals = {h.room(0)}}); }},
        {"write_vertices (tangents)", [](Host& h) { h.write({.tangents = {h.room(0)}}); }},
        {"move_pin", [](Host& h) { must(h.world.move_pin(h.cloth, 0, h.places[0])); }},
        {"move_collider", [](Host& h) { must(h.world.move_collider(h.ball, Host::ball_at(0.01f))); },
         [](Host& h) { must(h.world.place_collider(h.ball, Host::ball_at(0))); }},
        {"place_collider", [](Host& h) { must(h.world.place_collider(h.ball, Host::ball_at(0))); }},
        {"set_settings (another wind)",
         [](Host& h) {
             WorldSettings settings = h.world.settings();
             settings.wind.velocity.x += 0.1f;
             must(h.world.set_settings(settings));
         }},
        {"set_cloth_settings (another stiffness)",
         [](Host& h) {
             ClothSettings settings = must(h.world.cloth_settings(h.cloth));
             settings.fabric.warp *= 1.01f;
             must(h.world.set_cloth_settings(h.cloth, settings));
         }},
        {"set_enabled", [](Host& h) { must(h.world.set_enabled(h.cloth, false)); },
         [](Host& h) { must(h.world.set_enabled(h.cloth, true)); }},
        {"move_cloth", [](Host& h) { must(h.world.move_cloth(h.cloth, {})); }},
        {"state_hash", [](Host& h) { (void)h.world.state_hash(); }},
        {"save",
         [](Host& h) {
             static std::vector<std::byte> saved;
             saved.resize(h.world.save_size());
             must(h.world.save(saved));
         }},
        {"restore",
         [](Host& h) {
             static std::vector<std::byte> saved;
             if (saved.size() != h.world.save_size()) {
                 saved.resize(h.world.save_size());
                 must(h.world.save(saved));
             }
             must(h.world.restore(saved));
         }},
        {"begin_step and end_step",
         [](Host& h) {
             must(h.world.begin_step(step_length));
             must(h.world.end_step());
         }},
        {"describe", [](Host& h) { (void)h.world.describe(); }},
    };
}

std::vector<Row> rows_of_a_change() {
    return {
        {"pin (a border)", [](Host& h) { must(h.world.pin(h.cloth, h.row)); },
         [](Host& h) { must(h.world.unpin(h.cloth, h.row)); }},
        {"set_map (mass)",
         [](Host& h) {
             must(h.world.set_map(h.cloth, Map::mass, std::vector<float>(h.mesh.positions.size(), 1.5f)));
         },
         [](Host& h) { must(h.world.set_map(h.cloth, Map::mass, {})); }},
        {"set_cloth_settings (contact on)",
         [](Host& h) {
             ClothSettings settings = must(h.world.cloth_settings(h.cloth));
             settings.self_collision = {.method = SelfCollisionMethod::contact};
             must(h.world.set_cloth_settings(h.cloth, settings));
         },
         [](Host& h) {
             ClothSettings settings = must(h.world.cloth_settings(h.cloth));
             settings.self_collision = {};
             must(h.world.set_cloth_settings(h.cloth, settings));
         }},
        {"set_cloth_settings (to Jacobi)", [](Host& h) { set_method(h, Jacobi{}); },
         [](Host& h) { set_method(h, Multilevel{}); }},
        {"set_cloth_settings (to Multilevel)", [](Host& h) { set_method(h, Multilevel{}); },
         [](Host& h) { set_method(h, Jacobi{}); }},
        {"CookedCloth::create", [](Host& h) { (void)must(CookedCloth::create(h.mesh)); }},
        {"add_cloth (a cooked one)",
         [](Host& h) {
             static std::vector<std::pair<std::size_t, CookedCloth>> cooked;
             const std::size_t size = h.mesh.positions.size();
             if (cooked.empty() || cooked.back().first != size)
                 cooked.emplace_back(size, must(CookedCloth::create(h.mesh)));
             must(h.world.remove_cloth(must(h.world.add_cloth(cooked.back().second))));
         }},
        {"add_cloth (a mesh)", [](Host& h) { must(h.world.remove_cloth(must(h.world.add_cloth(h.mesh)))); }},
    };
}

}  // namespace

void print_calls() {
    std::printf("%-40s%12s%12s\n", "microseconds; a sheet of", "1024", "16384");
    for (const auto& rows : {rows_of_a_frame(), rows_of_a_change()}) {
        for (const Row& row : rows) {
            std::printf("%-40s", row.name);
            for (const std::uint32_t side : {32u, 128u}) {
                Host host(side);
                row.call(host);  // what it makes once
                row.after(host);
                std::printf("%12.2f", cost_of(row, host));
                std::fflush(stdout);
            }
            std::printf("\n");
        }
        std::printf("\n");
    }
}

}  // namespace weft::bench
