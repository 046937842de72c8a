// Matt clay with a soft highlight.
in vec3 point;
in vec3 normal;
out vec4 pixel;

uniform vec3 color;

void main() {
    vec3 n = normalize(normal);
    vec3 to_eye = normalize(frame.eye.xyz - point);
    vec3 to_sun = frame.sun_direction.xyz;
    float sun_seen = sun_visibility(point, n);
    float sky_seen = sky_visibility(point);

    vec3 light = sun_light * max(dot(n, to_sun), 0.0) * sun_seen + ambient_light(n, sky_seen);
    float rim = pow(1.0 - max(dot(n, to_eye), 0.0), 4.0);
    vec3 lit = color * light + sun_light * sun_seen * specular(n, to_eye, to_sun, 0.5) +
               0.12 * rim * sky_light * sky_seen;
    pixel = vec4(tone(lit), 1.0);
}
