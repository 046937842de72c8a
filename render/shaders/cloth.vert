// Each vertex reads its particle, so that the simulation's buffers are uploaded as they are and a seam of the
// texture may have two vertices on one particle.
layout(location = 0) in uint particle;
layout(location = 1) in vec2 texcoord_;

uniform sampler2D positions;
uniform sampler2D previous_positions;
uniform sampler2D normals;
uniform sampler2D colours;
uniform int coloured;
uniform mat4 clip;
uniform float alpha;

out vec3 point;
out vec3 normal;
out vec2 texcoord;
out vec4 shown;

void main() {
    ivec2 texel = ivec2(int(particle & 1023u), int(particle >> 10));  // ParticleTexture::width
    point = mix(texelFetch(previous_positions, texel, 0).xyz, texelFetch(positions, texel, 0).xyz, alpha);
    normal = texelFetch(normals, texel, 0).xyz;
    texcoord = texcoord_;
    shown = coloured != 0 ? texelFetch(colours, texel, 0) : vec4(0.0);
    gl_Position = clip * vec4(point, 1.0);
}
