#pragma once
// Where World::write_vertices() writes what a renderer needs.

#include <cstddef>
#include <span>

namespace weft {

/// One kind of value, an array of floats for each vertex: the first vertex's at `bytes.data()`, the next
/// one's `stride` bytes on. Several streams may lie within each other, as one array of structs.
struct VertexStream {
    std::span<std::byte> bytes{};  ///< of any alignment; empty: this kind is not asked for
    std::size_t stride = 0;        ///< [bytes]; 0: one value right behind the other
};

/// What is written of each vertex. What is left empty costs nothing.
struct VertexStreams {
    VertexStream positions{};           ///< x y z [m]
    VertexStream previous_positions{};  ///< x y z, at the start of the last step [m]
    VertexStream normals{};             ///< x y z, unit length
    VertexStream previous_normals{};    ///< x y z, at the start of the last step: made of the positions then
    /// x y z, unit length, across the normal, where the first texture coordinate grows; w is 1 or -1: the
    /// other tangent is w times normal x tangent (as in glTF). At seams each vertex has that of its panel.
    VertexStream tangents{};
    VertexStream texcoords{};  ///< u v
};

}  // namespace weft
