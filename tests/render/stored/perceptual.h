#pragma once
// How differently two pictures look: blind to noise and to edges that are off by part of a pixel.

#include <string>

#include "weft/render/scene_renderer.h"

namespace weft::render {

/// A difference of 2.3 in CIELAB is just noticed.
struct PerceptualDifference {
    float colour = 0;   ///< the most between mean colours of blocks of 8 x 8 pixels
    float texture = 0;  ///< the most between how much lightness varies within them
    [[nodiscard]] bool is_noticed() const { return colour > 3 || texture > 2; }
    [[nodiscard]] std::string words() const;
};

/// Precondition: the same size, at least 8 x 8.
[[nodiscard]] PerceptualDifference perceptual_difference(const Image& a, const Image& b);

/// By a whole factor, as means of light.
[[nodiscard]] Image smaller(const Image& image, int factor);

/// Of 8-bit RGB; empty where the file cannot be read.
[[nodiscard]] Image load_png(const std::string& file);

}  // namespace weft::render
