#pragma once
// What somebody wears: a mesh of which one part is simulated and the other fixed to the body.

#include <string>
#include <vector>

#include "demo/character/body/body.h"
#include "weft/maps.h"
#include "weft/mesh.h"

namespace weft::demo {

/// A number for each vertex.
struct PaintedMap {
    Map map;
    std::vector<float> values;
};

struct Garment {
    Mesh mesh;
    std::vector<std::uint32_t>
        fixed;  ///< vertices, ascending, one at least for each position; empty: it hangs
    Vec3 colour{0.30f, 0.05f, 0.12f};  ///< linear RGB
    bool stands_ready = false;         ///< round a body in its stance; else it has to be brought there
    bool from_waist = false;           ///< it hangs from the waist, not from neck and shoulders
    std::vector<PaintedMap> maps{};    ///< but pins, which are fixed
    Mesh fine{};  ///< of the same shape, to be drawn over the mesh; empty: the mesh is drawn
    std::vector<std::string> notes;  ///< what its reader went on from: a material file that is missing
};

/// A dress without sleeves for this body in this pose, of about `vertices` (at least 16): a bodice that is
/// fixed to it, and a skirt to the knees that is simulated. Its shape is its rest shape.
[[nodiscard]] Garment make_dress(const Body& body, const Pose& pose, std::uint32_t vertices = 3100);

}  // namespace weft::demo
