// Bends the unit sphere of CapsuleMesh into the capsule from end_a to end_b.
layout(location = 0) in vec4 unit;  // normal along the axis +Y; w: which end

uniform mat4 clip;
uniform vec3 end_a, end_b;
uniform float radius;

out vec3 point;
out vec3 normal;

void main() {
    vec3 along = end_b - end_a;
    float length_ = length(along);
    vec3 axis = length_ > 1e-6 ? along / length_ : vec3(0.0, 1.0, 0.0);
    vec3 side = normalize(cross(axis, abs(axis.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0)));
    normal = unit.x * side + unit.y * axis + unit.z * cross(side, axis);
    point = mix(end_a, end_b, unit.w) + radius * normal;
    gl_Position = clip * vec4(point, 1.0);
}
