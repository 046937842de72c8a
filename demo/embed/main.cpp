// The smallest host: its own loop, a sheet held at two corners, wind, and the buffers that a renderer would
// draw.

#include <weft/weft.h>

#include <cstdio>
#include <cstdlib>

namespace {

// Every call of Weft that can fail returns a value or an error; this host gives up at the first one.
template <class T>
T need(weft::Result<T> result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().message.c_str());
        std::exit(1);
    }
    if constexpr (!std::is_void_v<T>) return *std::move(result);
}

// The position that a game draws: between the particle's last two positions, so that motion is smooth at any
// frame rate.
weft::Vec3 drawn(const weft::ClothView& cloth, std::size_t i, float alpha) {
    const weft::Vec4 &from = cloth.previous_positions[i], &to = cloth.positions[i];
    const auto blend = [alpha](float a, float b) { return a + alpha * (b - a); };
    return {blend(from.x, to.x), blend(from.y, to.y), blend(from.z, to.z)};
}

}  // namespace

int main() {
    weft::WorldSettings settings;
    settings.wind.velocity = {2, 0, 5};
    settings.wind.gust = 0.4f;
    weft::World world = need(weft::World::create(settings));

    weft::SheetSettings shape{
        .rows = 32, .columns = 48, .origin = {0, 2, 0}, .u = {1.5f, 0, 0}, .v = {0, -1, 0}};
    const weft::ClothId sheet = need(world.add_cloth(need(weft::make_sheet(shape))));
    need(world.pin(sheet, 0));
    need(world.pin(sheet, shape.columns - 1));

    // A game measures its frames; this one pretends to run at 144 Hz for five seconds.
    weft::FixedStep clock;
    for (int frame = 0; frame < 5 * 144; ++frame) {
        const weft::FixedStepFrame now = clock.advance(1.0 / 144.0);
        for (int i = 0; i < now.steps; ++i) world.step(static_cast<float>(clock.settings().step));

        const weft::ClothView cloth =
            need(world.cloth(sheet));  // here a renderer uploads cloth.positions as they are
        if (frame % 144 != 143) continue;
        const weft::Vec3 corner = drawn(cloth, cloth.vertex_to_particle.back(), now.alpha);
        std::printf("%d s: free corner at (%.2f, %.2f, %.2f) m\n", frame / 144 + 1,
                    static_cast<double>(corner.x), static_cast<double>(corner.y),
                    static_cast<double>(corner.z));
    }

    const weft::StepReport& report = world.report();
    std::printf("step %llu: %u particles, peak speed %.2f m/s, residual %.3f, %.3f ms\n",
                static_cast<unsigned long long>(report.step), report.particles,
                static_cast<double>(report.peak_speed), static_cast<double>(report.residual),
                static_cast<double>(report.milliseconds));
    for (const weft::StageTime& stage : world.profile())
        std::printf("  %-16s p50 %.3f ms, p95 %.3f ms\n", stage.name, static_cast<double>(stage.p50),
                    static_cast<double>(stage.p95));
    return weft::has(report.flags, weft::StepFlags::state_restored) ? 1 : 0;
}
