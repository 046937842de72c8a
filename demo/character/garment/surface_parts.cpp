#include "demo/character/garment/surface_parts.h"

#include <cstddef>
#include <fstream>
#include <iterator>
#include <utility>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_MAX_DIMENSIONS 8192
#include <stb_image.h>

namespace weft::demo {

render::ClothPart part_of(const std::optional<Vec3>& own, const Vec3& default_colour,
                          std::shared_ptr<const render::Image> picture) {
    const Vec3 colour = own.value_or(picture != nullptr ? Vec3{1, 1, 1} : default_colour);
    const auto on_back = [printed = picture != nullptr](float part) {
        return printed ? 0.85f * part : 0.5f * part + 0.25f;
    };
    return {.front = colour,
            .back = {on_back(colour.x), on_back(colour.y), on_back(colour.z)},
            .picture = std::move(picture)};
}

SurfaceParts refined(const SurfaceParts& coarse) {
    SurfaceParts fine{.parts = coarse.parts, .of_triangle = {}};
    for (const std::uint32_t part : coarse.of_triangle)
        fine.of_triangle.insert(fine.of_triangle.end(), 4, part);
    return fine;
}

Result<std::shared_ptr<const render::Image>> decode_picture(std::span<const unsigned char> bytes,
                                                            const std::string& name) {
    constexpr std::size_t most_bytes = std::size_t{1} << 30;
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        bytes.size() > most_bytes ? nullptr
                                  : stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()),
                                                          &width, &height, &channels, 3),
        stbi_image_free);
    if (!pixels)
        return Error{
            ErrorCode::malformed_file,
            name +
                " is no picture that can be shown: it must be PNG, JPEG, TGA or BMP, of at most 8192 "
                "pixels a side"};
    auto image = std::make_shared<render::Image>();
    image->width = width;
    image->height = height;
    image->rgb.assign(pixels.get(),
                      pixels.get() + 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return std::shared_ptr<const render::Image>(std::move(image));
}

Result<std::shared_ptr<const render::Image>> read_picture(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
        return Error{ErrorCode::file_not_found, file.string() + " cannot be read; it should be a picture"};
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> bytes(std::istreambuf_iterator<char>(stream), {});
    return decode_picture({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                          file.string());
}

}  // namespace weft::demo
