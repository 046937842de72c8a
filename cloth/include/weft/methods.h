#pragma once
// How a cloth is stepped: one struct a method, each named after what its paper calls it. The README's table
// and charts say what each costs and how wrong it is. Against the default, Multilevel{.passes = 1,
// .iterations = 1} costs about half, but swings soon die, and ClothSettings::substeps = 2 about twice as
// much, for motion that is nearer to the truth by half. For less than half of the default, only Jacobi with
// tethers is left. TimeScheme says when backward Euler is the better choice.

#include <variant>

namespace weft {

/// Kang's approximate implicit solver: Jacobi iterations on the linearised step. Few iterations leave the
/// long waves unsolved: stiff cloth sags and lags.
struct Jacobi {
    /// >= 0. More carry forces further in a step. Take odd counts: they never over-correct, even ones do so
    /// up to twofold on the shortest waves.
    int iterations = 15;
    /// Solves the mean motion of each component without pins exactly, so that it falls freely, and lands,
    /// however few iterations run. False: the paper's iteration alone, whose first guess makes stiff cloth
    /// hover.
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

/// Multigrid on any mesh, with exact Galerkin coarse operators; what it costs does not grow with stiffness.
/// In each pass the step is linearised, and solved by conjugate gradients that a cycle preconditions.
struct Multilevel {
    int passes = 3;  ///< linearisations, >= 1: Newton's method as far as they go
    /// Of the conjugate gradients in the last pass, >= 1, after one in each other. Of more than one, where
    /// features touch, one is a pass instead: those that touch are others in each.
    int iterations = 3;
    /// The most work of a step, over that of the passes and iterations above, 1 to 1000. Where the equation
    /// is hard, steps that went too far are taken back in part, and passes are added; from about 3 on, unless
    /// features or bodies touch, it is solved anew by one linearisation with some ten iterations, by which
    /// small pieces of stiff cloth tremble. If too much is left, for a third of a second, of cloth that
    /// touches nothing and that neither the wind nor the host drives, it is solved for four seconds by one
    /// linearisation in the usual time: stiff cloth on a coarse mesh would whip to and fro for ever. An easy
    /// equation costs nothing more; 1 switches all of this off.
    float effort = 1.5f;
    /// What may be left after the passes above, as the error of acceleration that would do the same work
    /// [m/s^2], rms over the cloth's mass, 0 to 1e9: with more, the equation is hard, and if the effort does
    /// not suffice, StepFlags::unsolved is set. The default is about gravity; cloth of the default fabric
    /// that swings leaves half of that at most.
    float tolerance = 10.0f;
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
    /// First order: a swing loses two thirds of its energy in 2 s at 60 steps a second, and is a fifth
    /// slower there than at 240. For cloth that shall come to rest soon, and for steps of 1/15 s.
    backward_euler,
    /// Second order: a swing loses a bit more than a third, and moves alike at 60 and at 240 steps a second.
    /// First order where contacts or pins have just changed a particle's path.
    bdf2,
};

/// The one that a method is stepped by.
[[nodiscard]] constexpr TimeScheme resolved(TimeScheme scheme, const Method& method) {
    if (scheme != TimeScheme::of_method) return scheme;
    return std::holds_alternative<Multilevel>(method) ? TimeScheme::bdf2 : TimeScheme::backward_euler;
}

}  // namespace weft
