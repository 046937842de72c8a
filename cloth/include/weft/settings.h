#pragma once
// What a host can set. Every field says its unit, its range and what it does; the defaults run.

#include <cstdint>

#include "weft/executor.h"
#include "weft/methods.h"
#include "weft/self_collision.h"
#include "weft/types.h"

namespace weft {

/// The material. Spring stiffnesses are forces per length of one spring, which along the threads of a square
/// grid is the membrane's tension per width and strain: it does not depend on the resolution.
struct Fabric {
    float areal_density = 0.2f;  ///< [kg/m^2], 1e-4 to 1e4
    float stretch = 400.0f;      ///< structural springs, along edges [N/m], 0 to 1e9
    float shear = 100.0f;        ///< diagonals of a grid's cells [N/m], 0 to 1e9; general meshes have none
    float bend = 4.0f;      ///< second neighbours along a thread, or across a shared edge [N/m], 0 to 1e9
    /// Spring damping over stiffness, c = damping * k [s], 0 to 100: the time in which stretch, shear and bend
    /// creep back once a load is gone. Motion at f Hz has the loss factor 2 pi f damping. The step adds its own:
    /// of an oscillation at f, backward Euler at h has a loss factor of 2 pi f h, BDF2 of (2 pi f h)^3 / 2. From
    /// about 0.1 s on, cloth takes more Multilevel::passes to hang right while it moves: six at 1 s.
    float damping = 2e-4f;
};

/// Triangle finite elements in place of the springs: warp, weft and shear apart, and bending as a rigidity.
/// Of the implicit methods and SymplecticEuler only: Xpbd and Fibres refuse them.
struct FiniteElements {
    bool enabled = false;
    float warp = 400.0f;    ///< membrane stiffness along the pattern's first axis [N/m], 1e-4 to 1e9
    float weft = 400.0f;    ///< along its second axis [N/m], 1e-4 to 1e9
    float shear = 100.0f;   ///< [N/m], 1e-4 to 1e9
    float poisson = 0.0f;   ///< lateral contraction under stretch, in [0, 0.5)
    float bending = 1e-5f;  ///< flexural rigidity [N m], 0 to 1e4
    bool dihedral = false;  ///< bending by angles, from those at rest; false: quadratic, which rests flat
    /// False: lumped at the particles. SymplecticEuler has no other and refuses it.
    bool consistent_mass = false;
};

/// Long-range attachments (Kim, Chentanez, Mueller 2012): no particle goes further from the nearest pins than
/// the way along the cloth, whatever the solver has left unsolved.
struct Tethers {
    bool enabled = false;
    float slack = 1.0f;  ///< times the length along the cloth, 1 to 1000
};

/// One cloth. All of it can be changed between steps.
struct ClothSettings {
    Fabric fabric{};
    FiniteElements finite_elements{};
    Method method{};  ///< Multilevel unless another is set
    TimeScheme time_scheme = TimeScheme::bdf2;
    /// Steps of the method within each of WorldSettings::substeps, 1 to 1024. One is enough for the default;
    /// methods that are not implicit meet colliders after their step, and want 4 and more where cloth lies
    /// on them.
    int substeps = 1;
    Tethers tethers{};
    SelfCollision self_collision{};
    float air_damping = 0.2f;  ///< rate at which any velocity decays, shape and all [1/s], 0 to 1e6
    float thickness = 0.005f;  ///< distance kept from colliders [m], 0 to 10
    float friction = 1.0f;     ///< multiplies the colliders' friction, 0 to 1000
};

/// Air that moves. Forces act on each triangle from the air's velocity relative to it.
struct Wind {
    Vec3 velocity{};  ///< mean velocity [m/s], each component up to 1000
    float gust = 0;   ///< strength of the gusts relative to the mean speed, 0 to 100; 0.3 is a gusty day
    float gust_length = 0.8f;  ///< size of an eddy [m], 1e-3 to 1e5
    float air_density = 1.2f;  ///< [kg/m^3], 0 to 1e4; 0 switches all air forces on triangles off, at no cost
    float drag = 1.0f;         ///< drag coefficient of a triangle facing the wind, 0 to 1000
    float lift = 0.4f;         ///< lift coefficient, 0 to 1000
    std::uint32_t seed = 1;    ///< another seed, other gusts
};

struct WorldSettings {
    Vec3 gravity{0, -9.81f, 0};  ///< [m/s^2], each component up to 1e4
    Wind wind{};
    /// No particle is faster after any stage of a step [m/s], 1e-3 to 1e4: a pin or a collider that jumps
    /// cannot shoot the cloth off.
    float max_speed = 100.0f;
    int substeps = 1;  ///< steps of the solver per World::step, 1 to 256
    /// Threads of Weft's own arena, 1 to 256; 0: one per core. Results do not depend on it.
    int threads = 0;
    Executor executor{};  ///< the host's own threads instead, where `run` is set
};

}  // namespace weft
