#pragma once

#include <cstdint>

#include "cloth/mesh/cook.h"
#include "weft/vertex_streams.h"
#include "weft/world.h"

namespace weft {

/// The triangles by vertices, where they are known.
[[nodiscard]] std::span<const Triangle> vertex_triangles_of(const ClothModel& model);

/// Error: see World::write_vertices.
[[nodiscard]] Result<void> check_streams(const ClothView& view, const VertexStreams& to);

/// Vertices [first, last) of a cloth in what they were checked to have room for.
void write_vertices(const ClothView& view, const ClothModel& model, const VertexStreams& to,
                    std::uint32_t first, std::uint32_t last) noexcept;

}  // namespace weft
