#include "cloth/record/replayer.h"

#include <algorithm>
#include <string>
#include <utility>

#include "cloth/record/state_hashes.h"
#include "cloth/record/world_calls.h"

namespace weft {

namespace {

Error no_such_call() {
    return {ErrorCode::malformed_file, "holds other than what such a call is given"};
}

Result<void> refused_call(const Error& error) {
    if (error.code == ErrorCode::out_of_memory) return error;
    return Error{ErrorCode::malformed_file, "is refused: " + error.message};
}
template <class T>
Result<void> without_value(const Result<T>& answer) {
    return answer ? Result<void>() : refused_call(answer.error());
}

}  // namespace

template <class... Given, class Act>
Result<void> Replayer::with(RecordReader& reader, const Act& act) {
    const std::tuple<Given...> given{reader.get<Given>()...};
    if (!reader.is_done()) return no_such_call();
    ++replay_.calls;
    return without_value(std::apply(act, given));
}

template <class Id, class... Given, class Act>
Result<void> Replayer::adding(RecordReader& reader, const Act& act) {
    const Id recorded = reader.get_recorded<Id>();
    return with<Given...>(reader, [&](const Given&... given) {
        const Result<Id> added = act(given...);
        if (added) ids_.add(recorded, *added);
        if constexpr (std::is_same_v<Id, ClothId>)
            if (added) cloths_.push_back(recorded);
        return added;
    });
}

Result<void> Replayer::create(RecordReader& reader) {
    const auto settings = reader.get<WorldSettings>();
    if (!reader.is_done()) return no_such_call();
    auto made = World::create(with_threads(settings));
    if (!made) return refused_call(made.error());
    world_.emplace(std::move(made).value());
    world_->impl_->simulation.has_given_choices = true;
    return {};
}

Result<void> Replayer::make(Call call, std::span<const std::byte> given) {
    RecordReader reader(given, ids_);
    if ((call == Call::create) == world_.has_value())
        return Error{ErrorCode::malformed_file,
                     world_ ? "makes a World where there is one" : "comes before that which makes the World"};
    switch (call) {
        case Call::create:
            return create(reader);
        case Call::cook:
            return cook(reader);
        case Call::end:
            if (!reader.is_done()) return no_such_call();
            replay_.is_whole = true;
            return {};
        case Call::step:
            return step(reader);
        case Call::choose:
            return choose(reader);
        case Call::set_settings:
            return with<WorldSettings>(reader, [&](const WorldSettings& settings) {
                return world_->set_settings(with_threads(settings));
            });
        case Call::shift_origin:
            return with<Vec3>(reader, [&](const Vec3& to) { return world_->shift_origin(to); });
        case Call::restore:
            return with<std::span<const std::byte>>(reader,
                                                    [&](auto saved) { return world_->restore(saved); });
        case Call::restore_cloths:
            return with<std::uint32_t, std::span<const std::byte>>(
                reader, [&](std::uint32_t, auto saved) { return world_->restore_cloths(saved); });
        case Call::add_shape:
        case Call::deform_shape:
        case Call::remove_shape:
        case Call::add_collider:
        case Call::move_collider:
        case Call::place_collider:
        case Call::remove_collider:
            return change_collider(call, reader);
        case Call::add_body:
        case Call::remove_body:
        case Call::set_body_settings:
        case Call::set_body_state:
        case Call::attach_collider:
        case Call::detach_collider:
        case Call::attach:
        case Call::detach:
            return change_body(call, reader);
        case Call::stitch:
        case Call::unstitch:
            return change_seam(call, reader);
        default:
            return change_cloth(call, reader);
    }
}

Result<void> Replayer::cook(RecordReader& reader) {
    return with<std::span<const std::byte>, ClothSettings>(
        reader, [&](std::span<const std::byte> saved, const ClothSettings& settings) {
            Result<CookedCloth> cooked = CookedCloth::load(saved, settings);
            if (cooked) cooked_.push_back(*cooked);
            return cooked;
        });
}

Result<void> Replayer::change_cloth(Call call, RecordReader& reader) {
    using Vertices = std::span<const std::uint32_t>;
    using Points = std::span<const Vec3>;
    World& world = *world_;
    switch (call) {
        case Call::add_cloth:
            return adding<ClothId, Mesh, ClothSettings>(reader, [&](const auto& mesh, const auto& settings) {
                return world.add_cloth(mesh, settings);
            });
        case Call::add_cooked_cloth:
            return adding<ClothId, std::uint32_t, Transform>(
                reader, [&](std::uint32_t number, const Transform& place) -> Result<ClothId> {
                    if (number >= cooked_.size()) return no_such_call();
                    return world.add_cloth(cooked_[number], place);
                });
        case Call::remove_cloth:
            return with<ClothId>(reader, [&](ClothId id) { return world.remove_cloth(id); });
        case Call::set_cloth_settings:
            return with<ClothId, ClothSettings>(reader, [&](ClothId id, const auto& settings) {
                return world.set_cloth_settings(id, settings);
            });
        case Call::recut_cloth:
            return with<ClothId, Mesh, Vertices>(reader, [&](ClothId id, const Mesh& mesh, Vertices from) {
                return world.recut_cloth(id, mesh, from);
            });
        case Call::set_enabled:
            return with<ClothId, bool>(reader,
                                       [&](ClothId id, bool on) { return world.set_enabled(id, on); });
        case Call::add_level:
            return with<ClothId, ClothId, float>(reader, [&](ClothId finest, ClothId coarser, float reach) {
                return world.add_level(finest, coarser, reach);
            });
        case Call::set_level:
            return with<ClothId, std::uint32_t>(
                reader, [&](ClothId id, std::uint32_t level) { return world.set_level(id, level); });
        case Call::set_importance:
            return with<ClothId, float>(
                reader, [&](ClothId id, float importance) { return world.set_importance(id, importance); });
        case Call::wake:
            return with<ClothId>(reader, [&](ClothId id) { return world.wake(id); });
        case Call::pin:
            return with<ClothId, Vertices>(reader, [&](ClothId id, Vertices v) { return world.pin(id, v); });
        case Call::unpin:
            return with<ClothId, Vertices>(reader,
                                           [&](ClothId id, Vertices v) { return world.unpin(id, v); });
        case Call::move_pins:
            return with<ClothId, Vertices, Points>(
                reader, [&](ClothId id, Vertices v, Points to) { return world.move_pins(id, v, to); });
        case Call::move_cloth:
            return with<ClothId, Transform>(
                reader, [&](ClothId id, const Transform& by) { return world.move_cloth(id, by); });
        case Call::reset_cloth:
            return with<ClothId, Points>(reader,
                                         [&](ClothId id, Points at) { return world.reset_cloth(id, at); });
        case Call::resume_cloth:
            return with<ClothId, Points, Points, Points>(
                reader, [&](ClothId id, Points at, Points before, Points velocities) {
                    return world.resume_cloth(id, at, before, velocities);
                });
        case Call::restore_cloth:
            return with<ClothId, std::span<const std::byte>>(
                reader, [&](ClothId id, auto saved) { return world.restore_cloth(id, saved); });
        case Call::set_frame:
            return with<ClothId, Transform>(
                reader, [&](ClothId id, const Transform& pose) { return world.set_frame(id, pose); });
        case Call::leave_frame:
            return with<ClothId>(reader, [&](ClothId id) { return world.leave_frame(id); });
        case Call::set_map:
            return with<ClothId, Map, std::span<const float>>(
                reader, [&](ClothId id, Map map, auto values) { return world.set_map(id, map, values); });
        case Call::set_skin:
            return with<ClothId, Points, Points>(
                reader, [&](ClothId id, Points p, Points normals) { return world.set_skin(id, p, normals); });
        default:
            return no_such_call();
    }
}

Result<void> Replayer::change_collider(Call call, RecordReader& reader) {
    World& world = *world_;
    switch (call) {
        case Call::add_shape:
            return adding<ShapeId, Shape>(reader, [&](const Shape& shape) { return world.add_shape(shape); });
        case Call::deform_shape:
            return with<ShapeId, std::span<const Vec3>>(
                reader, [&](ShapeId id, auto vertices) { return world.deform_shape(id, vertices); });
        case Call::remove_shape:
            return with<ShapeId>(reader, [&](ShapeId id) { return world.remove_shape(id); });
        case Call::add_collider:
            return adding<ColliderId, Collider>(
                reader, [&](const Collider& collider) { return world.add_collider(collider); });
        case Call::move_collider:
            return with<ColliderId, Collider>(
                reader, [&](ColliderId id, const Collider& to) { return world.move_collider(id, to); });
        case Call::place_collider:
            return with<ColliderId, Collider>(
                reader, [&](ColliderId id, const Collider& at) { return world.place_collider(id, at); });
        case Call::remove_collider:
            return with<ColliderId>(reader, [&](ColliderId id) { return world.remove_collider(id); });
        default:
            return no_such_call();
    }
}

Result<void> Replayer::change_body(Call call, RecordReader& reader) {
    using Vertices = std::span<const std::uint32_t>;
    World& world = *world_;
    switch (call) {
        case Call::add_body:
            return adding<BodyId, BodySettings, BodyState>(
                reader,
                [&](const auto& settings, const auto& state) { return world.add_body(settings, state); });
        case Call::remove_body:
            return with<BodyId>(reader, [&](BodyId id) { return world.remove_body(id); });
        case Call::set_body_settings:
            return with<BodyId, BodySettings>(reader, [&](BodyId id, const auto& settings) {
                return world.set_body_settings(id, settings);
            });
        case Call::set_body_state:
            return with<BodyId, BodyState>(
                reader, [&](BodyId id, const auto& state) { return world.set_body_state(id, state); });
        case Call::attach_collider:
            return with<BodyId, ColliderId>(
                reader, [&](BodyId id, ColliderId collider) { return world.attach_collider(id, collider); });
        case Call::detach_collider:
            return with<ColliderId>(reader, [&](ColliderId id) { return world.detach_collider(id); });
        case Call::attach:
            return with<BodyId, ClothId, Vertices>(
                reader, [&](BodyId id, ClothId cloth, Vertices v) { return world.attach(id, cloth, v); });
        case Call::detach:
            return with<ClothId, Vertices>(reader,
                                           [&](ClothId cloth, Vertices v) { return world.detach(cloth, v); });
        default:
            return no_such_call();
    }
}

Result<void> Replayer::change_seam(Call call, RecordReader& reader) {
    using Vertices = std::span<const std::uint32_t>;
    if (call == Call::unstitch) return with<SeamId>(reader, [&](SeamId id) { return world_->unstitch(id); });
    return adding<SeamId, ClothId, Vertices, ClothId, Vertices, SeamSettings>(
        reader, [&](ClothId a, Vertices of_a, ClothId b, Vertices of_b, const SeamSettings& settings) {
            return world_->stitch(a, of_a, b, of_b, settings);
        });
}

Result<void> Replayer::choose(RecordReader& reader) {
    const auto choices = reader.get<std::span<const RungOfCloth>>();
    if (!reader.is_done()) return no_such_call();
    Simulation& simulation = world_->impl_->simulation;
    for (const RungOfCloth& choice : choices) {
        std::unique_ptr<Cloth>* const cloth = simulation.cloths.find(ids_.find(choice.cloth));
        if (cloth == nullptr || !(*cloth)->state.detail) return no_such_call();
        const Cloth& of = **cloth;
        Garment* const garment = of.garment == no_garment ? nullptr : &simulation.garments[of.garment];
        const std::uint32_t level = choice.rung / rung_count, rung = choice.rung % rung_count;
        if (level >= (garment == nullptr ? 1 : garment->levels.size())) return no_such_call();
        if (level == of.level)
            (*cloth)->state.detail->go_to(rung, static_cast<std::uint32_t>(simulation.state.steps) + 1);
        else
            garment->next = {level, rung};
    }
    return {};
}

Result<void> Replayer::step(RecordReader& reader) {
    const auto dt = reader.get<float>();
    const auto rest = reader.get<std::uint64_t>();
    const auto cloths = reader.get<std::span<const HashOfCloth>>();
    if (!reader.is_done() || !(dt >= least_step && dt <= greatest_step)) return no_such_call();
    world_->step(dt);
    ++replay_.steps;
    return compare(rest, cloths);
}

// Cloths are compared first: where cloth and bodies act on each other both differ, and the cloth is named.
Result<void> Replayer::compare(std::uint64_t rest, std::span<const HashOfCloth> cloths) {
    const Simulation& simulation = world_->impl_->simulation;
    if (cloths.size() != simulation.cloths.size()) return no_such_call();
    const auto differ = [&](std::optional<std::uint32_t> cloth) {
        replay_.difference = {.step = simulation.report.step, .cloth = cloth};
    };
    for (const HashOfCloth& recorded : cloths) {
        const std::unique_ptr<Cloth>* const cloth = simulation.cloths.find(ids_.find(recorded.cloth));
        if (cloth == nullptr) return no_such_call();
        if (hash_of(**cloth, hasher_) == recorded.hash) continue;
        differ(static_cast<std::uint32_t>(std::ranges::find(cloths_, recorded.cloth) - cloths_.begin()));
        return {};
    }
    if (hash_of_rest(simulation, hasher_) != rest) differ(std::nullopt);
    return {};
}

}  // namespace weft
