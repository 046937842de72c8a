// Two triangles, far larger than the visible ground before it fades into the horizon.
out vec3 point;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    point = frame.ground.xyz + 300.0 * vec3(corner.x, 0.0, -corner.y);
    gl_Position = frame.clip_from_world * vec4(point, 1.0);
}
