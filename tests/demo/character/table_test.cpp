// What somebody dressed costs and how well it is worn: WEFT_CHARACTER_TABLE=SECONDS prints a row for each
// motion and garment, of so much time; WEFT_CHARACTER_SKIN has the skin met.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "demo/character/character.h"
#include "demo/character/garment/wear.h"
#include "demo/study/crossings/crossings.h"
#include "tests/demo/garments.h"

namespace weft::demo {
namespace {

constexpr float frame = 1.0f / 60;

double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

float at_part(std::vector<float>& values, double part) {
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, at);
    return *at;
}

void print_row(const char* name, const CharacterSettings& settings, double seconds) {
    auto made = Character::create(settings);
    ASSERT_TRUE(made.ok()) << made.error().message;
    Character character = std::move(*made);
    WorldSettings of_world;
    of_world.threads = 1;
    if (const char* const substeps = std::getenv("WEFT_CHARACTER_SUBSTEPS"))
        of_world.substeps = std::atoi(substeps);
    of_world.wind.velocity = {0, 0, -1.2f};
    auto world = World::create(of_world);
    ASSERT_TRUE(character.enter(*world).ok());
    WearMeter meter(character.garment().mesh, settings.cloth.thickness);
    std::vector<float> times, stretch_99;
    std::size_t crossed = 0, inside_frames = 0, squeezes = 0, unsolved = 0;
    float deepest = 0, deepest_excused = 0, worst_stretch = 0;
    const int frames = static_cast<int>(60 * seconds);
    for (int f = 0; f < frames; ++f) {
        character.before_step(*world, f / 60.0, frame);
        const double before = processor_ms();
        unsolved += has(world->step(frame).flags, StepFlags::unsolved);
        times.push_back(static_cast<float>(processor_ms() - before));
        const ClothView& view = *world->cloth(character.cloth());
        const auto wear = meter.measure(view, character.capsules());
        if (f / 60.0 < character.dressed_after()) continue;
        deepest_excused = std::max(deepest_excused, wear.deepest);
        deepest = std::max(deepest, wear.deepest_of_these);
        inside_frames += wear.inside > 0;
        squeezes += wear.squeezed > 0;
        stretch_99.push_back(wear.stretch_99);
        worst_stretch = std::max(worst_stretch, wear.stretch);
        if (f % 10 != 0) continue;
        study::TriangleSoup soup;
        soup.add(view);
        crossed = std::max<std::size_t>(crossed, study::count_crossings(soup).all);
    }
    std::printf(
        "| %s, %u | %.2f; %u, %.0f | %.2f, %.2f | %zu; %.1f, %.1f | %zu | %zu | %.3f, %.3f; %.2f | %zu |\n",
        name, world->cloth_info(character.cloth())->particles, static_cast<double>(character.fitted().girth),
        character.fitted().inside, 1e3 * static_cast<double>(character.fitted().deepest),
        static_cast<double>(at_part(times, 0.5)), static_cast<double>(at_part(times, 0.99)), inside_frames,
        1e3 * static_cast<double>(deepest), 1e3 * static_cast<double>(deepest_excused), squeezes, crossed,
        static_cast<double>(at_part(stretch_99, 0.5)), static_cast<double>(at_part(stretch_99, 1)),
        static_cast<double>(worst_stretch), unsolved);
    std::fflush(stdout);
}

TEST(CharacterTable, Prints) {
    const char* const wanted = std::getenv("WEFT_CHARACTER_TABLE");
    if (wanted == nullptr) GTEST_SKIP() << "set WEFT_CHARACTER_TABLE to seconds";
    WEFT_NEEDS_DATA();
    const char* const only = std::getenv("WEFT_CHARACTER_ONLY");
    std::printf(
        "| motion, garment, particles | girth; inside at the start, mm | step p50, p99 ms of processor | "
        "frames "
        "with triangles inside; deepest mm, excused too | frames with squeezes | crossings | stretch p99 "
        "median, worst; worst | unsolved |\n");
    for (const char* garment : {"", "tshirt-iso", "skirt-iso", "dress-victor-iso-draped"}) {
        for (const char* motion : {"", "walk", "run"}) {
            for (const double speed : {1.0, 2.0}) {
                const std::string name = std::string(*motion ? motion : "own walk") + " x" +
                                         (speed > 1 ? "2" : "1") + " " + (*garment ? garment : "dress");
                if (only != nullptr && name.find(only) == std::string::npos) continue;
                CharacterSettings settings;
                if (*motion) settings.motion = data_folder() / "motion" / (std::string(motion) + ".bvh");
                if (*garment) settings.garment = data_folder() / "garments" / (std::string(garment) + ".obj");
                settings.speed = speed;
                if (std::getenv("WEFT_CHARACTER_SKIN") != nullptr) settings.surface = BodySurface::skin;
                settings.cloth.fabric.areal_density = 0.16f;
                settings.cloth.self_collision.method = SelfCollisionMethod::contact;
                print_row(name.c_str(), settings, std::atof(wanted));
            }
        }
    }
}

}  // namespace
}  // namespace weft::demo
