#include <glad/gl.h>
#include <stb_image.h>

#include <filesystem>

#include "drawing.h"
#include "weft/render/shown_image.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG

namespace weft::render {

namespace {

TEST(SavePng, WhatIsWrittenIsReadBack) {
    Image image{7, 5, {}};
    for (int i = 0; i < 7 * 5 * 3; ++i) image.rgb.push_back(static_cast<std::uint8_t>(37 * i));
    const std::string file = (std::filesystem::path(testing::TempDir()) / "weft_save_png.png").string();
    const Result<void> saved = save_png(image, file.c_str());
    ASSERT_TRUE(saved) << saved.error().message;

    int width = 0, height = 0, channels = 0;
    stbi_uc* read = stbi_load(file.c_str(), &width, &height, &channels, 0);
    ASSERT_NE(read, nullptr) << stbi_failure_reason();
    EXPECT_EQ(width, image.width);
    EXPECT_EQ(height, image.height);
    EXPECT_EQ(channels, 3);
    EXPECT_EQ(std::vector<std::uint8_t>(read, read + image.rgb.size()), image.rgb);
    stbi_image_free(read);
    std::filesystem::remove(file);
}

TEST(SavePng, AFileThatCannotBeWrittenIsNamed) {
    const Image image{1, 1, {1, 2, 3}};
    const Result<void> saved = save_png(image, "/no/such/folder/picture.png");
    ASSERT_FALSE(saved);
    EXPECT_NE(saved.error().message.find("/no/such/folder/picture.png"), std::string::npos);
}

using Capture = Drawing;

TEST_F(Capture, HasTheSizeAskedForEachTime) {
    for (const auto& [width, height] : {std::pair{64, 48}, std::pair{33, 77}, std::pair{64, 48}}) {
        const Image image = renderer().capture(View{}, width, height);
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
        EXPECT_EQ(image.rgb.size(), static_cast<std::size_t>(3 * width * height));
    }
}

TEST_F(Capture, TheFirstRowIsTheHighest) {
    View view;
    view.camera.pitch = 0.3f;
    const Image image = renderer().capture(view, 64, 64);
    EXPECT_GT(pixel(image, 32, 0).blue - pixel(image, 32, 0).red,
              pixel(image, 32, 63).blue - pixel(image, 32, 63).red)
        << "sky on top, ground below";
}

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
