// A garment that is simulated by a coarser mesh than is drawn.

#include <algorithm>
#include <string>
#include <utility>

#include "demo/character/garment/garment.h"
#include "demo/character/garment/garment_mesh.h"
#include "engine/vector.h"
#include "weft/proxy.h"

namespace weft::demo {
Result<std::vector<std::uint32_t>> simulate_proxy(Garment& garment, std::uint32_t particles) {
    ProxyReport made;
    auto proxy = make_proxy(garment.mesh, {.particles = particles}, &made);
    if (!proxy) return Error{proxy.error().code, "--simulate: " + proxy.error().message};
    std::vector<std::uint32_t> nearest = nearest_vertices(garment.mesh, *proxy), fixed;
    const auto at = [&](std::uint32_t v) { return to_vector(garment.mesh.positions[v]); };
    // `fixed` names each position once; welded vertices there are fixed as well.
    const auto is_fixed = [&](std::uint32_t v) {
        return std::ranges::any_of(garment.fixed, [&](std::uint32_t f) { return at(f) == at(v); });
    };
    for (std::uint32_t v = 0; v < nearest.size(); ++v)
        if (is_fixed(nearest[v])) fixed.push_back(v);
    if (fixed.empty() && !garment.fixed.empty())
        return Error{ErrorCode::invalid_mesh,
                     "--simulate: no particle would be where the garment is fixed; "
                     "take more than " +
                         std::to_string(particles)};
    for (PaintedMap& painted : garment.maps) {
        std::vector<float> values;
        for (const std::uint32_t v : nearest) values.push_back(painted.values[v]);
        painted.values = std::move(values);
    }
    garment.fixed = std::move(fixed);
    garment.fine = std::exchange(garment.mesh, std::move(*proxy));
    garment.reach = made.reach + 0.002f;  // the nearest place may be on the other side of an edge
    garment.notes.push_back(std::to_string(garment.fine.positions.size()) + " vertices are drawn over " +
                            std::to_string(garment.mesh.positions.size()) + " that are simulated");
    return nearest;
}

}  // namespace weft::demo
