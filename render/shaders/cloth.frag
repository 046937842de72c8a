// Shades thin woven cloth: two sides, soft terminator, light rim of fibres, transmitted sunlight.
in vec3 point;
in vec3 normal;
in vec2 texcoord;
in vec4 shown;
out vec4 pixel;

uniform vec3 front, back, stripe;
uniform float roughness, sheen, translucency, opacity;
uniform float threads_per_metre, stripe_width, shine, shine_width;
uniform int textured, threads, printed;
uniform sampler2D print;

// Surface vectors along u and v, the longer one of length 1, without stored tangents (Mikkelsen 2010).
struct Axes {
    vec3 u, v;
};

Axes surface_axes(vec3 n) {
    vec3 px = dFdx(point), py = dFdy(point);
    vec2 ux = dFdx(texcoord), uy = dFdy(texcoord);
    vec3 u = cross(py, n) * ux.x + cross(n, px) * uy.x;
    vec3 v = cross(py, n) * ux.y + cross(n, px) * uy.y;
    float scale = inversesqrt(max(max(dot(u, u), dot(v, v)), 1e-20));
    return Axes(u * scale, v * scale);
}

// Threads reflect into a cone about themselves, so that their light lies in a band across them (Kajiya and Kay 1989).
float thread_light(vec3 thread, vec3 half_way) {
    float along = dot(normalize(thread + 1e-6), half_way) / shine_width;
    return exp(-along * along);
}

vec3 striped(vec3 base) {
    float wave = texcoord.x / (2.0 * stripe_width);
    float edge = max(fwidth(wave), 1e-4);
    float from_edge = abs(fract(wave) - 0.5) - 0.25;
    float cover = smoothstep(-0.5 * edge, 0.5 * edge, from_edge);
    return mix(base, stripe, mix(cover, 0.5, smoothstep(0.25, 0.5, edge)));
}

// Sheen: light of protruding fibres at grazing angles (Estevez and Kulla 2017; visibility after Neubelt and Pettineo
// 2013).
float fibre_edge(vec3 n, vec3 to_eye, vec3 to_light) {
    vec3 half_way = normalize(to_eye + to_light);
    float sine = sqrt(max(1.0 - dot(n, half_way) * dot(n, half_way), 0.0));
    float inverse = 1.0 / max(roughness, 0.15);
    float spread = (2.0 + inverse) * pow(sine, inverse) / (2.0 * pi);
    float n_l = max(dot(n, to_light), 0.0), n_v = max(dot(n, to_eye), 0.0);
    return spread * n_l / (4.0 * (n_l + n_v - n_l * n_v) + 1e-3);
}

void main() {
    vec3 to_eye = normalize(frame.eye.xyz - point);
    vec3 to_sun = frame.sun_direction.xyz;
    vec3 smooth_normal = normalize(normal) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 n = smooth_normal;

    vec3 albedo = gl_FrontFacing ? front : back;
    vec3 through = sqrt(front * back);
    if (printed != 0) {
        vec3 ink = texture(print, vec2(texcoord.x, 1.0 - texcoord.y)).rgb;  // the picture's rows begin at the top
        albedo *= ink;
        through *= ink;
    }
    if (textured != 0 && stripe_width > 0.0) {
        albedo = striped(albedo);
        through = striped(through);
    }
    float along_threads = 0.0;
    if (textured != 0 && threads_per_metre > 0.0 && frame.quality.w > 0.0) {
        Axes axes = surface_axes(n);
        Weave fabric = weave(texcoord * threads_per_metre, threads);
        n = normalize(n + fabric.slope.x * axes.u + fabric.slope.y * axes.v);
        albedo *= fabric.light;
        vec3 half_way = normalize(to_eye + to_sun);
        along_threads = shine * (0.7 * thread_light(axes.v, half_way) + 0.3 * thread_light(axes.u, half_way));
    }
    albedo = mix(albedo, shown.rgb, shown.a);
    through = mix(through, shown.rgb, shown.a);

    // Shadows fade at grazing sun, where the cloth's own triangles would cast stairs.
    float grazed = smoothstep(0.02, 0.25, abs(dot(smooth_normal, to_sun)));
    float sun_seen = mix(1.0, sun_visibility(point, smooth_normal), grazed);
    float sky_seen = sky_visibility(point);
    const float wrap = 0.2;
    float n_l = dot(n, to_sun);
    float facing = max(n_l + wrap, 0.0) / (1.0 + wrap);
    float behind = max(-dot(smooth_normal, to_sun), 0.0);

    vec3 light = sun_light * facing * sun_seen + ambient_light(n, sky_seen);
    vec3 lit = albedo * light;
    lit += through * translucency * sun_light * behind * sun_seen;
    lit += sun_light * sun_seen * (1.0 - roughness) * specular(n, to_eye, to_sun, roughness);

    vec3 fibre_color = mix(vec3(1.0), albedo, 0.6);
    lit += (1.0 - shown.a) * along_threads * fibre_color * sun_light * sun_seen * max(n_l, 0.0);
    float across = 1.0 - max(dot(n, to_eye), 0.0), grazing = across * across * across * across;
    lit += sheen * fibre_color * (0.35 * sun_light * sun_seen * fibre_edge(n, to_eye, to_sun) +
                                  0.5 * grazing * ambient_light(n, sky_seen));
    pixel = vec4(tone(lit), opacity);
}
