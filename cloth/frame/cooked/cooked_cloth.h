#pragma once
// What a CookedCloth holds.

#include <memory>
#include <optional>
#include <utility>

#include "cloth/frame/cloth.h"
#include "cloth/solvers/multigrid/multigrid.h"
#include "weft/cooked_cloth.h"

namespace weft {

struct WEFT_LOCAL CookedCloth::Impl {
    Impl(ClothModel&& model, CookReport&& of_cooking, const ClothSettings& settings,
         const Progress& progress = {}, SavedLevels* saved = nullptr)
        : cloth(std::move(model), settings, progress, saved),
          info(cloth.info()),
          report(std::move(of_cooking)) {
        const Multigrid* const multigrid = cloth.solver->multigrid();
        if (multigrid == nullptr) return;
        levels.emplace(multigrid->constant_part());
        levels->kind = SystemKind(settings);
    }

    const Cloth cloth;  ///< never in a World: others are copies of it
    ClothInfo info;
    CookReport report;
    std::optional<SavedLevels> levels;  ///< the cloth's, if its method has any: for the file
};

}  // namespace weft
