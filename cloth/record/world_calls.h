#pragma once
// Code that the public World's calls share.

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cloth/record/recorder.h"
#include "cloth/simulation/simulation.h"
#include "engine/memory/without_exceptions.h"
#include "weft/world.h"

namespace weft {

/// Use of the World: none; a call of step() or begin_step(); a step that was begun, and within it a call of
/// work() or end_step(), or a step that is computed but not ended.
enum class StepPhase : std::uint32_t { none, stepping, begun, working, done };

struct WEFT_LOCAL World::Impl {
    explicit Impl(const WorldSettings& settings) : simulation(settings) {}
    Simulation simulation;
    std::unique_ptr<Recorder> recorder;  ///< null: nothing is recorded
    bool has_changed = false;            ///< whether a call has changed the World since it was made

    std::atomic<StepPhase> phase = StepPhase::none;
    float dt = 0;                                            ///< of the step that was begun
    StepFlags logged = StepFlags::none;                      ///< flags that the last step raised
    StepReport last;                                         ///< in a step that was begun: the one before
    StepReport refused{.flags = StepFlags::step_under_way};  ///< result of step() in a step

    [[nodiscard]] bool is_in_step() const noexcept { return phase != StepPhase::none; }
    /// Error: a step was begun, or another thread takes one.
    [[nodiscard]] static Result<void> refuse_in(StepPhase phase, const char* call) {
        if (phase == StepPhase::none) return {};
        const char* const why = phase == StepPhase::stepping
                                    ? ": another thread takes a step of the World; make its calls one after "
                                      "the other"
                                    : ": a step was begun, and has to end first; call end_step";
        return Error{ErrorCode::invalid_argument, std::string(call) + why};
    }
    [[nodiscard]] Result<void> refuse_in_step(const char* call) const { return refuse_in(phase, call); }
    /// For calls that are allowed in a step that was begun, but not beside step().
    [[nodiscard]] Result<void> refuse_beside_step(const char* call) const {
        return phase == StepPhase::stepping ? refuse_in(StepPhase::stepping, call) : Result<void>();
    }

    /// change(call, arguments)(act) makes a call that changes the World, and records it if it succeeds.
    template <class... Arguments>
    auto change(Call call, const Arguments&... arguments) noexcept {
        return [this, call, &arguments...](const auto& act) noexcept {
            return change_by(call, act, [&](const auto& done) {
                if constexpr (std::is_same_v<decltype(act()), Result<void>>)
                    recorder->note(call, arguments...);
                else
                    recorder->note(call, *done, arguments...);
            });
        };
    }
    /// Like change(), but note(result) records the call.
    template <class Act, class Note>
    auto change_by(Call call, const Act& act, const Note& note) noexcept -> decltype(act()) {
        return without_exceptions([&]() -> decltype(act()) {
            if (auto ready = refuse_in_step(name_of(call)); !ready) return ready.error();
            auto done = act();
            if (!done) return done;
            has_changed = true;
            if (recorder) note(done);
            return done;
        });
    }
    /// Makes a call that reads what steps write.
    template <class Act>
    auto read(const char* call, const Act& act) const noexcept -> decltype(act()) {
        return without_exceptions([&]() -> decltype(act()) {
            if (auto ready = refuse_in_step(call); !ready) return ready.error();
            return act();
        });
    }

    /// Begins a step of `step` seconds: copies the buffers that may be read in it.
    void begin_step(float step);
    void take_step() noexcept;
    void end_step() noexcept;
    /// Logs the flags that this step raised and the last one did not.
    void log_flags() noexcept;
};

template <class Id>
Error stale_id(const char* type, Id id) {
    if (id == Id{})
        return {ErrorCode::stale_id, std::string(type) + " is null; use the one that the World returned"};
    return {ErrorCode::stale_id, std::string(type) + " {" + std::to_string(id.index) + ", " +
                                     std::to_string(id.generation) +
                                     "} is of an object that was removed, or of another World"};
}

/// The particle of a mesh vertex.
inline Result<std::uint32_t> particle_of(const Cloth& cloth, std::uint32_t vertex) {
    const auto& map = cloth.model.vertex_to_particle;
    if (vertex >= map.size()) {
        return Error{ErrorCode::invalid_argument, "vertex " + std::to_string(vertex) +
                                                      " does not exist; the mesh has " +
                                                      std::to_string(map.size())};
    }
    return map[vertex];
}

/// The particles of mesh vertices. Error: a vertex that the mesh does not have.
[[nodiscard]] Result<std::vector<std::uint32_t>> particles_of(const Cloth& cloth,
                                                              std::span<const std::uint32_t> vertices);

/// Error: a part of the cloth would be out of reach after this motion.
[[nodiscard]] Result<void> validate_move(const Cloth& cloth, const RigidMotion& by);

/// Calls `use` with the cloth of an id and returns its result. Error: the id is stale.
template <class Simulation, class Use>
auto with_cloth(Simulation& simulation, ClothId id, const Use& use)
    -> decltype(use(**simulation.cloths.find(id))) {
    return without_exceptions([&]() -> decltype(use(**simulation.cloths.find(id))) {
        auto* slot = simulation.cloths.find(id);
        if (slot == nullptr) return stale_id("ClothId", id);
        return use(**slot);
    });
}

}  // namespace weft
