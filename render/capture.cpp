#include <algorithm>
#include <cstring>
#include <string>

#include "render/render_targets.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

namespace weft::render {

/// OpenGL's first row is the lowest, an Image's is the highest.
Image CaptureTarget::read() const {
    Image image{width_, height_, {}};
    const auto row = 3 * static_cast<std::size_t>(width_);
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
    image.rgb.resize(upside_down.size());
    for (auto from = upside_down.end(), to = image.rgb.begin(); from != upside_down.begin();
         from -= row, to += row)
        std::copy(from - row, from, to);
    return image;
}

Result<void> save_png(const Image& image, const char* file) {
    if (stbi_write_png(file, image.width, image.height, 3, image.rgb.data(), 3 * image.width) != 0) return {};
    return Error{ErrorCode::file_not_found,
                 "cannot write '" + std::string(file) + "'; its folder must exist and be writable"};
}

}  // namespace weft::render
