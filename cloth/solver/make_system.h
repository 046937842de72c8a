#pragma once
// The class of system for each force model.

#include <memory>

#include "cloth/equation/implicit_system.h"

namespace weft {

/// The system of the settings' force model.
[[nodiscard]] std::unique_ptr<ImplicitSystem> make_system(const ClothModel& model,
                                                          const ClothSettings& settings);

/// The settings that make_system reads. All others reach a system at each step.
struct SystemKind {
    explicit SystemKind(const ClothSettings& settings)
        : elements(settings.finite_elements.enabled),
          bending(elements && settings.fabric.bending > 0),
          dihedral(elements && settings.finite_elements.dihedral),
          consistent_mass(elements && settings.finite_elements.consistent_mass),
          stiffening(!elements && settings.fabric.stiffening > 0) {}
    bool elements, bending, dihedral, consistent_mass, stiffening;
    friend bool operator==(const SystemKind&, const SystemKind&) = default;
};

}  // namespace weft
