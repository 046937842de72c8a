#include "demo/study/stability/stability_points.h"

#include "cloth/methods/linear/chebyshev.h"
#include "demo/study/stability/cholesky.h"
#include "demo/study/stability/explicit_euler.h"
#include "demo/study/stability/stiffest_modes.h"

namespace weft::study {

namespace {

/// Chebyshev on an interval that ends below the spectrum, as power iteration stopped early would have it.
class ShortChebyshevSolver final : public LinearSolver {
  public:
    static constexpr int iterations = 16;
    static constexpr Spectrum interval{.least = 0.1, .largest = 1.7};

    ShortChebyshevSolver(const ClothModel& model, const ClothSettings& settings)
        : LinearSolver(model, settings), scratch_(model.particle_count) {}
    [[nodiscard]] std::size_t bytes() const noexcept override {
        return LinearSolver::bytes() + scratch_.bytes();
    }

  protected:
    bool solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override {
        solve_chebyshev(step.parallel, system, iterations, interval, scratch_.span(), dv);
        return true;
    }

  private:
    AlignedBuffer<Vec4> scratch_;
};

/// One of the library's methods.
StabilityPoint library(const std::string& name, const std::string& label, Family family, const Method& method,
                       int substeps = 1, TimeScheme time_scheme = TimeScheme::backward_euler) {
    const auto configure = [=](ClothSettings& settings) {
        settings.method = method;
        settings.substeps = substeps;
        settings.time_scheme = time_scheme;
    };
    return {{.name = name, .label = label, .setting = "", .configure = configure, .make_solver = {}}, family};
}

/// A method that only the study has; the solver that the settings name is not used.
template <class StudySolver>
StabilityPoint study_only(const std::string& name, const std::string& label, Family family,
                          int substeps = 1) {
    StabilityPoint made = library(name, label, family, SymplecticEuler{}, substeps);
    made.method.make_solver = [](const ClothModel& model, const ClothSettings& settings) {
        return std::make_unique<StudySolver>(model, settings);
    };
    return made;
}

StabilityPoint weft_default() {
    const ClothSettings settings;
    StabilityPoint made = library("default", "Weft's default", Family::newton, settings.method,
                                  settings.substeps, settings.time_scheme);
    made.method.is_default = true;
    return made;
}

StabilityPoint jacobi(const std::string& label, const Jacobi& method) {
    const int k = method.iterations;
    StabilityPoint made = library("jacobi-" + std::to_string(k), label, Family::relaxation, method);
    made.left_of = [k](double lambda) { return left_by_jacobi(k, lambda); };
    return made;
}

StabilityPoint short_chebyshev() {
    using Solver = ShortChebyshevSolver;
    StabilityPoint made =
        study_only<Solver>("chebyshev-short", "Chebyshev: interval to 1.7", Family::relaxation);
    made.left_of = [](double lambda) {
        return left_by_chebyshev(Solver::iterations, Solver::interval.least, Solver::interval.largest,
                                 lambda);
    };
    return made;
}

StabilityPoint finite_elements() {
    StabilityPoint made =
        library("finite-elements", "Finite elements: multilevel", Family::newton, Multilevel{});
    made.method.configure = [configure = made.method.configure](ClothSettings& settings) {
        configure(settings);
        settings.finite_elements.enabled = true;
    };
    return made;
}

}  // namespace

std::string name_of(Family family) {
    switch (family) {
        case Family::explicit_euler:
            return "explicit euler";
        case Family::symplectic_euler:
            return "symplectic euler";
        case Family::relaxation:
            return "relaxation";
        case Family::one_linearisation:
            return "one linearisation";
        case Family::newton:
            return "newton";
        case Family::positional:
            return "positional";
    }
    return {};
}

std::vector<StabilityPoint> stability_points() {
    using enum Family;
    const auto multilevel = [](const std::string& name, const std::string& label, Family family,
                               const Multilevel& method, TimeScheme scheme = TimeScheme::backward_euler) {
        return library("multilevel-" + name, "Multilevel: " + label, family, method, 1, scheme);
    };
    return {
        weft_default(),
        multilevel("1", "1 pass", one_linearisation, {.passes = 1}),
        multilevel("2", "2 passes", newton, {.passes = 2}),
        multilevel("bdf2", "3 passes; BDF2", newton, {.passes = 3}, TimeScheme::bdf2),
        multilevel("bdf2-2", "2 passes; BDF2", newton, {.passes = 2}, TimeScheme::bdf2),
        multilevel("6", "6 passes", newton, {.passes = 6}),
        jacobi("Jacobi: first guess alone", {.iterations = 0, .exact_mean_motion = false}),
        jacobi("Jacobi: 1 iteration", {.iterations = 1, .exact_mean_motion = false}),
        jacobi("Jacobi: 2 iterations", {.iterations = 2}),
        jacobi("Jacobi: 15 iterations", {.iterations = 15}),
        jacobi("Jacobi: 16 iterations", {.iterations = 16}),
        library("chebyshev-16", "Chebyshev: 16 iterations", relaxation, Chebyshev{16}),
        short_chebyshev(),
        library("cg-32", "Conjugate gradients: 32", one_linearisation, ConjugateGradient{32}),
        study_only<CholeskySolver>("cholesky", "Sparse Cholesky", one_linearisation),
        finite_elements(),
        library("xpbd-1", "XPBD: 1 substep", positional, Xpbd{}),
        library("xpbd-16", "XPBD: 16 substeps", positional, Xpbd{}, 16),
        library("fibres-1", "Fibres: 4 iterations", positional, Fibres{}),
        library("fibres-16", "Fibres: 16 substeps", positional, Fibres{.iterations = 1}, 16),
        library("symplectic-1", "Symplectic Euler", symplectic_euler, SymplecticEuler{}),
        library("symplectic-64", "Symplectic Euler: 64 substeps", symplectic_euler, SymplecticEuler{}, 64),
        study_only<ExplicitEulerSolver>("explicit-64", "Explicit Euler: 64 substeps", explicit_euler, 64),
    };
}

}  // namespace weft::study
