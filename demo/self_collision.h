#pragma once
// Methods of self-collision by name, as users choose them and as the study reports them.

#include <array>

#include "weft/settings.h"

namespace weft::demo {

/// In an order in which each guarantees more than the one before, and costs more.
inline constexpr std::array self_collision_methods{SelfCollisionMethod::off, SelfCollisionMethod::avoidance,
                                                   SelfCollisionMethod::impact_zones,
                                                   SelfCollisionMethod::contact};
[[nodiscard]] const char* name_of(SelfCollisionMethod method);

/// Sets the method, and no restitution where it has none; distance and friction stay as they are.
void set_method(SelfCollision& settings, SelfCollisionMethod method);

}  // namespace weft::demo
