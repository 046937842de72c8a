#pragma once
// What a World holds, and the frame: how all of it advances by one step.

#include <array>
#include <memory>
#include <vector>

#include "cloth/frame/cloth.h"
#include "cloth/frame/schedule.h"
#include "cloth/solvers/stages.h"
#include "collision/collider_contacts.h"
#include "engine/parallel_blocks.h"
#include "engine/profiler.h"
#include "engine/slot_map.h"
#include "weft/world.h"

namespace weft {

/// A collider now, and where the host wants it at the end of the next step.
struct ColliderSlot {
    Collider current, target;
};

/// What a thread has to itself while it steps a cloth.
struct Worker {
    Parallel& parallel;                    ///< of all threads, or of this one alone
    std::vector<ColliderMotion>& motions;  ///< one per collider, over the present substep
};

/// Settings are validated before they get here.
struct Simulation {
    explicit Simulation(const WorldSettings& settings);
    void apply(const WorldSettings& settings);

    /// Makes or frees what so many colliders need, so that no step needs to allocate it.
    void expect_colliders(std::size_t count);
    /// So many cloths are stepped without allocation.
    void reserve_cloths(std::size_t count) { schedule_.reserve(count); }
    /// Gives a new cloth its bounds and normals, so that it can be drawn before its first step, and memory
    /// for gusts.
    void prepare(Cloth& cloth);
    /// The frame. Precondition: dt is in (0, 1].
    void step(float dt);

    WorldSettings settings;
    Parallel parallel;
    Profiler profiler;
    SlotMap<ClothId, std::unique_ptr<Cloth>> cloths{new_first_generation()};
    SlotMap<ColliderId, ColliderSlot> colliders{new_first_generation()};
    double time = 0;                    ///< [s] since the start
    std::array<double, 3> wind_path{};  ///< path of the mean wind since the start [m]
    StepReport report;

  private:
    void reserve_motions(std::size_t count);
    void begin();
    template <class StepCloth>
    void for_each_cloth(const StepCloth& step_cloth);
    void begin_cloth(Cloth& cloth, float dt) const;
    void feel_wind(Worker& worker, Cloth& cloth);
    void move_colliders(Worker& worker, float begin, float end) const;
    void air_forces(Worker& worker, Cloth& cloth, bool first_substep);
    [[nodiscard]] StepEquation equation_of(Worker& worker, Cloth& cloth, float h);
    void solve(Worker& worker, Cloth& cloth, const StepEquation& equation);
    void advance(Worker& worker, Cloth& cloth, const StepEquation& equation, bool first_substep);
    void hold_by_tethers(Worker& worker, Cloth& cloth);
    void collide_with_colliders(Worker& worker, Cloth& cloth, float h);
    void avoid_self_collision(Worker& worker, Cloth& cloth, float h);
    void guard(Worker& worker, Cloth& cloth);
    void finish(Worker& worker, Cloth& cloth);
    static void update_normals(Parallel& loops, Cloth& cloth);
    void add_to_report(const Cloth& cloth);
    void end(float dt);

    [[nodiscard]] bool air_is_on() const { return settings.wind.air_density > 0; }
    [[nodiscard]] auto timed(Stage stage) { return profiler.time(static_cast<std::uint32_t>(stage)); }

    Parallel serial_{1};
    Schedule schedule_;
    std::vector<std::vector<ColliderMotion>> motions_;  // one list for each thread
};

}  // namespace weft
