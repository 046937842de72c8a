#include <algorithm>
#include <string>

#include "render/gl/render_targets.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

namespace weft::render {

Image CaptureTarget::read() const {
    const std::size_t row = 3 * static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
    Image image{width_, height_, std::vector<std::uint8_t>(row * height)};
    std::uint8_t* pixels = image.rgb.data();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, pixels);

    // OpenGL's first row is the lowest, an Image's is the highest.
    for (std::size_t y = 0; y < height / 2; ++y)
        std::swap_ranges(pixels + y * row, pixels + (y + 1) * row, pixels + (height - 1 - y) * row);
    return image;
}

Result<void> save_png(const Image& image, const char* file) {
    if (stbi_write_png(file, image.width, image.height, 3, image.rgb.data(), 3 * image.width) != 0) return {};
    return Error{ErrorCode::file_not_found,
                 "cannot write '" + std::string(file) + "'; its folder must exist and be writable"};
}

}  // namespace weft::render
