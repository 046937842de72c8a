#include "demo/look/materials.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace weft::demo {
namespace {

using render::Threads;

Fabric measured(std::string_view name) {
    const auto found =
        std::ranges::find_if(fabrics(), [&](const NamedFabric& each) { return name == each.name; });
    return found == fabrics().end() ? Fabric{} : found->fabric;
}

std::vector<Material> all_materials() {
    return {
        {"silk",
         measured("silk"),
         {.roughness = 0.38f,
          .sheen = 0.25f,
          .threads = Threads::plain,
          .thread_width = 0.12f,
          .shine = 0.8f,
          .shine_width = 0.16f,
          .translucency = 0.42f},
         "Flows in small folds and shines across its threads. As measured of a cupro lining."},
        {"cotton",
         measured("cotton"),
         {.roughness = 0.8f, .sheen = 0.45f, .thread_width = 0.35f, .shine = 0.05f, .translucency = 0.35f},
         "Light and limp, with many small wrinkles. As measured of a voile."},
        {"denim",
         measured("denim"),
         {.roughness = 0.85f,
          .sheen = 0.35f,
          .threads = Threads::twill,
          .thread_width = 0.6f,
          .shine = 0.03f,
          .translucency = 0.03f},
         "Heavy: a few large folds, slow in the wind. Measured by Wang et al. 2011."},
        {"wool",
         {.areal_density = 0.25f,
          .warp = 900,
          .weft = 700,
          .shear = 45,
          .bending = 1.2e-5f,
          .damping = 1e-3f},
         {.roughness = 1.0f,
          .sheen = 1.0f,
          .threads = Threads::knit,
          .thread_width = 2.2f,
          .translucency = 0.10f},
         "Soft, thick folds that come to rest soon. By what testers of suiting usually find; no one cloth."},
        {"leather",
         measured("leather"),
         {.roughness = 0.5f, .sheen = 0.1f, .threads = Threads::none, .translucency = 0},
         "Stiff: bends as a whole and keeps off small folds. A guess: 0.7 mm of 10 MPa."},
        {"nylon",
         {.areal_density = 0.06f, .warp = 5000, .weft = 4000, .shear = 150, .bending = 6e-6f},
         {.roughness = 0.3f,
          .sheen = 0.1f,
          .thread_width = 0.2f,
          .shine = 0.45f,
          .shine_width = 0.3f,
          .translucency = 0.5f},
         "Very light: flutters fast and creases sharply, as a kite does. A guess: 0.06 mm of 80 MPa."},
        {"rubber",
         {.areal_density = 0.47f,
          .warp = 750,
          .weft = 750,
          .shear = 250,
          .bending = 2.1e-5f,
          .damping = 5e-3f},
         {.roughness = 0.45f, .sheen = 0.05f, .threads = Threads::none, .translucency = 0.05f},
         "Stretches and springs back. A sheet of 0.5 mm, 950 kg/m3 and 1.5 MPa."},
    };
}

}  // namespace

std::span<const Material> materials() {
    static const std::vector<Material> all = all_materials();
    return all;
}

float stiffness_of(const Fabric& fabric) {
    return std::sqrt(fabric.warp * fabric.weft);
}

void set_stiffness(Fabric& fabric, float stiffness) {
    const float present = stiffness_of(fabric);
    const float factor = present > 0 ? stiffness / present : 0;
    if (factor == 0) {
        fabric.warp = fabric.weft = stiffness;
        return;
    }
    fabric.warp *= factor;
    fabric.weft *= factor;
    fabric.shear *= factor;
}

}  // namespace weft::demo
