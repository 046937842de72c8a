in vec2 screen;
out vec4 color;

void main() {
    vec4 far_point = frame.world_from_clip * vec4(screen, 1.0, 1.0);
    color = vec4(tone(sky_color(normalize(far_point.xyz / far_point.w - frame.eye.xyz))), 1.0);
}
