#include "weft/render/shown_image.h"

#include <cstdint>
#include <string>

#include "render/gl/gl.h"
#include "render/gl/gl_state.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>

namespace weft::render {

struct ShownImage::Impl {
    Texture texture = Texture::make();
    int width = 0, height = 0;
};

ShownImage::ShownImage(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ShownImage::ShownImage(ShownImage&&) noexcept = default;
ShownImage& ShownImage::operator=(ShownImage&&) noexcept = default;
ShownImage::~ShownImage() = default;

Result<ShownImage> ShownImage::load(const char* file) {
    if (glGenTextures == nullptr)
        return Error{ErrorCode::unsupported, "no Context has been made yet; make one before images"};
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(stbi_load(file, &width, &height, &channels, 4),
                                                           stbi_image_free);
    if (!pixels)
        return Error{ErrorCode::file_not_found, "'" + std::string(file) + "' cannot be shown: " +
                                                    stbi_failure_reason() + "; it should be a PNG file"};
    const SavedBindings bindings;
    auto impl = std::make_unique<Impl>();
    impl->width = width;
    impl->height = height;
    glBindTexture(GL_TEXTURE_2D, impl->texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.get());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return ShownImage(std::move(impl));
}

int ShownImage::width() const noexcept {
    return impl_->width;
}
int ShownImage::height() const noexcept {
    return impl_->height;
}
void* ShownImage::texture() const noexcept {
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(impl_->texture.id()));
}

}  // namespace weft::render
