#pragma once
// Maps by vertex that are painted in a garment's file, or written beside it.
//
// NAME.maps beside NAME.obj (or NAME.glb) gives maps their values, a line for each set of vertices:
//
//     # map      of which vertices    value
//     leash      all                  0.15      all of them
//     backstop   12                   0.01      the file's 12th
//     friction   100-240              2         the file's 100th to 240th
//     stiffness  red                  3         the red of each vertex's colour, from 0 to 1, times 3
//
// A later line overrides an earlier one; vertices that no line names have the map's own default. Vertices are
// counted from 1: an OBJ file's `v` lines, or a glTF garment's vertices in the order of primitives. Colours
// are an OBJ file's `v x y z red green blue`, a glTF file's COLOR_0. Only such lines use them.

#include <filesystem>
#include <span>

#include "demo/character/garment/garment.h"
#include "weft/error.h"

namespace weft::demo {

/// Colours of an OBJ file's `v` lines; none, where not all have one. Precondition: load_obj has read it.
[[nodiscard]] std::vector<Vec3> read_vertex_colours(const std::filesystem::path& obj);

/// Reads the maps beside a garment's file, if there are any. Vertices that `pin` pins join Garment::fixed.
/// The file has `vertices` vertices; load_obj splits the mesh's further ones off them at the same positions.
/// Errors name the line: a map or channel of no such name, vertices that the file lacks, a value that is no
/// number or out of the map's range (maps.h), colours that the garment lacks.
[[nodiscard]] Result<void> read_maps(const std::filesystem::path& garment_file, std::size_t vertices,
                                     std::span<const Vec3> colours, Garment& garment);

/// The file of maps beside a garment's file.
[[nodiscard]] std::filesystem::path maps_file(const std::filesystem::path& garment_file);

/// Writes maps beside a garment's file, by that file's vertices. Lines of other maps in the file stay, and so
/// do comments. Error: it cannot be written.
[[nodiscard]] Result<void> write_maps(const std::filesystem::path& garment_file,
                                      std::span<const PaintedMap> maps);

}  // namespace weft::demo
