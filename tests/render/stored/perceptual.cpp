#include "tests/render/stored/perceptual.h"

#include <algorithm>
#include <array>
#include <cmath>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>

namespace weft::render {
namespace {

using Colour = std::array<float, 3>;

float linear(std::uint8_t value) {
    const float s = static_cast<float>(value) / 255;
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t encoded(float light) {
    const float s = light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(s, 0.0f, 1.0f)));
}

/// CIELAB of sRGB, its white being D65's.
Colour lab(const std::uint8_t* rgb) {
    const float r = linear(rgb[0]), g = linear(rgb[1]), b = linear(rgb[2]);
    const auto f = [](float t) { return t > 0.008856f ? std::cbrt(t) : 7.787f * t + 16.0f / 116; };
    const float x = f((0.4124f * r + 0.3576f * g + 0.1805f * b) / 0.9505f);
    const float y = f(0.2126f * r + 0.7152f * g + 0.0722f * b);
    const float z = f((0.0193f * r + 0.1192f * g + 0.9505f * b) / 1.089f);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

std::vector<Colour> lab_of(const Image& image) {
    std::vector<Colour> all;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) all.push_back(lab(&image.rgb[i]));
    return all;
}

struct Block {
    Colour mean{};
    float variation = 0;  // of lightness
};

constexpr int side = 8;

Block block_at(const std::vector<Colour>& picture, int width, int left, int top) {
    Block block;
    float squares = 0;
    for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x) {
            const Colour& each = picture[static_cast<std::size_t>(y * width + x)];
            for (std::size_t c = 0; c < 3; ++c) block.mean[c] += each[c] / (side * side);
            squares += each[0] * each[0] / (side * side);
        }
    block.variation = std::sqrt(std::max(0.0f, squares - block.mean[0] * block.mean[0]));
    return block;
}

}  // namespace

std::string PerceptualDifference::words() const {
    return "colour " + std::to_string(colour) + ", texture " + std::to_string(texture);
}

PerceptualDifference perceptual_difference(const Image& a, const Image& b) {
    const std::vector<Colour> first = lab_of(a), second = lab_of(b);
    PerceptualDifference most;
    for (int top = 0; top + side <= a.height; top += side / 2)
        for (int left = 0; left + side <= a.width; left += side / 2) {
            const Block p = block_at(first, a.width, left, top), q = block_at(second, a.width, left, top);
            const float colour =
                std::hypot(p.mean[0] - q.mean[0], p.mean[1] - q.mean[1], p.mean[2] - q.mean[2]);
            most.colour = std::max(most.colour, colour);
            most.texture = std::max(most.texture, std::abs(p.variation - q.variation));
        }
    return most;
}

Image smaller(const Image& image, int factor) {
    Image small{image.width / factor, image.height / factor, {}};
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < 3; ++c) {
                float light = 0;
                for (int k = 0; k < factor * factor; ++k) {
                    const int from = (y * factor + k / factor) * image.width + x * factor + k % factor;
                    light += linear(image.rgb[static_cast<std::size_t>(3 * from + c)]);
                }
                small.rgb.push_back(encoded(light / static_cast<float>(factor * factor)));
            }
    return small;
}

Image load_png(const std::string& file) {
    Image image;
    int channels = 0;
    stbi_uc* const read = stbi_load(file.c_str(), &image.width, &image.height, &channels, 3);
    if (read == nullptr) return {};
    image.rgb.assign(read, read + std::ptrdiff_t{3} * image.width * image.height);
    stbi_image_free(read);
    return image;
}

}  // namespace weft::render
