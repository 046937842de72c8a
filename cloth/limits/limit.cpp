#include "cloth/limits/limit.h"

#include "cloth/limits/tethers.h"

namespace weft {

Limits make_limits(const ClothModel& model, const ClothSettings& settings,
                   std::span<const std::uint32_t> pins) {
    Limits limits;
    if (settings.tethers.enabled) limits.push_back(std::make_unique<LongRangeAttachments>(model));
    for (const std::unique_ptr<Limit>& limit : limits) {
        limit->prepare(model, pins);
        limit->commit();
    }
    return limits;
}

bool have_same_limits(const ClothSettings& a, const ClothSettings& b) {
    return a.tethers.enabled == b.tethers.enabled;
}

}  // namespace weft
