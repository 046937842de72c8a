// A studio floor with a line each metre, that fades into the horizon; the wind's arrow lies on it.
in vec3 point;
out vec4 color;

const vec3 floor_color = vec3(0.47, 0.465, 0.455);
const vec3 arrow_color = vec3(0.02, 0.26, 0.50);

// Share of a pixel that lines of `width` [m], one each metre, cover. A narrower line is drawn a pixel wide and fainter.
float grid_lines(vec2 p, float width) {
    vec2 pixel = fwidth(p);
    vec2 drawn = max(vec2(width), pixel);
    vec2 away = abs(fract(p - 0.5) - 0.5);
    vec2 lines = (1.0 - smoothstep(0.5 * drawn - 0.5 * pixel, 0.5 * drawn + 0.5 * pixel, away)) * (width / drawn);
    lines *= 1.0 - smoothstep(0.2, 0.5, pixel);
    return max(lines.x, lines.y);
}

// Signed distance to an arrow along +X of the given length, its foot at the origin.
float arrow_distance(vec2 p, float length_) {
    const float shaft = 0.018, head = 0.16, head_half = 0.075;
    float along = length_ - head;
    vec2 q = vec2(max(max(-p.x, p.x - along), 0.0), max(abs(p.y) - shaft, 0.0));
    float to_shaft = length(q);
    vec2 slope = normalize(vec2(head_half, head));
    float to_head = max(dot(vec2(p.x - length_, abs(p.y)), slope), along - p.x);
    return min(to_shaft, to_head);
}

float arrow_cover(vec2 p) {
    float length_ = length(frame.arrow.zw);
    vec2 axis = frame.arrow.zw / max(length_, 1e-6);
    vec2 from_foot = p - frame.arrow.xy;
    float away = arrow_distance(vec2(dot(from_foot, axis), dot(from_foot, vec2(-axis.y, axis.x))), length_);
    float pixel = max(fwidth(away), 1e-5);
    return length_ > 0.0 ? 1.0 - smoothstep(-0.5 * pixel, 0.5 * pixel, away - 0.004) : 0.0;
}

void main() {
    vec3 from_eye = point - frame.eye.xyz;
    vec3 direction = normalize(from_eye);
    const vec3 up = vec3(0.0, 1.0, 0.0);

    vec3 albedo = mix(floor_color, floor_color * 0.62, grid_lines(point.xz, 0.008));
    albedo = mix(albedo, arrow_color, 0.9 * arrow_cover(point.xz));

    float sun_seen = sun_visibility(point, up);
    vec3 light = sun_light * max(frame.sun_direction.y, 0.0) * sun_seen +
                 sky_light * sky_visibility(point);
    vec3 lit = albedo * light;
    lit += sun_light * sun_seen * 0.6 * specular(up, -direction, frame.sun_direction.xyz, 0.55);

    float away = distance(point.xz, frame.ground.xz);
    float far = away / frame.ground.w;
    float haze = 1.0 - exp(-far * sqrt(far * sqrt(far)));
    vec3 horizon = horizon_color + sun_glow(normalize(vec3(direction.x, 0.0, direction.z)));
    color = vec4(tone(mix(lit, horizon, haze)), 1.0);
}
