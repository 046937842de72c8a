layout(location = 0) in vec3 point;
layout(location = 1) in vec4 colour_;

out vec4 colour;

void main() {
    colour = colour_;
    gl_Position = frame.clip_from_world * vec4(point, 1.0);
    gl_Position.z -= 1e-4 * gl_Position.w;  // in front of the surface that the line lies on
}
