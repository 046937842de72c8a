// Patterns of threads along u (weft) and along v (warp).
struct Weave {
    vec2 slope;   // of the surface along u and v
    float light;  // share of light that reaches the thread's surface, about 1 on average
};

float hash(float n) { return fract(sin(n * 12.9898) * 43758.5453); }

const int plain = 0, twill = 1, knit = 2;  // Threads of scene_renderer.h

// Plain weave: over and under in turn; twill: over two, under two, a step aside in each row. `p` counts threads.
Weave woven(vec2 p, int kind) {
    vec2 cell = floor(p);
    vec2 f = p - cell - 0.5;
    bool warp_on_top = kind == twill ? mod(cell.x + cell.y, 4.0) < 2.0 : mod(cell.x + cell.y, 2.0) < 0.5;
    vec2 across = warp_on_top ? f.xy : f.yx;  // x: across the upper thread, y: along it
    float thread = warp_on_top ? cell.x : cell.y + 311.0;

    Weave result;
    result.slope = vec2(sin(pi * across.x), 0.6 * sin(pi * across.y));
    if (!warp_on_top) result.slope = result.slope.yx;
    float height = cos(pi * across.x) * (0.55 + 0.45 * cos(pi * across.y));
    float side = kind == twill && !warp_on_top ? 0.88 : 1.0;  // denim's white weft lies deeper
    result.light = (0.78 + 0.36 * height) * side * (0.92 + 0.16 * hash(mod(thread, 977.0)));
    return result;
}

// Stockinette: columns of loops that lean to and fro.
Weave knitted(vec2 p) {
    vec2 f = vec2(fract(p.x) - 0.5, p.y);
    float lean = fract(f.y + abs(f.x)) - 0.5;
    Weave result;
    result.slope = vec2(0.9 * sin(2.0 * pi * f.x), 0.5 * sin(2.0 * pi * lean));
    result.light = 0.70 + 0.30 * cos(2.0 * pi * lean) + 0.25 * (1.0 - 4.0 * f.x * f.x);
    return result;
}

// A pattern that is finer than a pixel fades to its average.
Weave weave(vec2 p, int kind) {
    Weave result = kind == knit ? knitted(p) : woven(p, kind);
    vec2 pixel = fwidth(p);
    float coarse = 1.0 - smoothstep(0.10, 0.50, max(pixel.x, pixel.y));
    result.slope *= 0.30 * coarse;
    result.light = mix(1.0, result.light, coarse);
    return result;
}
