// Bends the unit sphere of CapsuleMesh into the capsule from end_a to end_b, and the cube of BoxMesh into the
// box about end_a.
layout(location = 0) in vec4 unit;  // xyz: normal, of a capsule along +Y; w: its end (0 or 1), or 2 for a box
layout(location = 1) in vec3 corner;  // corner of the box

uniform mat4 clip;
uniform vec3 end_a, end_b;
uniform float radius_a, radius_b;
uniform vec3 box_x, box_y, box_z;

out vec3 point;
out vec3 normal;

const float quarter = 1.5707963;

/// Normal on a tapered capsule: its end spheres are cut where they touch the cone, not at their equators.
vec3 on_tapered(vec3 n, float end, float tilt) {
    float cut = -asin(clamp(tilt, -1.0, 1.0)), latitude = asin(clamp(n.y, -1.0, 1.0));
    float bent = end < 0.5 ? mix(-quarter, cut, latitude / quarter + 1.0) : mix(cut, quarter, latitude / quarter);
    float across = length(n.xz);
    return vec3((across > 1e-6 ? n.xz / across : vec2(1.0, 0.0)) * cos(bent), sin(bent)).xzy;
}

void main() {
    if (unit.w > 1.5) {
        point = end_a + corner.x * box_x + corner.y * box_y + corner.z * box_z;
        normal = normalize(unit.x * box_x + unit.y * box_y + unit.z * box_z);
    } else {
        vec3 along = end_b - end_a;
        float length_ = length(along);
        vec3 axis = length_ > 1e-6 ? along / length_ : vec3(0.0, 1.0, 0.0);
        vec3 side = normalize(cross(axis, abs(axis.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0)));
        vec3 n = unit.xyz;
        if (radius_a != radius_b) n = on_tapered(n, unit.w, (radius_b - radius_a) / max(length_, 1e-6));
        normal = n.x * side + n.y * axis + n.z * cross(side, axis);
        point = mix(end_a, end_b, unit.w) + mix(radius_a, radius_b, unit.w) * normal;
    }
    gl_Position = clip * vec4(point, 1.0);
}
