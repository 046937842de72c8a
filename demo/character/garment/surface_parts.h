#pragma once
// The colours and pictures of a mesh's materials, by triangle.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weft/error.h"
#include "weft/render/scene_renderer.h"

namespace weft::demo {

/// The materials of a mesh, which is drawn by them in place of one look's colours; its motion knows none.
struct SurfaceParts {
    std::vector<render::ClothPart> parts;    ///< empty: the look's colours
    std::vector<std::uint32_t> of_triangle;  ///< indices into `parts`, one per triangle
};

/// The look of a material: its back is paler, and a picture shows on both sides. Without a colour it has the
/// picture's own, or else the default.
[[nodiscard]] render::ClothPart part_of(const std::optional<Vec3>& colour, const Vec3& default_colour,
                                        std::shared_ptr<const render::Image> picture = {});

/// The parts of a mesh each of whose triangles was cut in four.
[[nodiscard]] SurfaceParts refined(const SurfaceParts& coarse);

/// Decodes a PNG, JPEG, TGA or BMP picture of at most 8192 pixels a side. Error: the bytes are none; the
/// message says why, and begins with `name`.
[[nodiscard]] Result<std::shared_ptr<const render::Image>> decode_picture(
    std::span<const unsigned char> bytes, const std::string& name);
/// Reads a picture. Errors: decode_picture()'s, and a file that cannot be read.
[[nodiscard]] Result<std::shared_ptr<const render::Image>> read_picture(const std::filesystem::path& file);

}  // namespace weft::demo
