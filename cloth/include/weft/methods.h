#pragma once
// Methods by which a cloth is stepped: one struct each, named as in its paper. The README's table and charts
// give the cost and error of each. ClothSettings::substeps = 2 with Multilevel{.passes = 1} costs about 1.5
// times as much as the default, and halves the error of the motion. Below half the cost of the default, only
// Jacobi with tethers is left, which makes stiff fabric on coarse meshes whip. TimeScheme says when backward
// Euler is the better choice.

#include <variant>

namespace weft {

/// Kang's approximate implicit solver: Jacobi iterations on the linearised step. Few iterations leave the
/// long waves unsolved: stiff cloth sags and lags.
struct Jacobi {
    /// Number per step, >= 0. More transmit forces further in a step. Choose odd counts: even ones
    /// over-correct the shortest waves up to twofold, odd ones never do.
    int iterations = 15;
    /// Whether the mean motion of each component without pins is solved exactly: such a component falls
    /// freely, and lands, however few iterations run. False: the paper's iteration alone; its first guess
    /// makes stiff cloth hover.
    bool exact_mean_motion = true;
    friend bool operator==(const Jacobi&, const Jacobi&) = default;
};

/// Chebyshev semi-iteration of block Jacobi on the interval [2 / kappa, 2] (Golub and Varga 1961).
struct Chebyshev {
    int iterations = 16;            ///< >= 1
    bool exact_mean_motion = true;  ///< as in Jacobi
    friend bool operator==(const Chebyshev&, const Chebyshev&) = default;
};

/// Conjugate gradients with the block diagonal as preconditioner and pins filtered (Baraff and Witkin 1998).
struct ConjugateGradient {
    int iterations = 32;  ///< >= 1
    friend bool operator==(const ConjugateGradient&, const ConjugateGradient&) = default;
};

/// Multigrid on any mesh, with exact Galerkin coarse operators; its cost does not grow with stiffness. Each
/// pass linearises the step and minimises it over three directions: the velocity, the last pass's change and
/// a multigrid cycle's correction. The residual then does no work on the cloth, so that stiff cloth does not
/// whip, however few passes there are.
struct Multilevel {
    /// Linearisations, 1 to 100000. Where the residual is large up to two more are added, and up to eight
    /// where it is above the tolerance. Where it is no small part of the motion, as in cloth that comes to
    /// rest, the last one has up to four cycles more. 3 bring a sheet of 65 x 65 to 18 mm from the reference
    /// after 0.5 s, 1 to 22 mm.
    int passes = 3;
    /// Residual that the last pass may leave, as the acceleration that would do the same work [m/s^2], rms
    /// over the cloth's mass, 0 to 1e9. Above it StepFlags::unsolved is set; above a seventh of it passes are
    /// added. The default, four gravities, is what an impact leaves in its first step.
    float tolerance = 40.0f;
    friend bool operator==(const Multilevel&, const Multilevel&) = default;
};

/// Extended position based dynamics (Macklin, Mueller, Chentanez 2016), coloured Gauss-Seidel. Raise
/// ClothSettings::substeps rather than iterations (Macklin et al. 2019).
struct Xpbd {
    int iterations = 1;  ///< >= 1, per substep
    friend bool operator==(const Xpbd&, const Xpbd&) = default;
};

/// Position based dynamics with fibres and sets: chains of constraints, each solved as a whole.
struct Fibres {
    enum class SetSolver {
        gauss_seidel,  ///< constraint by constraint along the fibre: cheap and stretchy
        ldlt,          ///< the fibre's tridiagonal system, factorised: converges some ten times faster
    };
    int iterations = 4;                    ///< >= 1, per substep
    SetSolver vertical = SetSolver::ldlt;  ///< stretch along the fibres that carry the weight
    SetSolver horizontal = SetSolver::gauss_seidel;
    SetSolver shear = SetSolver::gauss_seidel;
    friend bool operator==(const Fibres&, const Fibres&) = default;
};

/// Explicit: v += h f / m, x += h v. Stable only for h < 2 / omega of the stiffest mode: substeps in the
/// hundreds.
struct SymplecticEuler {
    friend bool operator==(const SymplecticEuler&, const SymplecticEuler&) = default;
};

using Method = std::variant<Multilevel, Jacobi, Chebyshev, ConjugateGradient, Xpbd, Fibres, SymplecticEuler>;

/// Order of accuracy in time of the implicit methods; the others have their own.
enum class TimeScheme {
    /// bdf2 with Multilevel, backward_euler with the other implicit methods: one linearisation of BDF2 sets
    /// stiff cloth buzzing.
    of_method,
    /// First order: a swing loses two thirds of its energy in 2 s at 60 steps a second, and is a fifth slower
    /// there than at 240. Suits cloth that should come to rest soon, and steps of 1/15 s.
    backward_euler,
    /// Second order: a swing loses a bit more than a third, and moves alike at 60 and at 240 steps a second.
    /// First order where contacts or pins have just changed a particle's path.
    bdf2,
};

/// The time scheme by which a method is stepped.
[[nodiscard]] constexpr TimeScheme resolved(TimeScheme scheme, const Method& method) {
    if (scheme != TimeScheme::of_method) return scheme;
    return std::holds_alternative<Multilevel>(method) ? TimeScheme::bdf2 : TimeScheme::backward_euler;
}

}  // namespace weft
