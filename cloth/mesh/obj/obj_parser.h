#pragma once
// The content of an OBJ file, checked as it is read.

#include <array>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "weft/error.h"
#include "weft/types.h"

namespace weft {

/// The file's own arrays, with indices counted from 0, all in range.
struct ObjContent {
    struct Corner {
        static constexpr std::uint32_t none = ~0u;
        std::uint32_t position;
        std::uint32_t texcoord;  ///< or `none`
    };

    std::vector<Vec3> positions;
    std::vector<Vec2> texcoords;
    std::vector<std::array<Corner, 3>> triangles;
    /// Lines of other kinds than v, vt and f; blank lines and comments are not counted.
    std::uint32_t ignored_lines = 0;
    std::uint32_t triangulated_faces = 0, crossing_faces = 0, touching_faces = 0;  ///< see ObjReport
    bool has_texcoords = false;                                                    ///< on any corner
};

/// Parses an OBJ file. Error, by line: a coordinate that is no finite number, too few of them, a face of
/// fewer than three corners, an index that is 0 or out of range, a corner without the texture coordinate that
/// `need_texcoords` asks for, more elements than a mesh may have; or no faces. Errors name the file `file`.
[[nodiscard]] Result<ObjContent> parse_obj(std::istream& stream, const std::string& file,
                                           bool need_texcoords);

}  // namespace weft
