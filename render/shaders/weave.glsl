// Plain weave: threads along u (weft) and along v (warp) pass over each other in turn.
struct Weave {
    vec2 slope;   // of the surface along u and v
    float light;  // how much light reaches the thread's surface, about 1 on average
};

float hash(float n) { return fract(sin(n * 12.9898) * 43758.5453); }

// `p` counts threads. What is smaller than a pixel fades to the average.
Weave weave(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = p - cell - 0.5;
    bool warp_on_top = mod(cell.x + cell.y, 2.0) < 0.5;
    vec2 across = warp_on_top ? f.xy : f.yx;  // x: across the upper thread, y: along it
    float thread = warp_on_top ? cell.x : cell.y + 311.0;

    vec2 slope = vec2(sin(3.14159 * across.x), 0.6 * sin(3.14159 * across.y));
    float height = cos(3.14159 * across.x) * (0.55 + 0.45 * cos(3.14159 * across.y));
    float tint = 0.92 + 0.16 * hash(mod(thread, 977.0));

    vec2 pixel = fwidth(p);
    float coarse = 1.0 - smoothstep(0.10, 0.50, max(pixel.x, pixel.y));
    Weave result;
    result.slope = coarse * 0.30 * (warp_on_top ? slope.xy : slope.yx);
    result.light = mix(1.0, (0.78 + 0.36 * height) * tint, coarse);
    return result;
}
