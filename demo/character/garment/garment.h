#pragma once
// A garment: a mesh of which one part is simulated and the other fixed to the body.

#include <string>
#include <vector>

#include "demo/character/body/body.h"
#include "demo/character/garment/map_names.h"
#include "demo/character/garment/surface_parts.h"
#include "weft/error.h"
#include "weft/mesh.h"

namespace weft::demo {

struct Garment {
    Mesh mesh;
    std::vector<std::uint32_t>
        fixed;  ///< vertices, ascending, at least one for each fixed position; empty: none is fixed
    Vec3 colour{0.30f, 0.05f, 0.12f};  ///< linear RGB
    SurfaceParts surface{};            ///< colours by material, of `fine` where it is there, else of `mesh`
    bool stands_ready = false;         ///< round a body in its stance; otherwise fit() moves it there
    bool from_waist = false;           ///< it hangs from the waist, not from neck and shoulders
    std::vector<PaintedMap> maps{};    ///< without Map::pin, whose vertices are in `fixed`
    Mesh fine{};         ///< finer mesh of the same shape that is drawn instead; empty: `mesh` is drawn
    float reach = 0.1f;  ///< greatest distance of its vertices from `mesh` [m]
    std::vector<std::string> notes;  ///< faults that the reader tolerated: a missing material file
};

/// Cuts every triangle in four. New vertices have the mean of the maps' values at their edges' ends.
void refine(Garment& garment);

/// Has a proxy of about `particles` particles (weft/proxy.h) simulated in place of the garment's mesh, which
/// becomes `fine`. What is fixed, and maps, are carried over. Returns the vertex of `fine` that is nearest to
/// each of the proxy's. Errors: make_proxy()'s; nothing of the proxy would be fixed although the garment is.
[[nodiscard]] Result<std::vector<std::uint32_t>> simulate_proxy(Garment& garment, std::uint32_t particles);

/// A dress without sleeves for this body in this pose, of about `vertices` (at least 16): a bodice that is
/// fixed to it, and a skirt to the knees that is simulated. Its shape is its rest shape.
[[nodiscard]] Garment make_dress(const Body& body, const Pose& pose, std::uint32_t vertices = 3100);

}  // namespace weft::demo
