#pragma once
// Destinations of World::write_vertices(), for renderers.

#include <cstddef>
#include <span>

namespace weft {

/// One attribute, an array of floats for each vertex: the first vertex's at `bytes.data()`, the next one's
/// `stride` bytes on. Streams may be interleaved, as one array of structs.
struct VertexStream {
    std::span<std::byte> bytes{};  ///< memory of any alignment; empty: the attribute is not written
    std::size_t stride = 0;        ///< distance between vertices [bytes]; 0: values are contiguous
};

/// Attributes of a vertex. An empty stream costs nothing.
struct VertexStreams {
    VertexStream positions{};           ///< x y z [m]
    VertexStream previous_positions{};  ///< x y z, at the start of the last step [m]
    VertexStream normals{};             ///< x y z, unit length
    VertexStream previous_normals{};    ///< x y z, at the start of the last step: by the positions then
    /// x y z, unit length, level with the surface, where u grows; w is 1 or -1: the other tangent is w times
    /// normal x tangent (as in glTF). At seams each vertex has that of its panel.
    VertexStream tangents{};
    VertexStream texcoords{};  ///< u v
    /// Strain along warp and along weft: a thread's length over that at rest, less 1, below 0 where cloth is
    /// pressed together. The mean over the vertex's triangles, by their areas at rest; at seams each vertex
    /// has that of its panel, if the mesh has texture coordinates. For wrinkle maps.
    VertexStream strains{};
};

}  // namespace weft
