// A host names the members that it sets, and leaves out any others: with -Wextra that warns of each member
// left out that has no initialiser of its own.

#include <weft/weft.h>

int main() {
    [[maybe_unused]] const weft::WorldSettings worlds[] = {
        {.gravity = {0, -1.6f, 0}}, {.wind = {.velocity = {1, 0, 0}}},
        {.wind = {.gust = 0.3f}},   {.threads = 2},
        {.executor = {.width = 2}},
    };
    [[maybe_unused]] const weft::ClothSettings cloths[] = {
        {.fabric = {.warp = 100, .weft = 100}},
        {.finite_elements = {.enabled = true}},
        {.method = weft::Multilevel{.passes = 1}},
        {.method = weft::Jacobi{.iterations = 7}},
        {.method = weft::Chebyshev{.iterations = 8}},
        {.method = weft::Fibres{.shear = weft::Fibres::SetSolver::ldlt}},
        {.time_scheme = weft::TimeScheme::bdf2},
        {.substeps = 2},
        {.tethers = {.enabled = true}},
        {.self_collision = {.method = weft::SelfCollisionMethod::contact}},
        {.friction = 0.5f},
    };
    [[maybe_unused]] const weft::Mesh meshes[] = {{.positions = {{0, 0, 0}}}, {.pattern = {{.x = 1}}}};
    [[maybe_unused]] const weft::SheetSettings sheet{.rows = 4};
    [[maybe_unused]] const weft::ObjOptions options{.texcoords_are_pattern = true};
    [[maybe_unused]] const weft::ObjReport noticed{.ignored_lines = 1};
    [[maybe_unused]] const weft::Collider colliders[] = {
        {.shape = weft::Sphere{.radius = 0.1f}},  {.shape = weft::Sphere{.center = {0, 1, 0}}},
        {.shape = weft::Capsule{.a = {0, 1, 0}}}, {.shape = weft::Capsule{.radius = 0.1f}},
        {.shape = weft::Plane{.offset = 1}},      {.friction = 0.1f},
    };
    [[maybe_unused]] const weft::FixedStepSettings clock{.max_steps_per_frame = 2};
    [[maybe_unused]] const weft::FixedStepFrame frame{.steps = 1};
    [[maybe_unused]] const weft::Bounds bounds{.upper = {1, 1, 1}};
    [[maybe_unused]] const weft::StepReport report{.substeps = 2};
    [[maybe_unused]] const weft::ClothInfo info{.particles = 2};
    [[maybe_unused]] const weft::ClothView view{.bounds = {.lower = {1, 1, 1}}};
    [[maybe_unused]] const weft::VertexStreams streams{.normals = {.stride = 32}};
    [[maybe_unused]] const weft::CookProgress progress{.user = nullptr};
    [[maybe_unused]] const weft::Hooks hooks{.log = nullptr};
    [[maybe_unused]] const weft::StageTime stage{.last = 1};
    [[maybe_unused]] const weft::ClothId cloth{.index = 1};
    [[maybe_unused]] const weft::ColliderId collider{.index = 1};
    [[maybe_unused]] const weft::Error error{.message = "none"};
}
