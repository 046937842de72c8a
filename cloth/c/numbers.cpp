// For C: the numbers of settings, with their ranges.

#include "cloth/c/handles.h"

namespace weft::c {

namespace {

/// Fields beyond the end of an older host's struct are left out.
template <class Of, class C>
WeftResult list_numbers(C* settings, WeftSettingNumber* numbers, std::size_t room, std::size_t* count) {
    return guarded([&]() -> Result<void> {
        if (auto there = are_there({{settings, "settings"}, {count, "count"}}); !there) return there;
        if (room > 0 && numbers == nullptr) return null_pointer("numbers");
        auto of = take<Of>("settings", settings);
        if (!of) return of.error();
        const auto* const begin = reinterpret_cast<const std::byte*>(settings);
        std::size_t found = 0;
        const auto add = [&]<class Field>(const char* type, const char* field, Field& value,
                                          const Range& range) {
            const auto* const end = reinterpret_cast<const std::byte*>(&value + 1);
            if (static_cast<std::size_t>(end - begin) > settings->struct_size) return;
            WeftSettingNumber number{type,
                                     field,
                                     nullptr,
                                     nullptr,
                                     1,
                                     range.least,
                                     range.greatest,
                                     range.ends == Ends::or_zero,
                                     range.ends == Ends::open_above};
            if constexpr (std::same_as<Field, WeftVec3>)
                number.number = &value.x, number.components = 3;
            else if constexpr (std::same_as<Field, float>)
                number.number = &value;
            else
                number.whole = &value;
            if (found < room) numbers[found] = number;
            ++found;
        };
        for_each_leaf(*settings, *of,
                      [&](const char* type, const char* field, auto& value, const auto&... range) {
                          if constexpr (sizeof...(range) > 0) add(type, field, value, range...);
                      });
        *count = found;
        return {};
    });
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

WeftResult weft_cloth_settings_numbers(WeftClothSettings* settings, WeftSettingNumber* numbers, size_t room,
                                       size_t* count) {
    return list_numbers<weft::ClothSettings>(settings, numbers, room, count);
}
WeftResult weft_world_settings_numbers(WeftWorldSettings* settings, WeftSettingNumber* numbers, size_t room,
                                       size_t* count) {
    return list_numbers<weft::WorldSettings>(settings, numbers, room, count);
}
