#include "cloth/solver/make_system.h"

#include "cloth/fabric/spring_system.h"
#include "cloth/methods/finite_elements/triangle_system.h"

namespace weft {

std::unique_ptr<ImplicitSystem> make_system(const ClothModel& model, const ClothSettings& settings) {
    if (settings.finite_elements.enabled) return std::make_unique<TriangleSystem>(model, settings);
    return std::make_unique<SpringSystem>(model, settings.fabric.stiffening > 0);
}

}  // namespace weft
