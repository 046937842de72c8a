#include "demo/study/study_scenes.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "demo/character/garment/garment_mesh.h"
#include "demo/study/must.h"

namespace weft::study {

namespace {

/// Height of the bump [m], in double precision from the mesh's floats: machines differ by a last bit or so.
float bump(const Vec3& p) {
    const double x = static_cast<double>(p.x) + 0.5, z = static_cast<double>(p.z) + 0.5;
    const double pi = std::numbers::pi;
    const double waves = std::sin(2.3 * pi * x + 0.4) * std::sin(3.1 * pi * z + 0.9) +
                         0.5 * std::sin(5.7 * pi * (x + 0.6 * z) + 1.7);
    return static_cast<float>(1e-4 / 1.5 * waves);
}

}  // namespace

StudyScene hung_sheet(std::uint32_t per_side, bool wind) {
    StudyScene scene;
    scene.name = wind ? "wind" : "hanging";
    scene.per_side = per_side;
    scene.mesh = must(make_sheet({.rows = per_side, .columns = per_side}));
    for (const Vec3& p : scene.mesh.positions) scene.start_positions.push_back({p.x, p.y + bump(p), p.z, 0});
    scene.cloth.method = Jacobi{};
    if (wind)
        scene.world.wind.velocity = {1.0f, 0, 3.0f};
    else
        scene.world.wind.air_density = 0;
    scene.pins = {0, per_side - 1};
    return scene;
}

StudyScene hung_garment(const std::filesystem::path& obj, const std::string& name) {
    StudyScene scene;
    scene.name = name;
    scene.mesh = must(load_obj(obj, {.texcoords_are_pattern = true}));
    demo::drop_unfit_pattern(scene.mesh);
    demo::stand_upright(scene.mesh, 0.45f);
    scene.world.wind.air_density = 0;
    scene.pins = demo::highest_opening(scene.mesh);
    return scene;
}

}  // namespace weft::study
