// A dressed body in a host with its own animation: a skirt on hips and two legs that walk.

#include <weft/weft.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

template <class T>
T need(weft::Result<T> result) {
    if (!result) std::fprintf(stderr, "%s\n", result.error().message.c_str()), std::exit(1);
    if constexpr (!std::is_void_v<T>) return *std::move(result);
}

constexpr std::uint32_t rows = 30, columns = 60;  // vertices of the skirt, from the waist down and round it

weft::Vec3 on_ring(float radius, float height, std::uint32_t column) {
    const float angle = 6.2831853f * static_cast<float>(column) / columns;
    return {radius * std::sin(angle), height, radius * std::cos(angle)};
}

weft::Mesh make_skirt() {
    weft::Mesh skirt;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const float down = 0.55f * static_cast<float>(row) / (rows - 1);
        for (std::uint32_t column = 0; column < columns; ++column) {
            skirt.positions.push_back(on_ring(0.15f + 0.4f * down, 1.0f - down, column));
            if (row + 1 == rows) continue;
            const std::uint32_t a = row * columns + column, b = row * columns + (column + 1) % columns;
            skirt.triangles.push_back({a, a + columns, b});
            skirt.triangles.push_back({b, a + columns, b + columns});
        }
    }
    return skirt;
}

// The host's animation: capsules of hips and legs at a time [s]. A real host has a skeleton.
std::vector<weft::TaperedCapsule> body_at(float time) {
    const float swing = 0.45f * std::sin(5.7f * time), bob = 0.02f * std::cos(11.4f * time);
    std::vector<weft::TaperedCapsule> body{{{-0.04f, 0.95f + bob, 0}, {0.04f, 0.95f + bob, 0}, 0.11f, 0.11f}};
    const float hip = 0.9f + bob, foot = hip - 0.85f * std::cos(swing), ahead = 0.85f * std::sin(swing);
    body.push_back({{0.09f, hip, 0}, {0.09f, foot, ahead}, 0.08f, 0.04f});
    body.push_back({{-0.09f, hip, 0}, {-0.09f, foot, -ahead}, 0.08f, 0.04f});
    return body;
}

int main() {
    weft::World world = need(weft::World::create());
    weft::ClothSettings cloth;
    cloth.self_collision = {.method = weft::SelfCollisionMethod::contact};
    const weft::ClothId skirt = need(world.add_cloth(make_skirt(), cloth));
    std::vector<weft::ColliderId> limbs;
    for (const weft::TaperedCapsule& limb : body_at(0))
        limbs.push_back(need(world.add_collider({.shape = limb})));
    std::vector<std::uint32_t> waist(columns);
    std::vector<weft::Vec3> targets(columns);
    for (std::uint32_t column = 0; column < columns; ++column) waist[column] = column;
    need(world.pin(skirt, waist));

    for (int step = 1; step <= 300; ++step) {
        const std::vector<weft::TaperedCapsule> body = body_at(static_cast<float>(step) / 60);
        for (std::size_t i = 0; i < limbs.size(); ++i)
            need(world.move_collider(limbs[i], {.shape = body[i]}));
        for (std::uint32_t column = 0; column < columns; ++column)
            targets[column] = on_ring(0.15f, body[0].a.y + 0.05f, column);
        need(world.move_pins(skirt, waist, targets));
        world.step(1.0f / 60);  // then upload need(world.cloth(skirt)).positions
        const double hem = static_cast<double>(need(world.cloth(skirt)).bounds.lower.y);
        if (step % 60 == 0) std::printf("%d s: the hem is at %.2f m\n", step / 60, hem);
    }
    return weft::has(world.report().flags, weft::StepFlags::state_restored) ? 1 : 0;
}
