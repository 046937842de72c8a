#pragma once
// What a CookedCloth holds.

#include <memory>
#include <utility>

#include "cloth/frame/cloth.h"
#include "weft/cooked_cloth.h"

namespace weft {

struct WEFT_LOCAL CookedCloth::Impl {
    Impl(ClothModel&& model, CookReport&& of_cooking, const ClothSettings& settings,
         const Progress& progress = {})
        : cloth(std::move(model), settings, progress), info(cloth.info()), report(std::move(of_cooking)) {}

    const Cloth cloth;  ///< never in a World: others are copies of it
    ClothInfo info;
    CookReport report;
};

}  // namespace weft
