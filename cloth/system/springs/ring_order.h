#pragma once
// Rings: the springs of a particle in the order in which its triangles lie round it. The two sides of a
// triangle that meet at the particle are then neighbours in the ring, and its third side lies between them.

#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"
#include "cloth/system/sparse/stencil.h"

namespace weft {

/// One neighbour in a ring.
struct RingPlace {
    static constexpr std::uint32_t none = ~0u;

    std::uint32_t half_edge;        ///< from the ring's particle
    std::uint32_t copy;             ///< 0, or a later pair of triangles of an edge that has more than two
    std::uint32_t triangle = none;  ///< between this neighbour and the next one
};

/// The rings of a model's particles, one after the other. Neighbours that no triangle joins to the particle,
/// such as a sheet's, stand behind the others.
///
/// Each copy of an edge belongs to at most two triangles. So the copies round a particle are chains and
/// closed rings, and a closed ring that is not all of its particle's triangles is cut open: one of its edges
/// gets a copy for each of its two triangles, at both ends.
struct RingOrder {
    explicit RingOrder(const ClothModel& model);

    /// A stencil of the rings, each with the neighbours behind it that only bend. A half-edge has the entry
    /// of its copy 0.
    [[nodiscard]] Stencil stencil(const ClothModel& model) const;
    /// The place behind the last one of a particle's ring.
    [[nodiscard]] std::uint32_t end(std::uint32_t particle) const { return offsets[particle + 1]; }

    std::vector<std::uint32_t> offsets;  ///< of each particle
    std::vector<RingPlace> places;       ///< those of particle i: [offsets[i], offsets[i + 1])
    std::vector<std::uint32_t>
        openings;  ///< of each particle: the triangle between its last and first; or none
};

}  // namespace weft
