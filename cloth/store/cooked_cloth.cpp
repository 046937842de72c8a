#include "cloth/store/cooked_cloth.h"

#include <utility>

#include "cloth/mesh/cooking/log_repairs.h"
#include "cloth/settings/validate.h"
#include "engine/memory/without_exceptions.h"

namespace weft {

CookedCloth::CookedCloth(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

Result<CookedCloth> CookedCloth::create(const Mesh& mesh, const ClothSettings& settings,
                                        const CookProgress& to_host) {
    return without_exceptions([&]() -> Result<CookedCloth> {
        if (const auto valid = validate(settings); !valid) return valid.error();
        const Progress progress(to_host);
        CookReport report;
        auto model = cook(mesh, settings.fabric.bending_ratio, &report, progress);
        if (!model) return model.error();
        if (auto valid = validate_neighbours(*model, settings); !valid) return valid.error();
        if (auto valid = validate_filling(*model, settings); !valid) return valid.error();
        CookedCloth cooked(
            std::make_shared<const Impl>(std::move(model).value(), std::move(report), settings, progress));
        if (progress.is_cancelled()) return Progress::cancelled();
        log_repairs(cooked.info());
        progress.reach(Progress::done);
        return cooked;
    });
}

const ClothInfo& CookedCloth::info() const noexcept {
    return impl_->info;
}

const CookReport& CookedCloth::report() const noexcept {
    return impl_->report;
}

}  // namespace weft
