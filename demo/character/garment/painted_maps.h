#pragma once
// Maps by vertex that are painted in a garment's file, or written beside it.
//
// NAME.maps beside NAME.obj (or NAME.glb) says what differs from vertex to vertex, a line for each part:
//
//     # map      of which vertices    value
//     leash      all                  0.15      all of them
//     backstop   12                   0.01      the file's 12th
//     friction   100-240              2         the file's 100th to 240th
//     stiffness  red                  3         the red of each vertex's colour, from 0 to 1, times 3
//
// A later line goes before an earlier one; what no line names has the map's own default. Vertices are `v`
// lines counted from 1, of a glTF file those of its garment, in the order of primitives. Colours are an OBJ
// file's `v x y z red green blue`, a glTF file's COLOR_0. They mean nothing without such a line.

#include <filesystem>
#include <span>

#include "demo/character/garment/garment.h"
#include "weft/error.h"

namespace weft::demo {

/// Of the `v` lines of an OBJ file that load_obj has read; none, where not all have one.
[[nodiscard]] std::vector<Vec3> read_vertex_colours(const std::filesystem::path& obj);

/// Gives the garment of this file its maps; nothing, where there is no file of maps. What `pin` pins becomes
/// Garment::fixed. Of `vertices` the rest of the mesh's are split off at the same position (load_obj).
/// Errors name the line: a map or channel of no such name, vertices that the file lacks, a value that is no
/// number or out of the map's range (maps.h), colours that it has not.
[[nodiscard]] Result<void> read_maps(const std::filesystem::path& garment_file, std::size_t vertices,
                                     std::span<const Vec3> colours, Garment& garment);

}  // namespace weft::demo
