#pragma once
// Data per vertex: each map is checked here, and remapped to particles as its mesh is cooked.

#include <cstdint>
#include <span>

#include "engine/memory/aligned_buffer.h"
#include "weft/error.h"

namespace weft {

/// The value of a particle into which several vertices were welded.
enum class WhereWelded : std::uint8_t {
    mean,
    least,
    greatest,
    any_bit,  ///< all bits of their values, which are whole numbers
};

/// A number for each vertex of a mesh.
struct VertexMap {
    const char* name = "";            ///< its name in errors
    std::span<const float> values{};  ///< one per vertex, or none
    float least = 0, greatest = 0;    ///< the range of a value
    float otherwise = 0;              ///< value of every particle where the map has none
    WhereWelded where_welded = WhereWelded::mean;
};

/// Remaps values to particles. A mean is of the vertices in ascending order, in double precision. Error: a
/// map of another size than the mesh, or a value out of its range, with its vertex.
[[nodiscard]] Result<AlignedBuffer<float>> remap_to_particles(
    const VertexMap& map, std::span<const std::uint32_t> vertex_to_particle, std::uint32_t particles);

}  // namespace weft
