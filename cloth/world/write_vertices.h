#pragma once

#include <cstdint>

#include "cloth/mesh/cook.h"
#include "weft/vertex_streams.h"
#include "weft/world.h"

namespace weft {

/// The triangles by the mesh's vertices; empty where these are not known.
[[nodiscard]] std::span<const Triangle> vertex_triangles_of(const ClothModel& model);

/// Error: see World::write_vertices.
[[nodiscard]] Result<void> check_streams(const ClothView& view, const VertexStreams& to);

/// Writes vertices [first, last) of a cloth. Precondition: check_streams() has no error.
void write_vertices(const ClothView& view, const ClothModel& model, const VertexStreams& to,
                    std::uint32_t first, std::uint32_t last) noexcept;

}  // namespace weft
