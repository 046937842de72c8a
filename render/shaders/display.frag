// Display light to sRGB codes, with a vignette and half a code of noise against bands in the sky.
in vec2 screen;
out vec4 pixel;

uniform sampler2D picture;

vec3 srgb(vec3 light) {
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}

void main() {
    vec3 light = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
    light *= 1.0 - 0.14 * pow(dot(screen, screen) * 0.5, 1.5);
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    pixel = vec4(srgb(light) + (noise - 0.5) / 255.0, 1.0);
}
