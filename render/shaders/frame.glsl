// Uniforms that all programs of one picture share, in the layout of FrameUniforms in programs.h.
layout(std140) uniform Frame {
    mat4 clip_from_world;
    mat4 world_from_clip;
    mat4 sun_from_world;
    mat4 sky_from_world;
    vec4 eye;
    vec4 sun_direction;
    vec4 sun_extent;
    vec4 sky_extent;
    vec4 ground;
    vec4 arrow;
    vec4 quality;
} frame;
