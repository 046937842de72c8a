#include "weft/render/shown_image.h"

#include <glad/gl.h>

#include <filesystem>

#include "drawing.h"

namespace weft::render {
namespace {

using ShownImages = Drawing;

TEST_F(ShownImages, HaveThePixelsOfTheirFile) {
    Image image{5, 3, {}};
    for (int i = 0; i < 5 * 3 * 3; ++i) image.rgb.push_back(static_cast<std::uint8_t>(41 * i));
    const std::string file = (std::filesystem::path(testing::TempDir()) / "weft_shown_image.png").string();
    ASSERT_TRUE(save_png(image, file.c_str()));
    const auto shown = ShownImage::load(file.c_str());
    std::filesystem::remove(file);
    ASSERT_TRUE(shown) << shown.error().message;
    EXPECT_EQ(shown->width(), 5);
    EXPECT_EQ(shown->height(), 3);
    std::vector<std::uint8_t> pixels(5 * 3 * 4);
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(shown->texture())));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    for (std::size_t k = 0; k < 15; ++k)
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_EQ(pixels[4 * k + channel], image.rgb[3 * k + channel]);
}

TEST_F(ShownImages, AFileThatIsNotThereIsNamed) {
    const auto shown = ShownImage::load("/no/such/picture.png");
    ASSERT_FALSE(shown);
    EXPECT_NE(shown.error().message.find("/no/such/picture.png"), std::string::npos);
}

}  // namespace
}  // namespace weft::render
