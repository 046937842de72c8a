#pragma once
// Well-known materials: how they move and how they look.

#include <span>

#include "weft/render/scene_renderer.h"
#include "weft/weft.h"

namespace weft::demo {

struct Material {
    const char* name;
    Fabric fabric;
    render::FabricLook look;
    const char* note;  ///< its visible behaviour, and the source of the figures
};
[[nodiscard]] std::span<const Material> materials();

/// One number for warp and weft, their geometric mean [N/m].
[[nodiscard]] float stiffness_of(const Fabric& fabric);
/// Scales warp, weft and shear, so that stiffness_of() becomes `stiffness`.
void set_stiffness(Fabric& fabric, float stiffness);

}  // namespace weft::demo
