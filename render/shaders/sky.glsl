// The colours of the day: linear light, in units in which a white surface facing the sun is a little over 1.
const vec3 sun_light = vec3(2.35, 2.10, 1.75);
const vec3 sky_light = vec3(0.50, 0.60, 0.76);
const vec3 ground_light = vec3(0.30, 0.27, 0.25);

const vec3 horizon_color = vec3(0.80, 0.85, 0.90);
const vec3 zenith_color = vec3(0.17, 0.33, 0.58);

vec3 sky_color(vec3 direction) {
    float height = max(direction.y, 0.0);
    vec3 color = mix(horizon_color, zenith_color, 1.0 - exp(-2.6 * height));
    float toward_sun = max(dot(direction, frame.sun_direction.xyz), 0.0);
    return color + vec3(1.0, 0.75, 0.45) * (0.10 * pow(toward_sun, 6.0) + 0.35 * pow(toward_sun, 90.0));
}
