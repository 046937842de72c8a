#pragma once
// Views into the cloth's state: wireframe, colours by a quantity, lines and words.

#include <optional>
#include <string>
#include <vector>

#include "demo/scene_simulation.h"
#include "demo/window/annotation.h"
#include "weft/render/scene_renderer.h"

namespace weft::demo {

/// The quantity that replaces the cloth's own colour.
enum class ShownAsColour { nothing, strain, bending, speed };

struct Inside {
    bool wireframe = false;
    std::optional<Map> painted{};  ///< a brush paints this map: its values are shown, on the simulated mesh
    ShownAsColour colour = ShownAsColour::nothing;
    DebugParts parts = DebugParts::none;  ///< drawn as lines and words

    void toggle(DebugParts part) {
        parts = static_cast<DebugParts>(static_cast<std::uint32_t>(parts) ^ static_cast<std::uint32_t>(part));
    }
};

/// World::debug_draw's lines and words, and a scene's annotation, in the host's own memory.
struct InsideDrawing : Annotation {
    void take(const World& world, DebugParts parts);
};

/// Colours of particles, for ClothFrame::colours: blue for small values, red at strain 5 %, at a bend of 45
/// degrees between neighbours, or at 10 m/s. For ShownAsColour::nothing the cloth's tints, or none.
void colour_particles(ShownAsColour what, const SceneCloth& cloth, const ClothView& view,
                      std::vector<Vec4>& colours);

/// Colours of particles by a painted map: blue for the slider's least, red for its most, grey for the
/// default.
void colour_by_map(Map map, const SceneCloth& cloth, const ClothView& view, std::vector<Vec4>& colours);

/// The meaning of the colour scale's ends, for a legend.
[[nodiscard]] const char* scale_of(ShownAsColour what);

}  // namespace weft::demo
