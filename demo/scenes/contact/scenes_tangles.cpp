// Sheets that pass through themselves or each other from the start, and are to come free.

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "demo/scenes/contact/contact_scene.h"

namespace weft::demo {

namespace {

using std::numbers::pi;

using Eigen::Vector3d;

/// A meander of arc length `length` whose loops overlap: its direction is a sine of an amplitude of more than
/// 2.2 rad (Langbein and Leopold, "River meanders: theory of minimum variance", 1966).
class Meander {
  public:
    Meander(double length, double wave, double angle) : step_(length / count) {
        Eigen::Vector2d at(0, 0);
        for (int k = 0; k <= count; ++k) {
            places_.push_back(at);
            const double direction = angle * std::sin(2 * pi * (k + 0.5) * step_ / wave);
            at += step_ * Eigen::Vector2d(std::cos(direction), std::sin(direction));
        }
    }
    [[nodiscard]] Eigen::Vector2d at(double along) const {
        return places_[static_cast<std::size_t>(std::lround(along / step_))];
    }

  private:
    static constexpr int count = 10000;
    double step_;
    std::vector<Eigen::Vector2d> places_;
};

constexpr double length = 1, width = 0.5;

/// A sheet along the meander. With 4 100 particles some 540 pairs of triangles cross.
Mesh tangled_mesh(const Piece& sheet, const std::function<Vector3d(const Vector3d&)>& turned) {
    const Meander meander(length, 2 * length / 3, 2.32);
    return placed_sheet(sheet, [&](double u, double v) {
        const Eigen::Vector2d at = meander.at(u);
        const double wave = 2e-3 * std::sin(2 * pi * (v / 0.19 + u));
        return turned(Vector3d(at.x() + wave, at.y(), v - width / 2));
    });
}

/// A tangled sheet hung by one end.
ContactScene tangled_hung(std::uint32_t particles) {
    const Piece sheet = piece(length, width, or_else(particles, 4100));
    const auto turned = [](const Vector3d& p) { return Vector3d(p.y(), 1.2 - p.x(), p.z()); };
    return {.name = "tangled hung",
            .seconds = 6,
            .cloths = {{.mesh = tangled_mesh(sheet, turned), .pins = column_of(sheet, 0)}},
            .world = still_air(),
            .holders = {{0, Holder::rod, column_of(sheet, 0)}},
            .tangled = true,
            .rests = true};
}

/// A tangled sheet dropped on the ground.
ContactScene tangled_dropped(std::uint32_t particles) {
    const Piece sheet = piece(length, width, or_else(particles, 4100));
    const auto turned = [](const Vector3d& p) { return Vector3d(p.x(), 0.2 + p.y(), p.z()); };
    return {.name = "tangled dropped",
            .seconds = 6,
            .cloths = {{.mesh = tangled_mesh(sheet, turned)}},
            .colliders = {ground()},
            .world = still_air(),
            .tangled = true,
            .rests = true};
}

/// Two sheets of 0.4 m on the ground, of which the share `part` of one lies under the other. They cross along
/// a straight line.
ContactScene crossed(double part, std::uint32_t particles) {
    constexpr double size = 0.4, turn = 0.07;
    const Piece sheet = piece(size, size, or_else(particles, 2048) / 2);
    const double apart = 1.2 * usual_distance(sheet.edge()), height = 0.006 + 1.5 * apart;
    const Mesh under = level_sheet(sheet, height, 0);
    const Mesh over = placed_sheet(sheet, [&](double u, double v) {
        const double x = u - size / 2, z = v - size / 2;
        return Vector3d(x * std::cos(turn) - z * std::sin(turn),
                        height + apart * std::tanh((u - part * size) / (0.1 * size)),
                        x * std::sin(turn) + z * std::cos(turn));
    });
    return {.name = "crossed " + std::to_string(std::lround(100 * part)),
            .seconds = 6,
            .cloths = {joined({under, over})},
            .colliders = {ground()},
            .world = still_air(),
            .tangled = true,
            .rests = true};
}

SceneMaker crossed_maker(double part, bool quick) {
    return {"crossed " + std::to_string(std::lround(100 * part)), quick,
            [=](std::uint32_t particles) { return crossed(part, particles); }};
}

}  // namespace

std::vector<SceneMaker> tangle_scenes() {
    return {{"tangled hung", true, tangled_hung},
            {"tangled dropped", false, tangled_dropped},
            crossed_maker(0.2, true),
            crossed_maker(0.42, false)};
}

}  // namespace weft::demo
