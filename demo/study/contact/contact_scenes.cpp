#include "demo/study/contact/contact_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>

#include "demo/character/garment/garment_mesh.h"
#include "demo/must.h"
#include "demo/scenes/contact/contact_scene.h"

namespace weft::study {

std::vector<SceneMaker> all_contact_scenes() {
    std::vector<SceneMaker> all = demo::contact_scenes();
    std::ranges::move(garment_scenes(), std::back_inserter(all));
    return all;
}

// Garments hung up and swung: folds that beat against each other.

namespace {

using demo::still_air;
using demo::to_point;
using std::numbers::pi;

using Eigen::Vector3d;

Mesh garment(const std::string& file) {
    const char* folder = std::getenv("WEFT_DATA");
    if (folder == nullptr) throw std::runtime_error("WEFT_DATA is not set: there are no garments");
    Mesh mesh =
        must(load_obj(std::filesystem::path(folder) / "garments" / file, {.texcoords_are_pattern = true}));
    demo::drop_unfit_pattern(mesh);
    demo::stand_upright(mesh, 0.45f);
    return mesh;
}

/// The vertices of the topmost 3 % of the mesh's height.
std::vector<std::uint32_t> topmost(const Mesh& mesh) {
    const auto [low, high] = std::ranges::minmax(mesh.positions, {}, [](const Vec3& p) { return p.y; });
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i].y > high.y - 0.03f * (high.y - low.y)) vertices.push_back(i);
    return vertices;
}

/// Position of a pin: two seconds at rest, four swung to and fro and turned about +Y, then at rest again.
Vec3 swung(const Vec3& start, double time) {
    constexpr double begins = 2, lasts = 4, soft = 0.5;
    const double since = std::clamp(time - begins, 0.0, lasts);
    const double part = std::min({1.0, since / soft, (lasts - since) / soft});
    const double aside = 0.3 * part * std::sin(2 * pi * since),
                 turn = 1.2 * part * std::sin(2 * pi * since / 1.6);
    const Vector3d p = Eigen::Vector3f(start.x, start.y, start.z).cast<double>();
    return to_point({p.x() * std::cos(turn) + p.z() * std::sin(turn) + aside, p.y(),
                     p.z() * std::cos(turn) - p.x() * std::sin(turn)});
}

using Hold = std::vector<std::uint32_t> (*)(const Mesh&);

ContactScene swung_garment(const std::string& name, const std::string& file, Hold hold) {
    ContactScene scene{.name = name, .seconds = 8, .world = still_air(), .rests = true};
    scene.cloths = {{.mesh = garment(file)}};
    PlacedCloth& cloth = scene.cloths[0];
    cloth.pins = hold(cloth.mesh);
    std::vector<Vec3> starts;
    for (const std::uint32_t vertex : cloth.pins) starts.push_back(cloth.mesh.positions[vertex]);
    scene.move = [pins = cloth.pins, starts](const SceneHandles& handles, double time) {
        for (std::size_t k = 0; k < pins.size(); ++k) handles.move_pin(0, pins[k], swung(starts[k], time));
    };
    return scene;
}

SceneMaker garment_maker(const std::string& name, const std::string& file, Hold hold, bool quick) {
    return {name, quick, [=](std::uint32_t) { return swung_garment(name, file, hold); }, true};
}

}  // namespace

std::vector<SceneMaker> garment_scenes() {
    return {garment_maker("dress swung", "dress-victor-iso-draped.obj", topmost, true),
            garment_maker("skirt swung", "skirt-iso.obj", demo::highest_opening, false)};
}

}  // namespace weft::study
