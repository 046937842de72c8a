// Visibility of the sun and of the sky from a point; ambient light and highlights.
uniform sampler2DShadow sun_compare;
uniform sampler2D sun_depth;
uniform sampler2D sky_depth;

const float pi = 3.14159265;

// A direction per pixel whose neighbours differ evenly: interleaved gradient noise (Jimenez 2014).
vec2 pixel_direction() {
    float angle = 2.0 * pi * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return vec2(cos(angle), sin(angle));
}

// Taps lie on a sunflower's spiral (Vogel 1979): each direction is the last one turned by the golden angle, and the
// radius grows so that the disc is covered evenly.
const mat2 golden_turn = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);
float tap_radius(int i, float count) { return sqrt((float(i) + 0.5) / count); }

const float nothing = 0.99999;  // greater depths are empty texels; the ground may lie deeper than the map

// True if p lies in the map or within `reach` of it.
bool near_map(vec2 p, float reach) { return all(greaterThan(p, vec2(-reach))) && all(lessThan(p, vec2(1.0 + reach))); }

// Average over the 2 x 2 pixels that are shaded together, whose angles differ: four times as many taps at no cost.
float quad_average(float value) {
    vec2 odd = mod(floor(gl_FragCoord.xy), 2.0) - 0.5;
    value -= dFdx(value) * odd.x;
    return value - dFdy(value) * odd.y;
}

// Size of a pixel on the surface [m], at most 0.05. The centre of a pixel at a triangle's edge may lie outside the
// triangle by half of that, and below the adjoining cloth.
float pixel_size(vec3 point) { return min(max(length(dFdx(point)), length(dFdy(point))), 0.05); }

// Slope of the sun's depth along the surface, per unit of the map. Taps aside follow this plane, so that the surface
// does not shadow itself (Isidoro 2006). The slope is bounded: it is infinite on a surface along the light.
vec2 surface_slope(vec3 normal) {
    vec3 scale = vec3(frame.sun_extent.x, frame.sun_extent.x, frame.sun_extent.y);
    vec3 n = mat3(frame.sun_from_world) * normal * scale * scale;
    vec2 slope = -n.xy / (abs(n.z) > 1e-6 ? n.z : 1e-6);
    float steepest = 6.0 * scale.x / scale.z;
    return slope * min(1.0, steepest / max(length(slope), 1e-6));
}

// Soft shadow whose edge widens with the distance of the blocker (Fernando 2005). `normal` may face away from the sun:
// either side of a thin cloth is lifted towards the sun, so that a sheet never shadows itself.
float sun_visibility(vec3 point, vec3 normal) {
    const float sun_size = 0.09;  // edge's width per distance of the blocker: a far softer sun than the real one
    const float widest = 0.25;    // [m]: radius of the search for blockers
    float texel = frame.sun_extent.z;
    float facing = dot(normal, frame.sun_direction.xyz);
    float pixel = pixel_size(point);
    float lift = texel * (1.0 + 1.5 * (1.0 - abs(facing))) + 0.5 * pixel;
    vec3 lifted = point + normal * sign(facing) * lift;
    vec3 p = (frame.sun_from_world * vec4(lifted, 1.0)).xyz;
    float bias = texel / frame.sun_extent.y;
    vec2 slope = surface_slope(normal);
    int count = near_map(p.xy, widest / frame.sun_extent.x) ? 1 : 0;  // a loop that ends at once is cheap where a branch is not

    // No blocker lies beyond the map's near side, which bounds the search.
    vec2 turned = pixel_direction();
    vec2 search = turned * min(p.z * frame.sun_extent.y * sun_size, widest) / frame.sun_extent.x;
    float gap = 0.0;
    float found = 0.0;
    float searches = frame.quality.x, taps = frame.quality.y;
    for (int i = 0; i < int(searches) * count; ++i) {
        search = golden_turn * search;
        // The first tap lies straight towards the sun, so that a blocker there is found, however small.
        vec2 aside = search * sqrt(float(i) / searches);
        float depth = textureLod(sun_depth, p.xy + aside, 0.0).r;
        float before = p.z + dot(slope, aside) - bias - depth;
        float blocked = step(0.0, before) * step(depth, nothing);
        gap += blocked * before;
        found += blocked;
    }
    // Average over four pixels: at the edge's fringe one pixel alone may find the blocker, and would stand out. With
    // coarse derivatives, one for all four, the result is no average and may be negative.
    float found_by_four = quad_average(found);
    float blocker_distance = frame.sun_extent.y * max(quad_average(gap), 0.0) / max(found_by_four, 0.25);
    bool lit = count == 0 || (searches > 0.0 && max(found, found_by_four) <= 0.0);

    // Least width of the edge. At grazing light triangles show in an edge that is narrower than they are.
    float least = (3.0 + 9.0 * (1.0 - abs(facing))) * texel;
    float width = max(blocker_distance * sun_size, least);
    vec2 offset = turned * width / frame.sun_extent.x;
    float seen = 0.0;
    for (int i = 0; i < int(lit ? 0.0 : taps); ++i) {
        offset = golden_turn * offset;
        vec2 aside = offset * tap_radius(i, taps);
        float reference = min(p.z + dot(slope, aside), 1.0) - bias;
        seen += textureLod(sun_compare, vec3(p.xy + aside, reference), 0.0);
    }
    seen = lit ? 1.0 : seen / taps;
    // Edges narrower than some pixels are not averaged: the 2 x 2 blocks would show as stairs.
    return mix(seen, quad_average(seen), smoothstep(1.5, 6.0, width / max(pixel, 1e-6)));
}

// Share of the sky that no surface above hides, within `reach`: contact shadows and the darkness inside of folds.
float sky_visibility(vec3 point) {
    float taps = frame.quality.z;
    const float reach = 0.30;  // [m]
    vec3 p = (frame.sky_from_world * vec4(point, 1.0)).xyz;
    vec2 offset = pixel_direction() * reach / frame.sky_extent.x;
    float hidden = 0.0;
    float least = frame.sky_extent.z + 0.5 * pixel_size(point);
    int count = near_map(p.xy, reach / frame.sky_extent.x) ? int(taps) : 0;
    for (int i = 0; i < count; ++i) {
        offset = golden_turn * offset;
        float radius = tap_radius(i, taps);
        float depth = textureLod(sky_depth, p.xy + offset * radius, 0.0).r;
        float above = max((p.z - depth) * frame.sky_extent.y - least, 0.0);
        float fall_off = reach * reach / (reach * reach + above * above);
        hidden += step(depth, nothing) * fall_off * above / (above + 0.25 * reach * radius + 1e-4);
    }
    return quad_average(1.0 - 0.85 * hidden / max(taps, 1.0));
}

// Ambient light of the sky and the ground on a surface that faces `normal`.
vec3 ambient_light(vec3 normal, float sky_seen) {
    return mix(ground_light * (0.4 + 0.6 * sky_seen), sky_light * sky_seen, 0.5 + 0.5 * normal.y);
}

// Microfacet highlight (Walter 2007, Schlick 1994) with a fixed reflectance of 4 %.
float specular(vec3 normal, vec3 to_eye, vec3 to_sun, float roughness) {
    vec3 half_way = normalize(to_eye + to_sun);
    float a = max(roughness, 0.08) * max(roughness, 0.08), a2 = a * a;
    float n_h = max(dot(normal, half_way), 0.0);
    float n_l = max(dot(normal, to_sun), 0.0);
    float n_v = max(dot(normal, to_eye), 1e-3);
    float base = n_h * n_h * (a2 - 1.0) + 1.0;
    float away = 1.0 - max(dot(to_eye, half_way), 0.0), twice = away * away;
    float fresnel = 0.04 + 0.96 * twice * twice * away;
    float visible = n_l / (n_l * (n_v * (1.0 - 0.5 * roughness) + 0.5 * roughness) * 4.0 + 1e-3);
    return fresnel * a2 / (base * base) * visible * n_l;
}
