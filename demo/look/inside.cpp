#include "demo/look/inside.h"

#include <algorithm>
#include <cmath>

#include "demo/character/garment/garment_mesh.h"
#include "demo/hands/brush.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

/// The colour scale, from blue (0) over green to red (1).
Vec4 heat(float share) {
    const float t = std::clamp(share, 0.0f, 1.0f);
    const auto bump = [t](float middle) { return std::clamp(1.5f - std::abs(4 * t - middle), 0.0f, 1.0f); };
    return {0.8f * bump(3), 0.7f * bump(2), 0.8f * bump(1), 0.9f};
}

/// Colours each particle by the greatest `measure` of its edges.
void collect(const Mesh& mesh, const ClothView& view, std::vector<Vec4>& colours, const auto& measure) {
    std::vector<float> most(view.positions.size(), 0.0f);
    for (const Triangle& triangle : mesh.triangles) {
        for (int side = 0; side < 3; ++side) {
            const std::uint32_t a = triangle[static_cast<std::size_t>(side)],
                                b = triangle[static_cast<std::size_t>((side + 1) % 3)];
            const std::uint32_t p = view.vertex_to_particle[a], q = view.vertex_to_particle[b];
            const float value = measure(a, b, p, q);
            most[p] = std::max(most[p], value);
            most[q] = std::max(most[q], value);
        }
    }
    for (std::size_t i = 0; i < most.size(); ++i) colours[i] = heat(most[i]);
}

}  // namespace

void InsideDrawing::take(const World& world, DebugParts parts) {
    static_cast<Annotation&>(*this) = {};
    const DebugCanvas canvas{.user = this,
                             .line =
                                 [](void* user, const Vec3& from, const Vec3& to, const Vec3& colour) {
                                     static_cast<InsideDrawing*>(user)->lines.push_back({from, to, colour});
                                 },
                             .text =
                                 [](void* user, const Vec3& at, const char* text, const Vec3& colour) {
                                     static_cast<InsideDrawing*>(user)->words.push_back({at, text, colour});
                                 }};
    world.debug_draw(canvas, parts);
}

void colour_particles(ShownAsColour what, const SceneCloth& cloth, const ClothView& view,
                      std::vector<Vec4>& colours) {
    colours.clear();
    if (what == ShownAsColour::nothing && cloth.tints.empty()) return;
    const Mesh& mesh = cloth.mesh;
    colours.resize(view.positions.size());
    if (what == ShownAsColour::nothing) {
        for (std::size_t vertex = 0; vertex < cloth.tints.size(); ++vertex)
            colours[view.vertex_to_particle[vertex]] = cloth.tints[vertex];
        return;
    }
    if (what == ShownAsColour::speed) {
        for (std::size_t i = 0; i < colours.size(); ++i)
            colours[i] = heat(xyz(view.velocities[i]).norm() / 10);
        return;
    }
    if (what == ShownAsColour::strain) {
        collect(mesh, view, colours, [&](std::uint32_t a, std::uint32_t b, std::uint32_t p, std::uint32_t q) {
            const float rest = rest_length(mesh, a, b);
            const float length = (xyz(view.positions[p]) - xyz(view.positions[q])).norm();
            return rest > 0 ? std::abs(length / rest - 1) / 0.05f : 0.0f;
        });
        return;
    }
    collect(mesh, view, colours, [&](std::uint32_t, std::uint32_t, std::uint32_t p, std::uint32_t q) {
        return (xyz(view.normals[p]) - xyz(view.normals[q])).norm() / 0.77f;  // the chord of 45 degrees
    });
}

void colour_by_map(Map map, const SceneCloth& cloth, const ClothView& view, std::vector<Vec4>& colours) {
    constexpr Vec4 unpainted{0.5f, 0.5f, 0.5f, 0.85f};
    colours.assign(view.positions.size(), unpainted);
    const auto painted = std::ranges::find(cloth.maps, map, &PaintedMap::map);
    if (painted == cloth.maps.end()) return;
    for (std::size_t v = 0; v < painted->values.size() && v < view.vertex_to_particle.size(); ++v)
        if (const float value = painted->values[v]; value != named(map).unset)
            colours[view.vertex_to_particle[v]] = heat(share_of_range(map, value));
}

const char* scale_of(ShownAsColour what) {
    switch (what) {
        case ShownAsColour::strain:
            return "blue: as long as at rest; red: 5 % longer or shorter";
        case ShownAsColour::bending:
            return "blue: flat; red: 45 degrees from one particle to the next";
        case ShownAsColour::speed:
            return "blue: at rest; red: 10 m/s and more";
        case ShownAsColour::nothing:
            break;
    }
    return "";
}

}  // namespace weft::demo
