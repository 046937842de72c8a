#pragma once
// A ring is the list of a particle's springs in the order in which its triangles lie round it. The two sides
// of a triangle that meet at the particle follow one another in the ring, and its third side joins their far
// ends.

#include <cstdint>
#include <vector>

#include "cloth/equation/sparse/stencil.h"
#include "cloth/mesh/cook.h"

namespace weft {

/// A place of a ring holds one neighbour of the particle.
struct RingPlace {
    static constexpr std::uint32_t none = ~0u;

    std::uint32_t half_edge;        ///< from the ring's particle
    std::uint32_t copy;             ///< 1 for the second triangle of an edge that is cut, else 0
    std::uint32_t triangle = none;  ///< between this neighbour and the next one
};

/// RingOrder lists the rings of all particles of a model. Springs of no triangle, such as a sheet's, come
/// last.
///
/// An edge has one triangle or two, so the triangles round a particle form chains and closed rings. A closed
/// ring is cut unless it is all that its particle has: one of its edges gets a copy for each of its
/// triangles, at both ends. So even where cones meet at their tips, a row is one closed ring or has none.
struct RingOrder {
    explicit RingOrder(const ClothModel& model);

    /// The matrix's stencil: each particle's ring, followed by the neighbours to which it has bending alone.
    /// A half-edge has the entry of its copy 0.
    [[nodiscard]] Stencil stencil(const ClothModel& model) const;
    /// One past the last place of a particle's ring.
    [[nodiscard]] std::uint32_t end(std::uint32_t particle) const { return offsets[particle + 1]; }

    std::vector<std::uint32_t> offsets;   ///< where each particle's places begin
    std::vector<RingPlace> places;        ///< those of particle i: [offsets[i], offsets[i + 1])
    std::vector<std::uint32_t> openings;  ///< the triangle between each ring's last and first place; or none
};

}  // namespace weft
