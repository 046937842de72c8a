#pragma once
// What a World holds, and the frame: how all of it advances by one step.

#include <array>
#include <memory>
#include <vector>

#include "cloth/cloth.h"
#include "cloth/stages.h"
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

/// Settings are validated before they get here.
struct Simulation {
    explicit Simulation(const WorldSettings& settings);
    void apply(const WorldSettings& settings);

    /// Gives a new cloth its bounds and normals, so that it can be drawn before its first step, and memory
    /// for gusts.
    void prepare(Cloth& cloth);
    /// The frame. Precondition: dt is in (0, 1].
    void step(float dt);

    WorldSettings settings;
    Parallel parallel;
    Profiler profiler;
    SlotMap<ClothId, std::unique_ptr<Cloth>> cloths;
    SlotMap<ColliderId, ColliderSlot> colliders;
    std::vector<ColliderMotion>
        motions;      ///< one per collider, over the present substep; reserved by add_collider
    double time = 0;  ///< [s] since the start
    std::array<double, 3> wind_path{};  ///< path of the mean wind since the start [m]
    StepReport report;

  private:
    void begin(float dt);
    void feel_wind(Cloth& cloth);
    void move_colliders(float begin, float end);
    void air_forces(Cloth& cloth, bool first_substep);
    [[nodiscard]] StepEquation equation_of(Cloth& cloth, float h);
    void solve(Cloth& cloth, const StepEquation& equation);
    void advance(Cloth& cloth, const StepEquation& equation, bool first_substep);
    void hold_by_tethers(Cloth& cloth);
    void collide_with_colliders(Cloth& cloth, float h);
    void avoid_self_collision(Cloth& cloth, float h);
    void guard(Cloth& cloth);
    void finish(Cloth& cloth);
    void update_normals(Cloth& cloth);
    void end(float dt);

    [[nodiscard]] bool air_is_on() const { return settings.wind.air_density > 0; }
    [[nodiscard]] auto timed(Stage stage) { return profiler.time(static_cast<std::uint32_t>(stage)); }
};

}  // namespace weft
