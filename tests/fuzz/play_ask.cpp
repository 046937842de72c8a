// All that a host can ask of a World: it changes nothing, and holds together.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <thread>

#include "tests/fuzz/player.h"

namespace weft::fuzz {

namespace {

bool is_finite_point(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool draws_finite_things(const World& world) {
    bool are_finite = true;
    const DebugCanvas canvas{
        .user = &are_finite,
        .line = [](void* all, const Vec3& from, const Vec3& to,
                   const Vec3&) { *static_cast<bool*>(all) &= is_finite_point(from) && is_finite_point(to); },
        .text = [](void* all, const Vec3& at, const char* words,
                   const Vec3&) { *static_cast<bool*>(all) &= is_finite_point(at) && *words != '\0'; }};
    world.debug_draw(canvas, DebugParts::all);
    return are_finite;
}

}  // namespace

Player::Answered Player::make(const Operation& operation, const Ask&) {
    if (!options_.checked) return std::nullopt;
    const std::string before = snapshot_now();
    ask_of_world();
    if (is_there(operation.cloth)) ask_of_cloth(*cloths_[operation.cloth]);
    check(snapshot_now() == before, "a question changed the World");
    return std::nullopt;
}

void Player::ask_of_world() {
    check(!world_.describe().value().empty() && !world_.describe(DescriptionFormat::json).value().empty(),
          "nothing is described");
    check(draws_finite_things(world_), "something is drawn at no place");
    check(!world_.profile().empty(), "no stage is timed");
    static_cast<void>(world_.write_trace("/dev/null"));  // refused where no trace was started
    const std::array<Vec3, 3> points{{{}, {1, 2, 3}, {-9e4f, 5, 9e4f}}};
    std::array<Vec3, 3> air{};
    check(world_.sample_air(points, air).ok() && std::ranges::all_of(air, is_finite_point),
          "air that is not finite");
    check(!world_.sample_air(points, std::span(air).first(2)), "more points than velocities");
    for (const auto& body : bodies_) {
        if (!body) continue;
        const auto state = world_.body_state(*body);
        check(state.ok() == world_.body_settings(*body).ok(), "a body that is half there");
        check(!state || is_finite_point(state->position), "a body that is nowhere");
    }
    for (const auto& shape : shapes_)
        if (shape) static_cast<void>(world_.shape_info(*shape));
}

void Player::ask_of_cloth(ClothId id) {
    const ClothView view = world_.cloth(id).value();
    check(world_.is_asleep(id).value() == world_.cloth_report(id)->asleep, "asleep and awake");
    std::array<StrainedEdge, 16> strained;
    const std::uint32_t count = world_.strained_edges(id, -0.5f, strained).value();
    check(std::ranges::is_sorted(std::span(strained).first(count), std::ranges::greater(),
                                 &StrainedEdge::strain),
          "the most strained edges are not the first");

    const Vec3& corner = view.bounds.lower;
    if (const auto nearest =
            world_.closest_point(corner, std::numeric_limits<float>::infinity(), id).value()) {
        check(nearest->cloth == id && nearest->triangle < view.triangles.size(), "a place on no cloth");
        const Vec3& there = nearest->position;
        const Vec3 way{there.x - corner.x, there.y - corner.y, there.z - corner.z};
        const auto hit = world_.cast_ray(corner, way, std::numeric_limits<float>::infinity(), id);
        check(!hit || !*hit || (*hit)->distance >= 0.99f * nearest->distance - 1e-3f,
              "a ray meets what is nearer than the nearest place");
    }

    const std::size_t vertices = view.vertex_to_particle.size();
    std::vector<Vec3> of_kind[4];
    for (auto& kind : of_kind) kind.assign(vertices, {});
    const auto stream = [](std::vector<Vec3>& to) {
        return VertexStream{std::as_writable_bytes(std::span(to))};
    };
    check(world_
              .write_vertices(id, {.positions = stream(of_kind[0]),
                                   .previous_positions = stream(of_kind[1]),
                                   .normals = stream(of_kind[2]),
                                   .previous_normals = stream(of_kind[3])})
              .ok(),
          "its vertices were refused");
    for (const auto& kind : of_kind)
        check(std::ranges::all_of(kind, is_finite_point), "a vertex is written that is not finite");

    // A vertex that no triangle has may be out of reach.
    const auto drawn = DrawnMesh::bind(view, {.vertices = of_kind[0], .triangles = view.vertex_triangles});
    if (!drawn) return;
    std::vector<Vec4> positions(vertices), normals(vertices);
    drawn->update(view, {.positions = positions, .normals = normals});
    for (const auto& rows : {positions, normals})
        check(std::ranges::all_of(rows,
                                  [](const Vec4& row) {
                                      return is_finite_point({row.x, row.y, row.z});
                                  }),
              "a drawn vertex that is not finite");
}

/// A step in three: one thread takes it, another one reads meanwhile what the last step left.
void Player::step_apart(float dt, bool is_refused) {
    const auto begun = world_.begin_step(dt);
    check(begun.ok() != is_refused, begun ? "an invalid step was begun" : begun.error().message);
    if (!begun) return;
    bool was_taken = false;
    {
        const std::jthread worker([&] { was_taken = world_.work().ok(); });
        read_beside_work();
    }
    check(was_taken, "a step that was begun is not taken");
    check(!world_.work(), "a step was taken twice");
    check(world_.end_step().ok(), "a step that was taken does not end");
    check(!world_.end_step(), "a step ended twice");
}

void Player::read_beside_work() {
    bool are_right = !world_.begin_step(1.0f / 60) &&
                     has(world_.step(1.0f / 60).flags, StepFlags::step_under_way) &&
                     world_.save_size() == 0 && world_.contacts().empty() && !world_.describe() &&
                     world_.report().step == steps_ && world_.settings().substeps > 0;
    for (std::size_t i = 0; i < cloths_.size(); ++i) {
        if (!cloths_[i]) continue;
        are_right &= !world_.pin(*cloths_[i], 0);
        const auto view = world_.cloth(*cloths_[i]);
        if (!view) continue;
        for (const Vec4& p : view->positions) are_right &= std::isfinite(p.x + p.y + p.z);
        std::vector<Vec3> places(view->vertex_to_particle.size());
        are_right &=
            world_.write_vertices(*cloths_[i], {.positions = {std::as_writable_bytes(std::span(places))}})
                .ok();
    }
    check(are_right, "beside work() a call answers otherwise than it is documented to");
}

}  // namespace weft::fuzz
