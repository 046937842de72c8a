// The cloth of the page, with the functions that page.js calls: a flag on a mast, and a ball that the mouse
// drags through it.

#include <weft/weft.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace {

struct Vertex {
    float position[3], normal[3];
};

struct Page {
    std::optional<weft::World> world;
    weft::ClothId flag{};
    weft::ColliderId ball{};
    weft::FixedStep clock =
        weft::FixedStep::create({.max_steps_per_frame = 2}).value();  // motion slows down on a slower machine
    std::vector<Vertex> vertices;
    std::string error;

    bool fails(const weft::Error& why) {
        error = why.message;
        return false;
    }
    template <class T>
    bool takes(const weft::Result<T>& result) {
        return result || fails(result.error());
    }
};
Page page;

weft::Collider ball_at(float x, float y, float z) {
    return {.shape = weft::Sphere{.center = {x, y, z}, .radius = 0.15f}, .friction = 0.3f};
}

bool make_world(std::uint32_t rows, std::uint32_t columns, weft::ClothSettings cloth) {
    auto world = weft::World::create({.threads = 1});
    if (!page.takes(world)) return false;
    const auto sheet = weft::make_sheet(
        {.rows = rows, .columns = columns, .origin = {-0.75f, 0.5f, 0}, .u = {1.5f, 0, 0}, .v = {0, -1, 0}});
    if (!page.takes(sheet)) return false;
    cloth.self_collision = {.method = weft::SelfCollisionMethod::contact};
    const auto flag = world->add_cloth(*sheet, cloth);
    if (!page.takes(flag)) return false;
    std::vector<std::uint32_t> hoist;
    for (std::uint32_t row = 0; row < rows; ++row) hoist.push_back(row * columns);
    if (!page.takes(world->pin(*flag, hoist))) return false;
    const auto ball = world->add_collider(ball_at(0, -5, 0));
    if (!page.takes(ball)) return false;
    page.world.emplace(std::move(world).value());
    page.flag = *flag;
    page.ball = *ball;
    page.clock.reset();
    page.vertices.resize(std::size_t{rows} * columns);
    return true;
}

bool write_vertices() {
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(page.vertices));
    weft::VertexStreams streams;
    streams.positions = {bytes, sizeof(Vertex)};
    streams.normals = {bytes.subspan(offsetof(Vertex, normal)), sizeof(Vertex)};
    return page.takes(page.world->write_vertices(page.flag, streams));
}

}  // namespace

#define EXPORTED(name) __attribute__((export_name(#name)))

extern "C" {

/// Makes the World. 1: success; 0: error() says why not.
EXPORTED(make) int make(std::uint32_t rows, std::uint32_t columns, std::uint32_t fabric) {
    const std::span<const weft::NamedFabric> fabrics = weft::fabrics();
    weft::ClothSettings cloth;
    cloth.fabric = fabrics[fabric < fabrics.size() ? fabric : 0].fabric;
    return make_world(rows, columns, cloth) && write_vertices();
}
EXPORTED(fabric_name) const char* fabric_name(std::uint32_t number) {
    const std::span<const weft::NamedFabric> fabrics = weft::fabrics();
    return number < fabrics.size() ? fabrics[number].name : "";
}
EXPORTED(error) const char* error() {
    return page.error.c_str();
}

EXPORTED(set_wind) int set_wind(float x, float y, float z, float gust) {
    weft::WorldSettings settings = page.world->settings();
    settings.wind.velocity = {x, y, z};
    settings.wind.gust = gust;
    return page.takes(page.world->set_settings(settings));
}
/// Moves the ball over the next step.
EXPORTED(move_ball) int move_ball(float x, float y, float z) {
    return page.takes(page.world->move_collider(page.ball, ball_at(x, y, z)));
}
EXPORTED(place_ball) int place_ball(float x, float y, float z) {
    return page.takes(page.world->place_collider(page.ball, ball_at(x, y, z)));
}

/// Takes the steps of `seconds`, writes the vertices, and returns the number of steps.
EXPORTED(advance) int advance(double seconds) {
    const weft::FixedStepFrame frame = page.clock.advance(seconds);
    for (int i = 0; i < frame.steps; ++i) page.world->step(static_cast<float>(page.clock.settings().step));
    write_vertices();
    return frame.steps;
}

/// Six floats each: position and normal.
EXPORTED(vertices) const Vertex* vertices() {
    return page.vertices.data();
}
EXPORTED(vertex_count) std::uint32_t vertex_count() {
    return static_cast<std::uint32_t>(page.vertices.size());
}
EXPORTED(triangles) const weft::Triangle* triangles() {
    return page.world->cloth(page.flag)->vertex_triangles.data();
}
EXPORTED(triangle_count) std::uint32_t triangle_count() {
    return static_cast<std::uint32_t>(page.world->cloth(page.flag)->vertex_triangles.size());
}

EXPORTED(milliseconds) float milliseconds() {
    return page.world->report().milliseconds;
}
EXPORTED(crossings) std::uint32_t crossings() {
    return page.world->report().crossings;
}
}
