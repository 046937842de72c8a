// The colours of the day: linear light, in units in which a white surface facing the sun is a little over 1.
const vec3 sun_light = vec3(1.60, 1.40, 1.12);
const vec3 sky_light = vec3(0.38, 0.425, 0.50);
const vec3 ground_light = vec3(0.42, 0.37, 0.315);

const vec3 horizon_color = vec3(1.00, 1.08, 1.13);
const vec3 zenith_color = vec3(0.04, 0.24, 0.72);

// Glow about the sun: the sixth and the ninetieth power of the cosine of the angle to the sun.
vec3 sun_glow(vec3 direction) {
    float first = max(dot(direction, frame.sun_direction.xyz), 0.0);
    float second = first * first, fourth = second * second, eighth = fourth * fourth;
    float sixteenth = eighth * eighth, thirty_second = sixteenth * sixteenth;
    float ninetieth = thirty_second * thirty_second * sixteenth * eighth * second;
    return vec3(1.0, 0.75, 0.45) * (0.10 * fourth * second + 0.35 * ninetieth);
}

vec3 sky_color(vec3 direction) {
    float height = max(direction.y, 0.0);
    return mix(zenith_color, horizon_color, exp(-6.0 * height)) + sun_glow(direction);
}
