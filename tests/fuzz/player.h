#pragma once
// Makes the calls of a script in a World, and looks after each at what Weft promises.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/fuzz/play.h"
#include "tests/fuzz/recording.h"
#include "tests/fuzz/text.h"

namespace weft::fuzz {

/// The operation that is being played.
inline std::size_t played = 0;

template <class Id>
std::vector<Id> ids_of(std::span<const std::optional<Id>> made) {
    std::vector<Id> ids;
    for (const auto& id : made)
        if (id) ids.push_back(*id);
    return ids;
}

class Player {
  public:
    Player(const Script& script, const PlayOptions& options)
        : script_(script),
          options_(options),
          world_(make_world()),
          cloths_(script.cloths),
          reached_(script.cloths),
          pins_(script.cloths) {}

    Played play() {
        Fingerprints fingerprints;
        if (options_.recorded != nullptr && !world_.start_recording(sink_to(*options_.recorded)))
            throw Failure{0, "a new World cannot be recorded"};
        for (played = 0; played < script_.operations.size(); ++played) {
            const Operation& operation = script_.operations[played];
            const bool left_out = options_.without && operation.cloth == *options_.without;
            if (!left_out)
                call(operation);
            else
                leave_out(operation);
            note_reach(operation);
            fingerprints.push_back(fingerprints_now());
        }
        if (options_.recorded != nullptr && !world_.stop_recording())
            throw Failure{0, "the recording broke off"};
        return {std::move(fingerprints), std::move(reached_), std::move(restored_)};
    }

  private:
    void call(const Operation& operation);
    void leave_out(const Operation& operation);
    void note_reach(const Operation& operation);

    // Each makes the call, and returns its answer where there is one.
    using Answered = std::optional<Result<void>>;
    Result<ClothId> add(const AddCloth& call);
    Answered make(const Operation& operation, const AddCloth& call);
    Answered make(const Operation&, const MeasureCloth& call);
    Answered make(const Operation& operation, const RemoveCloth&);
    Answered make(const Operation& operation, const Recut& call);
    Answered make(const Operation& operation, const SetClothSettings& call);
    Answered make(const Operation& operation, const Ask&);
    Answered make(const Operation& operation, const Pin& call);
    Answered make(const Operation& operation, const MovePin& call);
    Answered make(const Operation& operation, const Unpin& call);
    Answered make(const Operation&, const AddCollider& call);
    Answered make(const Operation&, const MoveCollider& call);
    Answered make(const Operation&, const PlaceCollider& call);
    Answered make(const Operation&, const RemoveCollider& call);
    Answered make(const Operation&, const AddBody& call);
    Answered make(const Operation&, const SetBody& call);
    Answered make(const Operation&, const RemoveBody& call);
    Answered make(const Operation&, const AttachCollider& call);
    Answered make(const Operation&, const DetachCollider& call);
    Answered make(const Operation& operation, const Attach& call);
    Answered make(const Operation&, const SetWorldSettings& call);
    Answered make(const Operation& operation, const MoveCloth& call);
    Answered make(const Operation& operation, const ResetCloth& call);
    Answered make(const Operation& operation, const SetMap& call);
    Answered make(const Operation& operation, const SetSkin& call);
    Answered make(const Operation&, const ShiftOrigin& call);
    Answered make(const Operation&, const Step& call);
    Answered make(const Operation&, const StartTrace& call);
    Answered make(const Operation&, const MoveWorld&);
    Answered make(const Operation& operation, const MovePins& call);
    Answered make(const Operation&, const AddShape& call);
    Answered make(const Operation&, const DeformShape& call);
    Answered make(const Operation&, const RemoveShape& call);
    Answered make(const Operation&, const Save&);
    Answered make(const Operation&, const Restore& call);
    Answered make(const Operation& operation, const SaveCloth&);
    Answered make(const Operation& operation, const RestoreCloth& call);
    Answered make(const Operation& operation, const Stitch& call);
    Answered make(const Operation&, const Unstitch& call);

    /// A script's instance names the number of its shape in place of the id.
    [[nodiscard]] Collider resolved(Collider collider) const {
        if (auto* const placed = std::get_if<PlacedShape>(&collider.shape))
            placed->shape = shapes_[placed->shape.index].value_or(ShapeId{});
        return collider;
    }
    void check(bool holds, const std::string& what) const {
        if (options_.checked && !holds) throw Failure{played, what};
    }
    void check_answer(const Operation& operation, const Result<void>& answer,
                      const std::string& before) const;
    void check_vertices(std::size_t cloth, const ClothView& view) const;
    void check_cloth(std::size_t cloth) const;
    void step_apart(float dt, bool is_refused);
    void read_beside_work();
    void ask_of_world();
    void ask_of_cloth(ClothId id);
    void check_step(const StepReport& report, std::uint64_t steps_before) const;
    void check_contacts(const StepReport& report) const;
    void check_pins(std::size_t cloth) const;
    void check_seams(const StepReport& report) const;

    [[nodiscard]] WorldSettings with_threads(WorldSettings settings) const {
        // Threads out of range stay so: the call must be refused with any number of threads.
        if (!options_.threads || settings.threads < 0 || settings.threads > 256) return settings;
        settings.threads = *options_.threads;
        settings.executor = {};
        return settings;
    }
    [[nodiscard]] World make_world() const {
        auto made = World::create(with_threads(script_.world));
        if (!made) throw Failure{0, "World::create: " + made.error().message};
        return std::move(made).value();
    }
    [[nodiscard]] bool is_carried(std::size_t collider) const {
        const auto found = carried_.find(collider);
        return found != carried_.end() && world_.body_state(*bodies_[found->second]).ok();
    }
    /// False as well for the id of a cloth that was removed.
    [[nodiscard]] bool is_there(std::size_t cloth) const {
        return cloth != Operation::no_cloth && cloths_[cloth] && world_.cloth(*cloths_[cloth]).ok();
    }
    [[nodiscard]] std::uint32_t particle(std::size_t cloth, std::uint32_t vertex) const {
        return world_.cloth(*cloths_[cloth])->vertex_to_particle[vertex];
    }
    [[nodiscard]] std::vector<std::uint64_t> fingerprints_now() const {
        std::vector<std::uint64_t> all;
        for (std::size_t i = 0; i < cloths_.size(); ++i) {
            all.push_back(0);
            if (!is_there(i)) continue;
            all.back() = 1;
            const ClothView view = world_.cloth(*cloths_[i]).value();
            for (const std::span<const Vec4> buffer :
                 {view.positions, view.velocities, view.previous_positions, view.normals})
                all.back() = fingerprint(buffer, all.back());
        }
        return all;
    }
    [[nodiscard]] std::string snapshot_now() const {
        return options_.checked ? snapshot(world_, ids_of<ClothId>(cloths_), ids_of<ColliderId>(colliders_))
                                : std::string();
    }

    const Script& script_;
    PlayOptions options_;
    World world_;
    std::vector<std::optional<ClothId>> cloths_;
    std::vector<Reached> reached_;
    std::vector<std::optional<ColliderId>> colliders_;
    std::vector<std::optional<BodyId>> bodies_;
    std::map<std::size_t, std::size_t> carried_;  ///< colliders, and by which body
    std::vector<std::optional<ShapeId>> shapes_;
    std::vector<std::map<std::uint32_t, Vec3>> pins_;  ///< where each pinned particle of each cloth shall be
    std::uint64_t steps_ = 0;

    /// The state that a save must restore.
    struct Kept {
        std::vector<std::byte> bytes;
        std::uint64_t hash;
        std::vector<std::map<std::uint32_t, Vec3>> pins;
        std::uint64_t steps;
        std::vector<std::size_t> cloths;  ///< vertices of those that were there, else 0
    };
    /// A cloth that is cut gets more vertices.
    [[nodiscard]] std::vector<std::size_t> cloths_there() const {
        std::vector<std::size_t> there;
        for (std::size_t i = 0; i < cloths_.size(); ++i)
            there.push_back(is_there(i) ? world_.cloth_info(*cloths_[i])->vertices : 0);
        return there;
    }
    std::vector<Kept> saves_;
    struct KeptCloth {
        std::vector<std::byte> bytes;  ///< none: the cloth was not there
        std::map<std::uint32_t, Vec3> pins;
        std::size_t vertices = 0;
    };
    std::vector<std::byte> saved_cloth(ClothId id) const;
    std::vector<KeptCloth> cloth_saves_;
    std::vector<std::optional<SeamId>> seams_;
    std::vector<std::size_t> restored_;
};

}  // namespace weft::fuzz
