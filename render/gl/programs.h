#pragma once
// Every shader program of the renderer, and the uniforms that they share.

#include <string_view>

#include "render/gl/gl.h"

namespace weft::render {

/// The text of render/shaders/<name>, embedded at build time; "" if there is none.
[[nodiscard]] const char* shader_source(std::string_view name) noexcept;

/// The uniform block `Frame` of frame.glsl, byte for byte (std140).
struct FrameUniforms {
    Matrix4 clip_from_world;
    Matrix4 world_from_clip;
    Matrix4 sun_from_world;  ///< to the sun's depth map: xyz in [0, 1]
    Matrix4 sky_from_world;  ///< to the depth map seen from above
    Vec4 eye;                ///< [m]
    Vec4 sun_direction;      ///< towards the sun, unit length
    Vec4 sun_extent;         ///< side of the sun's map [m], its depth [m], one texel [m]
    Vec4 sky_extent;         ///< the same of the map seen from above
    Vec4 ground;             ///< a point of the ground, and the distance over which it fades [m]
    Vec4 arrow;              ///< foot x and z, vector x and z [m]
    Vec4 quality;            ///< samples: blockers, sun's edge, sky; w 1: threads are drawn
};
constexpr GLuint frame_binding = 0;

/// Texture units; the sampler uniforms of every program are set to them once.
namespace unit {
enum : int {
    sun_compare,
    sun_depth,
    sky_depth,
    positions,
    previous_positions,
    normals,
    picture,
    colours,
    print
};
}

struct Programs {
    Program sky, ground, solid, cloth, cloth_lines, lines, display;
    Program solid_depth, cloth_depth;

    /// Error: the shader that this driver refuses, with its log.
    [[nodiscard]] static Result<Programs> build();
};

}  // namespace weft::render
