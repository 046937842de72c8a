#pragma once
// The data of a CookedCloth.

#include <memory>
#include <optional>
#include <utility>

#include "cloth/instance/cloth.h"
#include "cloth/instance/saved_cloth.h"
#include "cloth/solver/levels/multigrid.h"
#include "weft/cooked_cloth.h"

namespace weft {

struct WEFT_LOCAL CookedCloth::Impl {
    Impl(ClothModel&& model, CookReport&& of_cooking, const ClothSettings& settings, const Progress& progress)
        : cloth(std::move(model), settings, progress), report(std::move(of_cooking)) {
        complete();
    }
    Impl(ClothModel&& model, CookReport&& of_cooking, const ClothSettings& settings, SavedCloth&& saved)
        : cloth(std::move(model), settings, std::move(saved)), report(std::move(of_cooking)) {
        complete();
    }

    const Cloth cloth;  ///< a prototype, only to be copied: never in a World
    ClothInfo info;
    CookReport report;
    std::optional<SavedLevels> levels;  ///< of the cloth's solver, for the file; none if its method has none

  private:
    void complete() {
        info = cloth.info();
        const Multigrid* const multigrid = cloth.solver->multigrid();
        if (multigrid == nullptr) return;
        levels.emplace(multigrid->constant_part());
        levels->kind = SystemKind(cloth.settings);
    }
};

}  // namespace weft
