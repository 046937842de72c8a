#pragma once
// What somebody wants to see of the inside of the cloth.

#include <string>
#include <vector>

#include "demo/scene_simulation.h"
#include "demo/window/annotation.h"
#include "weft/render/scene_renderer.h"

namespace weft::demo {

/// What the cloth's own colour gives way to.
enum class ShownAsColour { nothing, strain, bending, speed };

struct Inside {
    bool wireframe = false;
    ShownAsColour colour = ShownAsColour::nothing;
    DebugParts parts = DebugParts::none;  ///< drawn as lines and words

    [[nodiscard]] bool has_lines() const { return parts != DebugParts::none; }
    void toggle(DebugParts part) {
        parts = static_cast<DebugParts>(static_cast<std::uint32_t>(parts) ^ static_cast<std::uint32_t>(part));
    }
};

/// World::debug_draw's lines and words, in the host's own memory.
struct InsideDrawing : Annotation {
    void take(const World& world, DebugParts parts);
};

/// Each particle's colour and how much of it covers the fabric's: blue where there is little of what is
/// shown, red at strain 5 %, at a bend of 45 degrees between neighbours, or at 10 m/s. Empty for nothing.
/// `mesh`: the cloth's, at rest.
void colour_particles(ShownAsColour what, const Mesh& mesh, const ClothView& view,
                      std::vector<Vec4>& colours);

/// What its ends mean, for a legend.
[[nodiscard]] const char* scale_of(ShownAsColour what);

}  // namespace weft::demo
