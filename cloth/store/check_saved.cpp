#include "cloth/store/check_saved.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "cloth/budget/ladder.h"
#include "cloth/mesh/coordinates.h"
#include "cloth/motion/moving_frame.h"
#include "cloth/settings/validate.h"
#include "collision/colliders/collider_contacts.h"
#include "engine/memory/list_checks.h"

namespace weft {

namespace {

// Wider limits than those for hosts: frames and bodies may transport objects beyond where hosts may put them.
constexpr float farthest_part = 10 * runaway_distance;  // [m]
constexpr float fastest_part = 1e6f;                    // [m/s]
constexpr float greatest = std::numeric_limits<float>::max();

Error unsound(std::string what) {
    return {ErrorCode::malformed_file,
            "the save holds what no World comes to, though its checksum is right: " + std::move(what)};
}
Result<void> sound_or(bool sound, const std::string& of, const char* what) {
    if (!sound) return unsound(of + what);
    return {};
}

/// Reads numbers and checks them. They are copied to an aligned buffer, piece by piece.
class SavedNumbers {
  public:
    explicit SavedNumbers(const SaveReader& reader) : reader_(reader) {}

    [[nodiscard]] bool within(std::size_t count, float limit) const {
        return check_all(count, limit, [](std::span<float>) {});
    }
    [[nodiscard]] bool rows_within(std::size_t rows, float limit) const { return within(4 * rows, limit); }
    /// rows_within(), without the rows' last components.
    [[nodiscard]] bool places_within(std::size_t rows, float limit) const {
        return check_all(4 * rows, limit, [](std::span<float> chunk) {
            for (std::size_t k = 3; k < chunk.size(); k += 4) chunk[k] = 0;
        });
    }
    template <class T>
    [[nodiscard]] T one() const {
        T value{};
        reader_(std::span(&value, 1));
        return value;
    }
    void skip(std::size_t bytes) const { reader_.skip(bytes); }

  private:
    template <class Prepare>
    [[nodiscard]] bool check_all(std::size_t count, float limit, const Prepare& prepare) const {
        std::array<float, 1024> room;
        bool sound = true;
        for (std::size_t left = count; left > 0;) {
            const std::span<float> chunk(room.data(), std::min(left, room.size()));
            reader_(chunk);
            prepare(chunk);
            sound = are_within(chunk, limit) && sound;
            left -= chunk.size();
        }
        return sound;
    }
    const SaveReader& reader_;
};

bool is_within(const Vec3& v, float limit) {
    return are_within(std::array{v.x, v.y, v.z}, limit);
}

/// Whether a collider is valid; one that a body moved may be farther out than the host may put it.
bool is_sound(const Collider& collider) {
    if (validate(collider)) return true;
    if (std::holds_alternative<Plane>(collider.shape)) return false;
    const Vec3 at = std::visit(
        []<class Kind>(const Kind& shape) {
            if constexpr (requires { shape.center; })
                return shape.center;
            else if constexpr (requires { shape.position; })
                return shape.position;
            else if constexpr (requires { shape.a; })
                return shape.a;
            else
                return Vec3{};
        },
        collider.shape);
    return is_within(at, farthest_part) &&
           validate(moved(collider, {.shift = -to_vector(at).cast<double>()})).ok();
}

/// Whether the byte of is_trigger is that of a bool.
bool has_sound_trigger(const Collider& collider) {
    std::uint8_t byte = 0;
    std::memcpy(&byte, &collider.is_trigger, 1);
    return byte <= 1;
}

Result<void> check_pins(const std::string& name, const ClothHead& head, const SavedNumbers& numbers) {
    std::uint32_t least = 0;
    for (std::uint32_t k = 0; k < head.pins; ++k) {
        const auto particle = numbers.one<std::uint32_t>();
        const auto target = numbers.one<Vec3>();
        if (particle < least || particle >= head.particles)
            return unsound(name + "pin " + std::to_string(k) + " holds particle " + std::to_string(particle) +
                           "; it must be from " + std::to_string(least) + " to " +
                           std::to_string(head.particles - 1));
        if (!is_within(target, farthest_part))
            return unsound(name + "pin " + std::to_string(k) + " has a target that is no place");
        least = particle + 1;
    }
    return {};
}

Result<void> check_frame(const std::string& name, const FrameState& frame) {
    const auto is_pose = [](const Transform& pose) {
        return validate_transform("pose", pose).ok() && is_within(pose.translation, farthest_part);
    };
    return sound_or(is_pose(frame.pose) && is_pose(frame.target) && is_within(frame.velocity, fastest_part) &&
                        is_within(frame.velocity_change, fastest_part),
                    name, "its frame is none");
}

/// Checks the values of the record that BDF2 reads: none but h if h is 0.
Result<void> check_record(const std::string& name, const ClothHead& head, const SavedNumbers& numbers) {
    const auto h = numbers.one<float>();
    const bool steps = numbers.rows_within(head.record, farthest_part);
    const bool changes = numbers.rows_within(head.record, fastest_part);
    const bool arrivals = numbers.places_within(head.record, farthest_part);
    const bool is_length = h >= 0 && h <= greatest_rate * greatest_step;
    return sound_or(is_length && (h == 0 || (steps && changes && arrivals)), name,
                    "its last step is none that can be gone on from");
}

Result<void> check_held(const std::string& name, const ClothState& here, std::size_t bodies,
                        const SavedNumbers& numbers) {
    const bool normals = numbers.rows_within(here.held.normals.size(), greatest);
    const bool rubbed = numbers.within(here.held.rubbed.size(), greatest);
    const bool loads = numbers.rows_within(here.held.loads.size(), greatest);
    numbers.skip(here.held.touching.span().size_bytes());
    const bool shares = numbers.within(bodies * (sizeof(BodyShare) / sizeof(float)), greatest);
    return sound_or(normals && rubbed && loads && shares, name,
                    "what colliders and bodies gave it is no number");
}

Result<void> check_detail(const std::string& name, const ClothHead& head, const SavedNumbers& numbers) {
    const auto detail = numbers.one<DetailState>();
    const bool ahead = numbers.places_within(head.detail, farthest_part);
    if (detail.rung >= rung_count)
        return unsound(name + "its rung is " + std::to_string(detail.rung) + "; it must be from 0 to " +
                       std::to_string(rung_count - 1));
    if (detail.phase >= greatest_rate && detail.phase != DetailState::no_phase)
        return unsound(name + "its long steps begin at " + std::to_string(detail.phase) +
                       "; it must be below " + std::to_string(greatest_rate));
    if (detail.rate < 1 || detail.rate > greatest_rate || detail.left > detail.rate)
        return unsound(name + "its step is " + std::to_string(detail.rate) + " long, of which " +
                       std::to_string(detail.left) + " are left; it must be from 1 to " +
                       std::to_string(greatest_rate));
    return sound_or(detail.left == 0 || ahead, name, "where it is to move on to is no place");
}

Result<void> check_skin(const std::string& name, const ClothState& here, const SavedNumbers& numbers) {
    const bool known = numbers.one<std::uint32_t>() <= 1;
    const bool places = numbers.rows_within(2 * here.skin.places.size(), farthest_part);
    const bool normals = numbers.rows_within(2 * here.skin.normals.size(), 2);
    return sound_or(known && places && normals, name, "its skin is no place");
}

Result<void> check_rest(const std::string& name, const Rest& rest) {
    return sound_or(std::isfinite(rest.still_for) && rest.still_for >= 0 && rest.asleep <= 1, name,
                    "the time of its rest is none");
}

Result<void> check_tangles(const std::string& name, const ClothState& here, const SavedNumbers& numbers) {
    bool sound = true;
    for (std::size_t i = 0; i < here.tangles.size(); ++i) {
        const auto its = numbers.one<TangleMemory>();
        sound = sound && its.steps <= TangleMemory::steps_remembered && its.votes <= 1 &&
                std::isfinite(its.stalled) && its.stalled >= 0;
    }
    const auto may_cross = numbers.one<std::uint32_t>(), halved = numbers.one<std::uint32_t>();
    return sound_or(sound && may_cross <= 1 && halved <= ClothState::most_halved, name,
                    "its tangles are none that a step leaves");
}

}  // namespace

Result<void> check_world_part(const Simulation& here, const SaveReader& reader) {
    WorldState read = here.state;
    for_each_part(read, reader);
    bool sound = std::isfinite(read.time);
    for (const double way : read.wind_path) sound = sound && std::isfinite(way);
    if (!sound) return unsound("the time, or the way of the wind, is no number");
    std::size_t number = 0;
    Result<void> checked;
    const auto check = [&](bool good, const char* what) {
        if (checked) checked = sound_or(good, what + std::to_string(number), " is none");
        ++number;
    };
    read.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        const bool are_bools = has_sound_trigger(slot.current) && has_sound_trigger(slot.target);
        check(are_bools && is_sound(slot.current) && is_sound(slot.target), "its collider ");
    });
    number = 0;
    read.bodies.for_each(
        [&](BodyId, const BodySlot& slot) { check(validate(slot.state).ok(), "the state of its body "); });
    number = 0;
    read.seams.for_each([&](SeamId, const SeamState& seam) {
        check(std::ranges::all_of(seam.holds, [](std::uint32_t holds) { return holds <= 1; }), "its seam ");
    });
    number = 0;
    for (const std::uint32_t level : read.levels)
        check(level < here.garments[number].levels.size(), "the level of its garment ");
    return checked;
}

Result<void> check_shape_part(std::size_t number, const ShapeHead& head, const SaveReader& reader) {
    if (head.displacements != head.vertices)
        return unsound("its shape " + std::to_string(number) + " has " + std::to_string(head.vertices) +
                       " vertices, of which " + std::to_string(head.displacements) + " have a way");
    const SavedNumbers numbers(reader);
    const std::size_t coordinates = 3 * std::size_t{head.vertices};
    const bool places = numbers.within(coordinates, farthest_part);
    const bool ways = numbers.within(coordinates, farthest_part);
    return sound_or(places && ways, "its shape " + std::to_string(number), " has a vertex that is no place");
}

// In the order of for_each_part().
Result<void> check_cloth_part(const std::string& cloth, const ClothHead& head, const ClothState& here,
                              std::size_t bodies, const SaveReader& reader) {
    const std::string name = "in " + cloth + " ";
    const SavedNumbers numbers(reader);
    if (!numbers.places_within(2 * std::size_t{head.particles}, farthest_part))
        return unsound(name + "a particle is at no place");
    if (!numbers.rows_within(head.particles, fastest_part))
        return unsound(name + "a particle has no velocity");
    if (!numbers.rows_within(head.particles, 2)) return unsound(name + "a particle has no normal");
    if (auto pins = check_pins(name, head, numbers); !pins) return pins;
    if (head.frame != 0)
        if (auto frame = check_frame(name, numbers.one<FrameState>()); !frame) return frame;
    if (auto record = check_record(name, head, numbers); !record) return record;
    if (auto held = check_held(name, here, bodies, numbers); !held) return held;
    if (head.rest != 0)
        if (auto rest = check_rest(name, numbers.one<Rest>()); !rest) return rest;
    if (here.detail)
        if (auto detail = check_detail(name, head, numbers); !detail) return detail;
    if (here.skin.places.size() > 0)
        if (auto skin = check_skin(name, here, numbers); !skin) return skin;
    if (here.tangles.size() > 0) return check_tangles(name, here, numbers);
    return {};
}

}  // namespace weft
