// Converts display light to sRGB codes, with a vignette and half a code of noise against bands in the sky.
in vec2 screen;
out vec4 pixel;

uniform sampler2D picture;
uniform vec2 size;  // of the window [pixels]

// The sRGB curve by roots, which take a fraction of a power's time and err by less than half a code.
vec3 srgb(vec3 light) {
    vec3 second = sqrt(light), fourth = sqrt(second), eighth = sqrt(fourth);
    vec3 curve = 0.662002687 * second + 0.684122060 * fourth - 0.323583601 * eighth - 0.0225411470 * light;
    return mix(12.92 * light, curve, step(0.0031308, light));
}

void main() {
    vec3 light = textureLod(picture, gl_FragCoord.xy / size, 0.0).rgb;
    float corner = dot(screen, screen) * 0.5;
    light *= 1.0 - 0.14 * corner * sqrt(corner);
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    pixel = vec4(srgb(light) + (noise - 0.5) / 255.0, 1.0);
}
