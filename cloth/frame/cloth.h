#pragma once
// A cloth in a World: its rest model, its state, and the memory that its solver needs. Nothing in it grows in
// a step.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cloth/frame/history.h"
#include "cloth/frame/state.h"
#include "cloth/frame/survey.h"
#include "cloth/limits/tethers.h"
#include "cloth/mesh/cook.h"
#include "cloth/solvers/solver.h"
#include "cloth/surface/surface.h"
#include "cloth/system/contacts.h"
#include "collision/rest_neighbours.h"
#include "collision/self_contacts.h"
#include "engine/aligned_buffer.h"
#include "weft/settings.h"

namespace weft {

/// A pinned particle and where it shall be at the end of the next step [m].
struct Pin {
    std::uint32_t particle;
    Vector3 target;
};

struct Cloth {
    Cloth(CookedCloth cooked, const ClothSettings& settings);

    /// Takes validated settings over; makes or frees what self-collision needs.
    void apply(const ClothSettings& settings);
    /// Makes or frees what air and its gusts need.
    void set_air(bool on, bool gusts);
    /// Makes or frees what colliders need of an implicit solver.
    void set_colliders(bool any);
    /// Mass of a free particle [kg]; 0 for loose ones.
    [[nodiscard]] float mass(std::uint32_t particle) const {
        return settings.fabric.areal_density * model.rest_area[particle];
    }
    /// Null if the particle is not pinned.
    [[nodiscard]] Pin* find_pin(std::uint32_t particle);
    void pin(std::uint32_t particle);
    void unpin(std::uint32_t particle);
    /// Puts the cloth back to where the step began, at rest.
    void restore_start_of_step();
    /// Least distance between particles that self-collision is to keep [m].
    [[nodiscard]] float distance_of(const SelfCollision& self_collision) const;
    /// Counts of the mesh, mass and memory.
    [[nodiscard]] ClothInfo info() const;

    CookedCloth model;
    ClothSettings settings;
    ClothState state;
    std::unique_ptr<Solver> solver;
    bool solver_is_prepared = false;                ///< for the present pins and masses
    AlignedBuffer<Vec4> velocity_change;            ///< of the present substep [m/s], w 0
    std::optional<History> history;                 ///< only with BDF2
    std::optional<LongRangeAttachments> tethers;    ///< only with tethers on
    bool tethers_are_attached = false;              ///< to the present pins
    std::optional<SelfContacts> self_contacts;      ///< only with self-collision on
    std::optional<RestNeighbours> rest_neighbours;  ///< likewise
    std::optional<Contacts> contacts;               ///< only with colliders, and if the solver is implicit
    std::vector<Pin> pins;                          ///< in ascending order of particles

    Surface surface;
    AlignedBuffer<Vec4> air_velocities;  ///< of the gusty air at each particle [m/s]; empty without gusts
    AlignedBuffer<Vec4> air_forces;      ///< see ExternalForces
    AlignedBuffer<std::uint32_t> partial_counts;
    AlignedBuffer<Survey> partial_surveys;

    bool solver_failed = false;           ///< in a substep of the present step
    bool restored = false;                ///< by the present step's guard
    float residual = 0;                   ///< the largest of the present step's substeps
    Survey extent{};                      ///< of the state, as last surveyed
    SelfContactCounts self_counts;        ///< of the last substep
    std::uint32_t collider_contacts = 0;  ///< particles that met a collider in the last substep

  private:
    bool has_colliders_ = false;

    void set_inverse_mass(std::uint32_t particle, float inverse_mass);
    [[nodiscard]] float inverse_mass_when_free(std::uint32_t particle) const;
};

}  // namespace weft
