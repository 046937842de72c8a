#include "demo/options/method_table.h"

#include <algorithm>
#include <array>

namespace weft::demo {
namespace {

const std::array<NamedMethod, std::variant_size_v<Method>> methods{{
    {"multilevel", "Multilevel", "Multigrid on any mesh: stiff cloth stays stiff, at any size.",
     Multilevel{}},
    {"jacobi", "Jacobi (Kang)", "The cheapest iteration; stiff cloth sags and lags. Take odd counts.",
     Jacobi{}},
    {"chebyshev", "Chebyshev", "Jacobi, accelerated: some ten times fewer iterations for the same error.",
     Chebyshev{}},
    {"conjugate-gradient", "Conjugate gradients", "The best of what as many matrix products can do.",
     ConjugateGradient{}},
    {"xpbd", "XPBD", "Extended position based dynamics. Raise the cloth's substeps, not the iterations.",
     Xpbd{}},
    {"fibres", "Fibres and sets", "Position based dynamics, fibre by fibre.", Fibres{}},
    {"symplectic-euler", "Symplectic Euler",
     "Explicit: exact as the step shrinks, and unstable unless the cloth takes hundreds of substeps.",
     SymplecticEuler{}},
}};

}  // namespace

std::span<const NamedMethod> all_methods() {
    return methods;
}

const NamedMethod* find_method(std::string_view name) {
    const auto found =
        std::ranges::find_if(methods, [&](const NamedMethod& entry) { return name == entry.name; });
    return found == methods.end() ? nullptr : &*found;
}

const NamedMethod& entry_of(const Method& method) {
    return methods[method.index()];
}

std::optional<int> iterations_of(const Method& method) {
    return std::visit(
        [](const auto& each) -> std::optional<int> {
            if constexpr (requires { each.iterations; }) return each.iterations;
            if constexpr (requires { each.passes; }) return each.passes;
            return std::nullopt;
        },
        method);
}

void set_iterations(Method& method, int iterations) {
    std::visit(
        [&](auto& each) {
            if constexpr (requires { each.iterations; }) each.iterations = iterations;
            if constexpr (requires { each.passes; }) each.passes = iterations;
        },
        method);
}

bool has_time_scheme(const Method& method) {
    return std::holds_alternative<Multilevel>(method) || std::holds_alternative<Jacobi>(method) ||
           std::holds_alternative<Chebyshev>(method) || std::holds_alternative<ConjugateGradient>(method);
}

}  // namespace weft::demo
