#include "cloth/solver.h"

#include "cloth/explicit/symplectic_euler.h"
#include "cloth/forces/spring_system.h"
#include "cloth/forces/triangle_system.h"
#include "cloth/implicit/chebyshev.h"
#include "cloth/implicit/conjugate_gradient.h"
#include "cloth/implicit/jacobi.h"
#include "cloth/implicit/multilevel.h"
#include "cloth/positional/fibres.h"
#include "cloth/positional/xpbd.h"

namespace weft {

namespace {

template <class... Makers>
struct Overload : Makers... {
    using Makers::operator()...;
};
template <class... Makers>
Overload(Makers...) -> Overload<Makers...>;  // which clang does not deduce by itself before 17

}  // namespace

std::unique_ptr<Solver> make_solver(const CookedCloth& model, const ClothSettings& settings) {
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
            [&](const Multilevel&) -> Made { return std::make_unique<MultilevelSolver>(model, settings); },
            [&](const Fibres&) -> Made { return std::make_unique<FibresSolver>(model, settings); },
            [&](const Xpbd&) -> Made { return std::make_unique<XpbdSolver>(model, settings); },
        },
        settings.method);
}

std::unique_ptr<ImplicitSystem> make_system(const CookedCloth& model, const ClothSettings& settings) {
    if (settings.finite_elements.enabled) return std::make_unique<TriangleSystem>(model, settings);
    return std::make_unique<SpringSystem>(model);
}

}  // namespace weft
