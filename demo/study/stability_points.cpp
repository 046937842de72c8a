#include "demo/study/stability_points.h"

#include "cloth/implicit/chebyshev.h"
#include "demo/study/explicit_euler.h"

namespace weft::study {

namespace {

/// Chebyshev on an interval that ends below the spectrum, as power iteration stopped early would have it.
class ShortChebyshevSolver final : public LinearSolver {
  public:
    static constexpr int iterations = 16;
    static constexpr Spectrum interval{.least = 0.1, .largest = 1.7};

    ShortChebyshevSolver(const CookedCloth& model, const ClothSettings& settings)
        : LinearSolver(model, settings), vectors_(model.particle_count) {}
    [[nodiscard]] std::size_t bytes() const noexcept override {
        return LinearSolver::bytes() + vectors_.bytes();
    }

  protected:
    float solve_linear(const SolverStep& step, ImplicitSystem& system) override {
        return solve_chebyshev(step.parallel, system, iterations, interval, vectors_, step.velocity_change);
    }

  private:
    ChebyshevVectors vectors_;
};

MethodPoint point(const std::string& name, const std::string& label, const Method& method, int substeps = 1,
                  TimeScheme time_scheme = TimeScheme::backward_euler) {
    const auto configure = [=](ClothSettings& settings) {
        settings.method = method;
        settings.substeps = substeps;
        settings.time_scheme = time_scheme;
    };
    return {.name = name, .label = label, .setting = "", .configure = configure, .make_solver = {}};
}

/// A method that only the study has; the solver that the settings name is not used.
template <class StudySolver>
MethodPoint study_point(const std::string& name, const std::string& label, int substeps = 1) {
    MethodPoint made = point(name, label, SymplecticEuler{}, substeps);
    made.make_solver = [](const CookedCloth& model, const ClothSettings& settings) {
        return std::make_unique<StudySolver>(model, settings);
    };
    return made;
}

MethodPoint default_point() {
    const ClothSettings settings;
    MethodPoint made =
        point("default", "Weft's default", settings.method, settings.substeps, settings.time_scheme);
    made.is_default = true;
    return made;
}

}  // namespace

std::vector<MethodPoint> stability_points() {
    return {
        default_point(),
        point("jacobi-0", "Jacobi: the first guess alone",
              Jacobi{.iterations = 0, .exact_mean_motion = false}),
        point("jacobi-1", "Jacobi, 1 iteration", Jacobi{.iterations = 1, .exact_mean_motion = false}),
        point("jacobi-2", "Jacobi, 2 iterations", Jacobi{2}),
        point("jacobi-15", "Jacobi, 15 iterations", Jacobi{15}),
        point("jacobi-16", "Jacobi, 16 iterations", Jacobi{16}),
        point("chebyshev-16", "Chebyshev, 16 iterations", Chebyshev{16}),
        study_point<ShortChebyshevSolver>("chebyshev-short", "Chebyshev, interval to 1.7"),
        point("cg-32", "Conjugate gradients, 32 it.", ConjugateGradient{32}),
        point("xpbd-1", "XPBD, 1 substep", Xpbd{}),
        point("xpbd-16", "XPBD, 16 substeps", Xpbd{}, 16),
        point("symplectic-1", "Symplectic Euler, 1 substep", SymplecticEuler{}),
        point("symplectic-64", "Symplectic Euler, 64 substeps", SymplecticEuler{}, 64),
        study_point<ExplicitEulerSolver>("explicit-64", "Explicit Euler, 64 substeps", 64),
    };
}

}  // namespace weft::study
