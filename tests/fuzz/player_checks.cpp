// Conditions that hold after each call.

#include <algorithm>
#include <cmath>

#include "tests/fuzz/player.h"
#include "tests/fuzz/text.h"

namespace weft::fuzz {

namespace {

bool is_finite(const Vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

float length(const Vec4& v) {
    return std::hypot(v.x, v.y, v.z);
}

}  // namespace

void Player::check_answer(const Operation& operation, const Result<void>& answer,
                          const std::string& before) const {
    const bool stale = operation.cloth != Operation::no_cloth && !is_there(operation.cloth) &&
                       !std::holds_alternative<AddCloth>(operation.call) &&
                       !std::holds_alternative<RemoveCloth>(operation.call);
    if (answer) {
        check(operation.answer != Answer::refused && !stale, "was accepted and must be refused");
        return;
    }
    check(operation.answer != Answer::accepted || stale, "was refused: " + answer.error().message);
    check(!answer.error().message.empty(), "was refused without a word");
    const std::string after = snapshot_now();
    check(after == before,
          "failed (" + answer.error().message + ") and changed the World from\n" + before + "to\n" + after);
}

void Player::check_vertices(std::size_t cloth, const ClothView& view) const {
    if (view.texcoords.empty()) return;
    std::vector<Vec4> tangents(view.vertex_to_particle.size());
    const auto written =
        world_.write_vertices(*cloths_[cloth], {.tangents = {std::as_writable_bytes(std::span(tangents))}});
    check(written.ok(), "cloth " + std::to_string(cloth) + ": its tangents were refused");
    const bool are_sound = std::ranges::all_of(tangents, [](const Vec4& t) {
        return std::abs(std::hypot(t.x, t.y, t.z) - 1) < 1e-3f && std::abs(t.w) == 1;
    });
    check(are_sound, "cloth " + std::to_string(cloth) + ": a tangent that is not of unit length");
}

void Player::check_cloth(std::size_t cloth) const {
    const ClothView view = world_.cloth(*cloths_[cloth]).value();
    const ClothInfo info = world_.cloth_info(*cloths_[cloth]).value();
    const auto of = [&](const char* what) { return "cloth " + std::to_string(cloth) + ": " + what; };
    check(view.positions.size() == info.particles && view.velocities.size() == info.particles &&
              view.previous_positions.size() == info.particles && view.normals.size() == info.particles,
          of("buffers are not of its particles"));
    check(std::isfinite(info.mass), of("a mass that is not finite"));
    check(std::ranges::all_of(view.positions, is_finite),
          of("a position or inverse mass that is not finite"));
    check(std::ranges::all_of(view.previous_positions, is_finite),
          of("a previous position that is not finite"));
    check(std::ranges::all_of(view.velocities, is_finite), of("a velocity that is not finite"));
    check(std::ranges::all_of(view.normals, is_finite), of("a normal that is not finite"));
    check_vertices(cloth, view);
    const Vec3 &lower = view.bounds.lower, &upper = view.bounds.upper;
    for (const Vec4& p : view.positions) {
        const bool within = p.x >= lower.x && p.x <= upper.x && p.y >= lower.y && p.y <= upper.y &&
                            p.z >= lower.z && p.z <= upper.z;
        check(within, of("a position out of its bounds: ") + text_of(Vec3{p.x, p.y, p.z}));
    }
    for (const auto& [i, target] : pins_[cloth])
        check(view.positions[i].w == 0, of("a pin that is not pinned"));
}

void Player::check_step(const StepReport& report, std::uint64_t steps_before) const {
    check(report.step == steps_before + 1, "the report counts another number of steps");
    check(!has(report.flags, StepFlags::invalid_dt), "dt is valid, and flags say otherwise");
    check(!has(report.flags, StepFlags::crossed), "cloth went through cloth");
    std::uint32_t cloths = 0, sleeping = 0, particles = 0;
    for (std::size_t i = 0; i < cloths_.size(); ++i) {
        if (!is_there(i)) continue;
        const ClothReport own = world_.cloth_report(*cloths_[i]).value();
        if (!own.enabled) continue;
        ++cloths;
        if (own.asleep) {
            ++sleeping;
            continue;
        }
        const ClothView view = world_.cloth(*cloths_[i]).value();
        particles += static_cast<std::uint32_t>(view.positions.size());
        // A cloth that was restored stands where the step began, its pins where they are told.
        if (!has(report.flags, StepFlags::state_restored)) check_pins(i);
        const float most = world_.settings().max_speed * 1.00001f;
        for (const Vec4& v : view.velocities)
            check(length(v) <= most, "cloth " + std::to_string(i) + ": " + text_of(length(v)) +
                                         " m/s, and max_speed is " + text_of(world_.settings().max_speed));
    }
    check(report.cloths == cloths && report.sleeping_cloths == sleeping && report.particles == particles,
          "the report counts other cloths");
    check(report.restored_cloths <= cloths, "more cloths restored than there are");
    check((report.restored_cloths > 0) == has(report.flags, StepFlags::state_restored),
          "the flag and the count of restored cloths differ");
    check_contacts(report);
    check_seams(report);
    for (const BodyImpulse& impulse : world_.body_impulses()) {
        const auto state = world_.body_state(impulse.body);
        check(state.ok(), "an impulse of no body");
        for (const Vec3& v :
             {impulse.linear, impulse.angular, state->position, state->velocity, state->angular_velocity})
            check(is_finite(Vec4{v.x, v.y, v.z}), "a body that is not finite");
    }
}

void Player::check_contacts(const StepReport& report) const {
    const std::span<const Contact> contacts = world_.contacts();
    const auto room = static_cast<std::size_t>(world_.settings().contact_reports);
    const std::size_t most = std::min<std::size_t>(room, report.contacts);
    check(contacts.size() == most || (contacts.size() < most && report.restored_cloths > 0),
          std::to_string(contacts.size()) + " contacts of " + std::to_string(report.contacts));
    for (const Contact& c : contacts) {
        check(world_.cloth(c.cloth).ok(), "a contact of no cloth");
        check(world_.cloth(c.other_cloth).ok() != world_.collider(c.collider).ok(), "a contact with nothing");
        check(std::abs(length(Vec4{c.normal.x, c.normal.y, c.normal.z}) - 1) < 1e-4f,
              "a contact's normal is " + text_of(c.normal));
        for (const Vec3& v : {c.point, c.impulse})
            check(is_finite(Vec4{v.x, v.y, v.z}), "a contact that is not finite");
    }
}

void Player::check_pins(std::size_t cloth) const {
    const ClothView view = world_.cloth(*cloths_[cloth]).value();
    for (const auto& [i, target] : pins_[cloth]) {
        const Vec4& p = view.positions[i];
        // By impact zones beside cloth by contact, too: both are cut.
        const SelfCollision self = world_.cloth_settings(*cloths_[cloth]).value().self_collision;
        const bool may_lag = meets_cloth(self.method);
        if (may_lag && world_.cloth_report(*cloths_[cloth])->pin_lag > 0) continue;  // cloth was in its way
        check(p.x == target.x && p.y == target.y && p.z == target.z,
              "cloth " + std::to_string(cloth) + ": particle " + std::to_string(i) + " is pinned at " +
                  text_of(target) + " and lies at " + text_of(Vec3{p.x, p.y, p.z}));
    }
}

}  // namespace weft::fuzz
