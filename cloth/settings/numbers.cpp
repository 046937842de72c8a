#include "weft/numbers.h"

#include "cloth/settings/fields.h"
#include "engine/memory/without_exceptions.h"

namespace weft {

namespace {

template <class Settings>
Result<std::vector<SettingNumber>> listed(Settings& settings) noexcept {
    return without_exceptions([&]() -> Result<std::vector<SettingNumber>> {
        std::vector<SettingNumber> all;
        for_each_leaf(settings, settings,
                      [&](const char* type, const char* field, auto& value, const auto&... range) {
                          if constexpr (sizeof...(range) > 0)
                              (all.push_back({type, field, &value, range.least, range.greatest,
                                              range.ends == Ends::or_zero, range.ends == Ends::open_above}),
                               ...);
                      });
        return all;
    });
}

}  // namespace

bool SettingNumber::has(double number) const noexcept {
    const Ends ends = or_zero ? Ends::or_zero : below_greatest ? Ends::open_above : Ends::closed;
    return Range{least, greatest, ends}.has(number);
}

Result<std::vector<SettingNumber>> numbers_of(ClothSettings& settings) noexcept {
    return listed(settings);
}
Result<std::vector<SettingNumber>> numbers_of(WorldSettings& settings) noexcept {
    return listed(settings);
}

}  // namespace weft
