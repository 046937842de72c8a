#include "tests/guarantees/method_cases.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <utility>
#include <variant>

namespace weft::test {

namespace {

constexpr float time_step = 1.0f / 60.0f;
constexpr float lowering_speed = 2.0f;  // [m/s]
constexpr float width = 0.6f;           // of the sheet [m]

[[noreturn]] void give_up(const Error& error) {  // nothing is thrown: WebAssembly's library has no exceptions
    std::fprintf(stderr, "%s\n", error.message.c_str());
    std::abort();
}

template <class T>
T need(Result<T> result) {
    if (!result) give_up(result.error());
    return *std::move(result);
}
void need(const Result<void>& result) {
    if (!result) give_up(result.error());
}

struct NamedSettings {
    const char* name;
    ClothSettings settings;
};

/// Soft enough for the explicit method in the substeps that it has here.
std::vector<NamedSettings> methods() {
    const auto with = [](const Method& method, int substeps = 1) {
        ClothSettings settings;
        settings.fabric = {.areal_density = 0.2f, .warp = 100, .weft = 100, .shear = 25, .bending = 2e-5f};
        settings.method = method;
        settings.substeps = substeps;
        return settings;
    };
    return {
        {"multilevel", with(Multilevel{})},
        {"jacobi", with(Jacobi{})},
        {"chebyshev", with(Chebyshev{})},
        {"conjugate_gradient", with(ConjugateGradient{})},
        {"xpbd", with(Xpbd{}, 2)},
        {"fibres", with(Fibres{})},
        {"symplectic_euler", with(SymplecticEuler{}, 24)},
    };
}

bool takes_elements(const Method& method) {
    return is_implicit(method) || std::holds_alternative<SymplecticEuler>(method);
}

void add_options(const NamedSettings& method, std::vector<MethodCase>& cases) {
    const MethodCase plain{.name = method.name, .cloth = method.settings, .world = {}};
    const auto add = [&](const char* option, const auto&... changes) {
        MethodCase& made = cases.emplace_back(plain);
        made.name += option;
        (changes(made), ...);
    };
    const auto bdf2 = [](MethodCase& c) { c.cloth.time_scheme = TimeScheme::bdf2; };
    const auto tethers = [](MethodCase& c) { c.cloth.tethers.enabled = true; };
    const auto self = [](MethodCase& c) {
        c.cloth.self_collision = {.method = SelfCollisionMethod::avoidance};
    };
    const auto contact = [](MethodCase& c) {
        c.cloth.self_collision = {.method = SelfCollisionMethod::contact};
    };
    const auto zones = [](MethodCase& c) {
        c.cloth.self_collision = {.method = SelfCollisionMethod::impact_zones};
    };
    const auto filter = [](MethodCase& c) {
        c.cloth.self_collision = {.method = SelfCollisionMethod::avoidance_by_sorted_sweep};
        c.cloth.collider_response = ColliderResponse::velocity_filter;
    };
    const auto gusts = [](MethodCase& c) {
        c.world.wind.velocity = {0, 0, 3};
        c.world.wind.gust = 0.5f;
    };
    const auto mesh = [](MethodCase& c) { c.grid = false; };
    const auto elements = [](MethodCase& c) { c.cloth.finite_elements.enabled = true; };
    const auto hinges = [](MethodCase& c) { c.cloth.finite_elements.dihedral = true; };
    const auto consistent = [](MethodCase& c) { c.cloth.finite_elements.consistent_mass = true; };

    const auto reports = [](MethodCase& c) { c.world.contact_reports = 100; };

    add("");
    add("_mesh", mesh);
    add("_tethers", tethers);
    add("_self", self);
    add("_contact", contact);
    add("_zones", zones);
    add("_sweep_filter", filter);
    add("_reports", self, reports);
    if (std::holds_alternative<Multilevel>(method.settings.method)) add("_contact_reports", contact, reports);
    add("_gusts", gusts);
    if (!takes_elements(method.settings.method)) return add("_mesh_all", mesh, tethers, self, gusts);
    add("_elements", elements);
    add("_hinges", elements, hinges);
    if (!is_implicit(method.settings.method))
        return add("_mesh_all", mesh, tethers, self, gusts, elements, hinges);
    add("_consistent", elements, consistent);
    add("_bdf2", bdf2);
    add("_mesh_all", mesh, bdf2, tethers, self, gusts, elements, hinges, consistent);
}

}  // namespace

bool is_implicit(const Method& method) {
    return !std::holds_alternative<Xpbd>(method) && !std::holds_alternative<Fibres>(method) &&
           !std::holds_alternative<SymplecticEuler>(method);
}

void PrintTo(const MethodCase& method_case, std::ostream* out) {
    *out << method_case.name;
}

std::vector<MethodCase> method_cases() {
    std::vector<MethodCase> cases;
    for (const NamedSettings& method : methods()) add_options(method, cases);
    return cases;
}

PinPattern corners(std::uint32_t side) {
    return {"corners", {0, side - 1}};
}

std::vector<PinPattern> pin_patterns(std::uint32_t side) {
    PinPattern none{"none", {}}, row{"row", {}}, rows{"two_rows", {}}, random{"random", {}};
    for (std::uint32_t c = 0; c < side; ++c) row.vertices.push_back(c);
    rows.vertices = row.vertices;
    for (std::uint32_t c = 0; c < side; ++c) rows.vertices.push_back((side - 1) * side + c);
    std::mt19937 draw(11);
    for (std::uint32_t v = 0; v < side * side; ++v)
        if (draw() % 10 < 3) random.vertices.push_back(v);
    return {none, corners(side), row, rows, random};
}

Mesh LoweredSheet::mesh(bool grid, std::uint32_t side) {
    Mesh mesh = need(make_sheet({.rows = side,
                                 .columns = side,
                                 .origin = {-0.5f * width, width + 0.02f, 0},
                                 .u = {width, 0, 0},
                                 .v = {0, -width, 0}}));
    if (!grid) mesh.rows = mesh.columns = 0;
    return mesh;
}

LoweredSheet::LoweredSheet(const MethodCase& method_case, int threads, std::uint32_t side,
                           const PinPattern& pins)
    : world_([&] {
          WorldSettings settings = method_case.world;
          settings.threads = threads;
          return need(World::create(settings));
      }()),
      cloth_(need(world_.add_cloth(mesh(method_case.grid, side), method_case.cloth))) {
    const Mesh start = mesh(method_case.grid, side);
    for (const std::uint32_t vertex : pins.vertices) pins_.emplace_back(vertex, start.positions[vertex]);
    need(world_.pin(cloth_, pins.vertices));
    need(world_.add_collider({.shape = Plane{}, .friction = 0.6f}));
    need(world_.add_collider({.shape = Sphere{{0, 0, 0.05f}, 0.1f}, .friction = 0.4f}));
}

// None is let down into the ground.
void LoweredSheet::before_step() {
    if (lowered_ < width) lowered_ += lowering_speed * time_step;
    for (const auto& [vertex, start] : pins_) {
        const float y = std::max(start.y + 0.02f - lowered_, 0.02f);
        need(world_.move_pin(cloth_, vertex, {start.x, y, start.z + 0.3f * lowered_}));
    }
}

const StepReport& LoweredSheet::step() {
    return world_.step(time_step);
}

}  // namespace weft::test
