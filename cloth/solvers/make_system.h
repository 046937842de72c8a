#pragma once
// Which class each force model is.

#include <memory>

#include "cloth/system/implicit_system.h"

namespace weft {

/// The system of the settings' force model.
[[nodiscard]] std::unique_ptr<ImplicitSystem> make_system(const CookedCloth& model,
                                                          const ClothSettings& settings);

}  // namespace weft
