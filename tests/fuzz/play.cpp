#include "tests/fuzz/play.h"

#include <algorithm>
#include <exception>
#include <tuple>

#include "cloth/motion/rigid_motion.h"
#include "collision/shapes/collider_motion.h"
#include "tests/fuzz/player.h"
#include "tests/fuzz/recording.h"
#include "tests/fuzz/text.h"

namespace weft::fuzz {

namespace {

template <class... Calls>
struct Overloaded : Calls... {
    using Calls::operator()...;
};
template <class... Calls>
Overloaded(Calls...) -> Overloaded<Calls...>;

}  // namespace

void Player::call(const Operation& operation) {
    // A cloth whose mesh was refused has no id.
    const bool adds = std::holds_alternative<AddCloth>(operation.call);
    if (operation.cloth != Operation::no_cloth && !adds && !cloths_[operation.cloth])
        return leave_out(operation);
    const std::string before = snapshot_now();
    const auto cloth = [&] { return *cloths_[operation.cloth]; };
    const Overloaded make_call{
        [&](const SetEnabled& call) -> Answered { return world_.set_enabled(cloth(), call.on); },
        [&](const Wake&) -> Answered { return world_.wake(cloth()); },
        [&](const SetImportance& call) -> Answered {
            return world_.set_importance(cloth(), call.importance);
        },
        [&](const Detach& call) -> Answered { return world_.detach(cloth(), call.vertices); },
        [&](const SetFrame& call) -> Answered { return world_.set_frame(cloth(), call.pose); },
        [&](const LeaveFrame&) -> Answered { return world_.leave_frame(cloth()); },
        [&](const auto& call) { return make(operation, call); }};
    const Answered answer = std::visit(make_call, operation.call);
    if (answer) check_answer(operation, *answer, before);
    for (std::size_t i = 0; options_.checked && i < cloths_.size(); ++i)
        if (is_there(i)) check_cloth(i);
}

/// Objects that are not made keep their places among their like.
void Player::leave_out(const Operation& operation) {
    if (std::holds_alternative<SaveCloth>(operation.call)) cloth_saves_.emplace_back();
    if (std::holds_alternative<Stitch>(operation.call)) seams_.emplace_back();
}

/// After a step a cloth may have been looked for as far as its greatest speed leads.
void Player::note_reach(const Operation& operation) {
    constexpr float farthest_contact = 25;  // two of the greatest thickness, and distance [m]
    const auto* const step = std::get_if<Step>(&operation.call);
    const bool moves = step != nullptr && operation.answer != Answer::refused;
    const float way = farthest_contact + (moves ? world_.settings().max_speed * step->dt : 0);
    for (std::size_t i = 0; i < cloths_.size(); ++i) {
        if (!is_there(i)) continue;
        const ClothView view = world_.cloth(*cloths_[i]).value();
        const auto add = [&](float& lower, float& upper, float low, float high) {
            const bool is_first = lower > upper;
            lower = is_first ? low - way : std::min(lower, low - way);
            upper = is_first ? high + way : std::max(upper, high + way);
        };
        Reached& reached = reached_[i];
        add(reached.lower.x, reached.upper.x, view.bounds.lower.x, view.bounds.upper.x);
        add(reached.lower.y, reached.upper.y, view.bounds.lower.y, view.bounds.upper.y);
        add(reached.lower.z, reached.upper.z, view.bounds.lower.z, view.bounds.upper.z);
    }
}

Result<ClothId> Player::add(const AddCloth& call) {
    if (!call.cooked) return world_.add_cloth(call.mesh, call.settings);
    const Result<CookedCloth> made = CookedCloth::create(call.mesh, call.settings);
    if (!made) return made.error();
    const Result<CookedCloth> cooked = saved_and_read(*made, call.settings, call.damage);
    if (!cooked) return cooked.error();
    return world_.add_cloth(*cooked, {.translation = call.place});
}

Player::Answered Player::make(const Operation& operation, const AddCloth& call) {
    const auto added = add(call);
    if (!added) return added.error();
    cloths_[operation.cloth] = *added;
    check(text_of(world_.cloth_settings(*added).value()) == text_of(call.settings),
          "settings are not those given");
    return Result<void>();
}

Player::Answered Player::make(const Operation&, const MeasureCloth& call) {
    const std::string before = snapshot_now();
    const auto measured = world_.measure_cloth(call.mesh, call.settings);
    check(snapshot_now() == before, "measuring changed the World");
    if (!measured) return measured.error();
    return Result<void>();
}

Player::Answered Player::make(const Operation& operation, const RemoveCloth&) {
    const bool was_there = is_there(operation.cloth);
    const Result<void> answer = world_.remove_cloth(*cloths_[operation.cloth]);
    check(answer.ok() == was_there, "removing a cloth that is there must work, and once only");
    check(!is_there(operation.cloth), "the cloth is still there");
    return std::nullopt;
}

Player::Answered Player::make(const Operation& operation, const SetClothSettings& call) {
    const auto answer = world_.set_cloth_settings(*cloths_[operation.cloth], call.settings);
    if (answer)
        check(text_of(world_.cloth_settings(*cloths_[operation.cloth]).value()) == text_of(call.settings),
              "settings are not those given");
    return answer;
}

Player::Answered Player::make(const Operation& operation, const Pin& call) {
    const auto answer = world_.pin(*cloths_[operation.cloth], call.vertices);
    if (!answer) return answer;
    const ClothView view = world_.cloth(*cloths_[operation.cloth]).value();
    for (const std::uint32_t vertex : call.vertices) {
        const std::uint32_t i = view.vertex_to_particle[vertex];
        const Vec4& p = view.positions[i];
        pins_[operation.cloth].try_emplace(i, Vec3{p.x, p.y, p.z});
    }
    return answer;
}

Player::Answered Player::make(const Operation& operation, const MovePin& call) {
    const auto answer = world_.move_pin(*cloths_[operation.cloth], call.vertex, call.target);
    if (!is_there(operation.cloth)) return answer;
    auto& pins = pins_[operation.cloth];
    const auto pin = pins.find(particle(operation.cloth, call.vertex));
    if (operation.answer == Answer::either)
        check(answer.ok() == (pin != pins.end()), "moves what is pinned, and nothing else");
    if (answer && pin != pins.end()) pin->second = call.target;
    return answer;
}

Player::Answered Player::make(const Operation& operation, const Unpin& call) {
    const auto answer = world_.unpin(*cloths_[operation.cloth], call.vertices);
    if (!answer) return answer;
    for (const std::uint32_t vertex : call.vertices)
        pins_[operation.cloth].erase(particle(operation.cloth, vertex));
    return answer;
}

Player::Answered Player::make(const Operation&, const AddCollider& call) {
    const auto added = world_.add_collider(resolved(call.collider));
    colliders_.push_back(added ? std::optional(*added) : std::nullopt);
    if (!added) return added.error();
    return Result<void>();
}

Player::Answered Player::make(const Operation& operation, const MoveCollider& call) {
    const auto& id = colliders_[call.collider];
    if (!id) return std::nullopt;
    const bool there = world_.collider(*id).ok();
    const auto answer = world_.move_collider(*id, resolved(call.target));
    check(there || !answer, "a collider that was removed was moved");
    if (!there) return std::nullopt;
    if (is_carried(call.collider)) {
        check(!answer, "a collider that a body carries was moved");
        return std::nullopt;
    }
    // An extreme collider is refused where it is added, and then its moves have nothing to move.
    return answer || operation.answer == Answer::refused ? Answered(answer) : std::nullopt;
}

Player::Answered Player::make(const Operation& operation, const PlaceCollider& call) {
    const auto& id = colliders_[call.collider];
    if (!id) return std::nullopt;
    const bool there = world_.collider(*id).ok();
    const Collider place = resolved(call.place);
    const auto answer = world_.place_collider(*id, place);
    check(there || !answer, "a collider that was removed was placed");
    if (!there || is_carried(call.collider)) return std::nullopt;
    if (answer)
        check(text_of(world_.collider(*id).value()) == text_of(normalized(place)),
              "it is not where it was placed");
    return answer || operation.answer == Answer::refused ? Answered(answer) : std::nullopt;
}

Player::Answered Player::make(const Operation&, const RemoveCollider& call) {
    const auto& id = colliders_[call.collider];
    if (!id) return std::nullopt;
    const bool there = world_.collider(*id).ok();
    check(world_.remove_collider(*id).ok() == there,
          "removing a collider that is there must work, and once only");
    return std::nullopt;
}

Player::Answered Player::make(const Operation&, const AddBody& call) {
    const auto added = world_.add_body(call.settings, call.state);
    bodies_.push_back(added ? std::optional(*added) : std::nullopt);
    if (!added) return added.error();
    check(world_.body_settings(*added)->mass == call.settings.mass, "settings are not those given");
    return Result<void>();
}

Player::Answered Player::make(const Operation&, const SetBody& call) {
    const auto& id = bodies_[call.body];
    if (!id) return std::nullopt;
    const auto set = world_.set_body_settings(*id, call.settings);
    return set ? Answered(world_.set_body_state(*id, call.state)) : Answered(set);
}

Player::Answered Player::make(const Operation&, const RemoveBody& call) {
    const auto& id = bodies_[call.body];
    if (!id) return std::nullopt;
    const bool there = world_.body_state(*id).ok();
    check(world_.remove_body(*id).ok() == there, "removing a body that is there must work, and once only");
    return std::nullopt;
}

Player::Answered Player::make(const Operation&, const AttachCollider& call) {
    const auto& body = bodies_[call.body];
    const auto& collider = colliders_[call.collider];
    if (!body || !collider) return std::nullopt;
    const auto answer = world_.attach_collider(*body, *collider);
    if (answer) carried_[call.collider] = call.body;
    return answer;
}

Player::Answered Player::make(const Operation&, const DetachCollider& call) {
    const auto& collider = colliders_[call.collider];
    if (!collider) return std::nullopt;
    const auto answer = world_.detach_collider(*collider);
    if (answer) carried_.erase(call.collider);
    return answer;
}

Player::Answered Player::make(const Operation& operation, const Attach& call) {
    const auto& body = bodies_[call.body];
    if (!body) return std::nullopt;
    return world_.attach(*body, *cloths_[operation.cloth], call.vertices);
}

Player::Answered Player::make(const Operation&, const SetWorldSettings& call) {
    const WorldSettings settings = with_threads(call.settings);
    const auto answer = world_.set_settings(settings);
    if (answer) check(text_of(world_.settings()) == text_of(settings), "settings are not those given");
    return answer;
}

Player::Answered Player::make(const Operation& operation, const MoveCloth& call) {
    const auto answer = world_.move_cloth(*cloths_[operation.cloth], call.by);
    if (answer)
        for (auto& [i, target] : pins_[operation.cloth]) target = rigid_motion(call.by).point(target);
    return answer;
}

Player::Answered Player::make(const Operation& operation, const ResetCloth& call) {
    const ClothId cloth = *cloths_[operation.cloth];
    const auto answer =
        call.velocities.empty()
            ? world_.reset_cloth(cloth, call.positions)
            : world_.resume_cloth(cloth, call.positions, call.previous_positions, call.velocities);
    if (!answer) return answer;
    const ClothView view = *world_.cloth(cloth);
    for (auto& [i, target] : pins_[operation.cloth]) {
        const Vec4& there = view.positions[i];
        target = {there.x, there.y, there.z};
    }
    return answer;
}

Player::Answered Player::make(const Operation& operation, const SetMap& call) {
    const auto answer = world_.set_map(*cloths_[operation.cloth], call.map, call.values);
    if (!answer || call.map != Map::pin) return answer;
    auto& pins = pins_[operation.cloth];
    const ClothView view = world_.cloth(*cloths_[operation.cloth]).value();
    std::map<std::uint32_t, Vec3> now;
    for (std::uint32_t v = 0; v < call.values.size(); ++v) {
        if (call.values[v] < 0.5f) continue;
        const std::uint32_t i = view.vertex_to_particle[v];
        const Vec4& p = view.positions[i];
        const auto before = pins.find(i);
        now.try_emplace(i, before != pins.end() ? before->second : Vec3{p.x, p.y, p.z});
    }
    pins = std::move(now);
    return answer;
}

Player::Answered Player::make(const Operation& operation, const SetSkin& call) {
    const auto place = [&](std::uint32_t i) {
        const Vec4& p = world_.cloth(*cloths_[operation.cloth]).value().positions[i];
        return Vec3{p.x, p.y, p.z};
    };
    auto& pins = pins_[operation.cloth];
    std::vector<std::uint32_t> still;
    if (world_.cloth(*cloths_[operation.cloth]).ok())
        for (const auto& [i, target] : pins)
            if (const Vec3 p = place(i); p.x == target.x && p.y == target.y && p.z == target.z)
                still.push_back(i);
    const auto answer = world_.set_skin(*cloths_[operation.cloth], call.places, call.normals);
    // A first skin may take the whole cloth along, and pins that stand still with it.
    if (answer)
        for (const std::uint32_t i : still) pins[i] = place(i);
    return answer;
}

Player::Answered Player::make(const Operation&, const ShiftOrigin& call) {
    const auto answer = world_.shift_origin(call.to);
    if (answer)
        for (auto& pins : pins_)
            for (auto& [i, p] : pins) p = {p.x - call.to.x, p.y - call.to.y, p.z - call.to.z};
    return answer;
}

Player::Answered Player::make(const Operation& operation, const Step& call) {
    const std::uint64_t steps = steps_, hash = world_.state_hash();
    const bool is_refused = operation.answer == Answer::refused;
    if (call.apart)
        step_apart(call.dt, is_refused);
    else
        world_.step(call.dt);
    const StepReport& report = world_.report();
    if (is_refused) {
        check(call.apart || report.flags == StepFlags::invalid_dt, "dt is invalid, and flags say otherwise");
        check(report.step == steps && world_.state_hash() == hash, "a step of invalid dt changed the World");
    } else {
        check_step(report, steps);
        ++steps_;
    }
    return std::nullopt;
}

Player::Answered Player::make(const Operation&, const StartTrace& call) {
    static_cast<void>(world_.start_trace(call.max_events));
    return std::nullopt;
}

Player::Answered Player::make(const Operation&, const MoveWorld&) {
    World other = std::move(world_);
    world_ = std::move(other);
    return std::nullopt;
}

Player::Answered Player::make(const Operation& operation, const MovePins& call) {
    const auto answer = world_.move_pins(*cloths_[operation.cloth], call.vertices, call.targets);
    if (!answer || !is_there(operation.cloth)) return answer;
    for (std::size_t k = 0; k < call.vertices.size(); ++k)
        pins_[operation.cloth][particle(operation.cloth, call.vertices[k])] = call.targets[k];
    return answer;
}

Player::Answered Player::make(const Operation&, const AddShape& call) {
    const auto added = world_.add_shape(call.shape.shape());
    shapes_.push_back(added ? std::optional(*added) : std::nullopt);
    if (!added) return added.error();
    return Result<void>();
}

Player::Answered Player::make(const Operation&, const DeformShape& call) {
    const auto& id = shapes_[call.shape];
    if (!id) return std::nullopt;
    const bool there = world_.shape_info(*id).ok();
    const auto answer = world_.deform_shape(*id, call.vertices);
    check(there || !answer, "a shape that was removed was deformed");
    return there ? Answered(answer) : std::nullopt;
}

Player::Answered Player::make(const Operation&, const RemoveShape& call) {
    const auto& id = shapes_[call.shape];
    if (!id) return std::nullopt;
    const bool there = world_.shape_info(*id).ok();
    const auto answer = world_.remove_shape(*id);
    check(there || !answer, "a shape that was removed was removed again");
    check(!answer || !world_.shape_info(*id).ok(), "the shape is still there");
    return answer;
}

Player::Answered Player::make(const Operation&, const Save&) {
    Kept& kept = saves_.emplace_back(
        Kept{std::vector<std::byte>(world_.save_size()), world_.state_hash(), pins_, steps_, cloths_there()});
    const auto answer = world_.save(kept.bytes);
    check(world_.state_hash() == kept.hash, "saving changed the World");
    return answer;
}

Player::Answered Player::make(const Operation&, const Restore& call) {
    const Kept& kept = saves_[call.save];
    std::vector<std::byte> bytes = kept.bytes;
    if (call.damaged) {
        bytes[call.where % bytes.size()] ^= std::byte{1};
    } else if (options_.restored != nullptr && !std::ranges::binary_search(*options_.restored, played)) {
        return std::nullopt;
    } else if (cloths_there() != kept.cloths) {
        return std::nullopt;  // another of the same size takes it, and what is pinned is not known any more
    }
    const auto answer = world_.restore(bytes);
    if (!answer) return answer;
    restored_.push_back(played);
    check(world_.state_hash() == kept.hash, "what was put back is not what was saved");
    pins_ = kept.pins;
    steps_ = kept.steps;
    return answer;
}

namespace {

bool meets_cloth(const ClothSettings& settings) {
    return weft::meets_cloth(settings.self_collision.method);
}

bool overlap(const Reached& a, const Reached& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
           b.lower.y <= a.upper.y && a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

/// Cloths by which the one that is left out can be felt, directly or through others, itself with them. Who is
/// too far away has to have the same bytes without it, whatever it does.
std::vector<bool> may_feel(std::size_t left_out, const std::vector<bool>& meet,
                           const std::vector<Reached>& reached, bool are_tied) {
    std::vector<bool> feels(meet.size(), false);
    std::vector<std::size_t> next{left_out};
    feels[left_out] = true;
    while (!next.empty()) {
        const std::size_t from = next.back();
        next.pop_back();
        for (std::size_t i = 0; i < meet.size(); ++i) {
            if (feels[i] || !meet[i] || !meet[from]) continue;
            if (!are_tied && !overlap(reached[from], reached[i])) continue;
            feels[i] = true;
            next.push_back(i);
        }
    }
    return feels;
}

/// Bodies and seams pass on what one cloth does to another, however far away it is.
bool ties_cloths(const Operation& operation) {
    return std::holds_alternative<AddBody>(operation.call) || std::holds_alternative<Stitch>(operation.call);
}

/// Which cloths can meet others at some time.
std::vector<bool> can_meet(const Script& script) {
    std::vector<bool> result(script.cloths, false);
    const auto look = [&](const Operation& operation, const ClothSettings& settings) {
        if (meets_cloth(settings) && operation.cloth < result.size()) result[operation.cloth] = true;
    };
    for (const Operation& operation : script.operations) {
        if (ties_cloths(operation)) return std::vector<bool>(script.cloths, true);
        if (const auto* add = std::get_if<AddCloth>(&operation.call)) look(operation, add->settings);
        if (const auto* set = std::get_if<SetClothSettings>(&operation.call)) look(operation, set->settings);
    }
    return result;
}

/// Precondition: both of one script. `left_out`: cloths that are not compared.
void compare(const Fingerprints& expected, const Fingerprints& found, const std::vector<bool>& left_out,
             const std::string& how) {
    for (std::size_t operation = 0; operation < expected.size(); ++operation)
        for (std::size_t cloth = 0; cloth < expected[operation].size(); ++cloth)
            if (!left_out[cloth] && expected[operation][cloth] != found[operation][cloth])
                throw Failure{operation, "cloth " + std::to_string(cloth) + " has other bytes " + how};
}

}  // namespace

const std::size_t& present_operation() noexcept {
    return played;
}

Played play(const Script& script, const PlayOptions& options) {
    try {
        return Player(script, options).play();
    } catch (const std::exception& thrown) {
        throw Failure{played, std::string("an exception: ") + thrown.what()};
    }
}

void play_all_ways(const Script& script) {
    std::vector<std::byte> recorded;
    PlayOptions as_it_is;
    as_it_is.recorded = &recorded;
    const Played first = play(script, as_it_is);
    const Fingerprints& expected = first.fingerprints;
    const auto again = [&](int threads, std::optional<std::size_t> without = {}) {
        return play(script,
                    {.threads = threads, .without = without, .checked = false, .restored = &first.restored})
            .fingerprints;
    };
    const std::vector<bool> none(script.cloths, false);
    compare(expected, again(1), none, "with one thread");
    compare(expected, again(2), none, "with two threads");
    if (script.seed % 3 == 0) check_recording(script.seed, recorded);
    const std::size_t without = script.mistreated.value_or(script.seed % script.cloths);
    const bool are_tied = std::ranges::any_of(script.operations, ties_cloths);
    const std::vector<bool> left_out = may_feel(without, can_meet(script), first.reached, are_tied);
    compare(expected, again(1, without), left_out, "without cloth " + std::to_string(without));
}

}  // namespace weft::fuzz
