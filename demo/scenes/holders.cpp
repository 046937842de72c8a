#include "demo/scenes/holders.h"

#include "demo/scenes/measures.h"
#include "demo/window/annotation.h"

namespace weft::demo {
namespace {

constexpr Vec3 wood{0.30f, 0.19f, 0.10f}, skin{0.62f, 0.38f, 0.26f}, iron{0.12f, 0.13f, 0.15f};
constexpr float thick = 0.012f;  // radius of rods and posts [m]

bool is_pinned(const ClothView& cloth, std::uint32_t vertex) {
    return cloth.positions[cloth.vertex_to_particle[vertex]].w == 0;
}

}  // namespace

void draw_holder(const ClothView& cloth, std::span<const std::uint32_t> vertices, Holder holder,
                 Annotation& to) {
    if (holder == Holder::rod) {
        if (!is_pinned(cloth, vertices.front())) return;
        const Vector3 a = vertex_position(cloth, vertices.front()),
                      b = vertex_position(cloth, vertices.back());
        const Vector3 beyond = 0.04f * (b - a).normalized();
        to.capsules.push_back({to_vec3(a - beyond), to_vec3(b + beyond), thick, wood});
        return;
    }
    for (const std::uint32_t vertex : vertices) {
        if (!is_pinned(cloth, vertex)) continue;
        const Vec3 at = to_vec3(vertex_position(cloth, vertex));
        if (holder == Holder::hands)
            to.spheres.push_back({at, 1.5f * thick, skin});
        else
            to.capsules.push_back({{at.x, 0, at.z}, {at.x, at.y + 2 * thick, at.z}, thick, wood});
    }
}

void draw_grate(float height, Annotation& to) {
    constexpr float long_half = 0.5f, short_half = 0.4f;
    constexpr int bars = 5;
    const float y = height + thick;
    for (int k = 0; k < bars; ++k) {
        const float part = 2 * static_cast<float>(k) / (bars - 1) - 1;
        const float x = part * long_half, z = part * short_half;
        to.capsules.push_back({{x, y, -short_half}, {x, y, short_half}, thick, iron});
        to.capsules.push_back({{-long_half, y, z}, {long_half, y, z}, thick, iron});
    }
}

}  // namespace weft::demo
