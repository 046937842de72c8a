#pragma once
// A picture from a file, to be shown in a panel.

#include <memory>

#include "weft/error.h"

namespace weft::render {

class ShownImage {
  public:
    /// Loads a PNG file. Precondition: a Context is current, here and when the image is destroyed. Errors: no
    /// Context was ever made; a file that cannot be read, or is no picture.
    [[nodiscard]] static Result<ShownImage> load(const char* file);
    ShownImage(ShownImage&&) noexcept;
    ShownImage& operator=(ShownImage&&) noexcept;
    ~ShownImage();

    [[nodiscard]] int width() const noexcept;   ///< [pixels]
    [[nodiscard]] int height() const noexcept;  ///< [pixels]
    /// The texture's OpenGL name as a pointer, as ImGui::Image() takes it.
    [[nodiscard]] void* texture() const noexcept;

  private:
    struct Impl;
    explicit ShownImage(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft::render
