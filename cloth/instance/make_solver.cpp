#include "cloth/instance/make_solver.h"

#include "cloth/methods/explicit/symplectic_euler.h"
#include "cloth/methods/fibres/fibres.h"
#include "cloth/methods/linear/chebyshev.h"
#include "cloth/methods/linear/conjugate_gradient.h"
#include "cloth/methods/linear/jacobi.h"
#include "cloth/methods/positional/xpbd.h"
#include "cloth/solver/passes/multilevel.h"

namespace weft {

namespace {

template <class... Makers>
struct Overload : Makers... {
    using Makers::operator()...;
};
template <class... Makers>
Overload(Makers...) -> Overload<Makers...>;  // needed by clang before 17

}  // namespace

std::unique_ptr<Solver> make_solver(const ClothModel& model, const ClothSettings& settings,
                                    std::span<const Vec4> positions) {
    return make_solver(model, settings, positions, nullptr);
}

std::unique_ptr<Solver> make_solver(const ClothModel& model, const ClothSettings& settings,
                                    std::span<const Vec4> positions, SavedLevels* saved) {
    using Made = std::unique_ptr<Solver>;
    return std::visit(
        Overload{
            [&](const Jacobi&) -> Made { return std::make_unique<JacobiSolver>(model, settings); },
            [&](const Chebyshev&) -> Made { return std::make_unique<ChebyshevSolver>(model, settings); },
            [&](const SymplecticEuler&) -> Made {
                return std::make_unique<SymplecticEulerSolver>(model, settings);
            },
            [&](const ConjugateGradient&) -> Made {
                return std::make_unique<ConjugateGradientSolver>(model, settings);
            },
            [&](const Multilevel&) -> Made {
                return std::make_unique<MultilevelSolver>(model, settings, positions, saved);
            },
            [&](const Fibres&) -> Made { return std::make_unique<FibresSolver>(model, settings, positions); },
            [&](const Xpbd&) -> Made { return std::make_unique<XpbdSolver>(model, positions); },
        },
        settings.method);
}

}  // namespace weft
