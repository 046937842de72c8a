#include "demo/study/stability/stability_points.h"

#include "demo/study/stability/stability_causes.h"
#include "demo/study/stability/study_solvers.h"

namespace weft::study {

namespace {

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

StabilityPoint finite_elements() {
    StabilityPoint made =
        library("finite-elements", "Finite elements", Family::newton, Multilevel{}, 1, TimeScheme::bdf2);
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
    const auto multilevel = [](const std::string& name, const std::string& label, int passes,
                               TimeScheme scheme = TimeScheme::bdf2) {
        return library("multilevel-" + name, label, newton, Multilevel{.passes = passes}, 1, scheme);
    };
    return {
        weft_default(),
        multilevel("1", "Multilevel: 1 pass", 1),
        multilevel("2", "Multilevel: 2 passes", 2),
        multilevel("euler", "Multilevel: backward Euler", 3, TimeScheme::backward_euler),
        finite_elements(),
        jacobi("Jacobi: 15 iterations", {.iterations = 15}),
        jacobi("Jacobi: 16 iterations", {.iterations = 16}),
        library("chebyshev-16", "Chebyshev: 16 iterations", relaxation, Chebyshev{16}),
        library("cg-32", "Conjugate gradients: 32", one_linearisation, ConjugateGradient{32}),
        study_only<CholeskySolver>("cholesky", "Sparse Cholesky", one_linearisation),
        library("xpbd-1", "XPBD: 1 substep", positional, Xpbd{}),
        library("xpbd-16", "XPBD: 16 substeps", positional, Xpbd{}, 16),
        library("fibres-16", "Fibres: 16 substeps", positional, Fibres{.iterations = 1}, 16),
        library("symplectic-64", "Symplectic Euler: 64 substeps", symplectic_euler, SymplecticEuler{}, 64),
        study_only<ExplicitEulerSolver>("explicit-64", "Explicit Euler: 64 substeps", explicit_euler, 64),
    };
}

}  // namespace weft::study
