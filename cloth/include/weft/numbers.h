#pragma once
// Numbers among settings, with their names and ranges: for editors, files and scripts.
//
//   for (const weft::SettingNumber& number : *weft::numbers_of(settings))
//       if (float* const* value = std::get_if<float*>(&number.value))
//           slider(number.field, *value, number.least, number.greatest);

#include <variant>
#include <vector>

#include "weft/error.h"
#include "weft/export.h"
#include "weft/settings.h"
#include "weft/types.h"

namespace weft {

/// A number or vector among settings. Its range is that of the field's comment, which a World holds it to.
struct SettingNumber {
    const char* type;   ///< struct that has the field: "Fabric"
    const char* field;  ///< "warp"
    /// Where it is: within the settings that were given, as long as they stand there.
    std::variant<float*, int*, Vec3*> value;
    float least, greatest;  ///< ends of its range, of each component of a vector, in the field's unit
    bool or_zero;           ///< whether 0 is right too; the field says what it means
    bool below_greatest;    ///< whether `greatest` itself is out of range
    /// Returns true if the range has this number.
    [[nodiscard]] WEFT_API bool has(double number) const noexcept;
};

/// Returns every number of the settings, in the order of their headers: of methods those of the chosen one,
/// of AirSource and AirShelter those that their kind has. Error: out of memory.
[[nodiscard]] WEFT_API Result<std::vector<SettingNumber>> numbers_of(ClothSettings& settings) noexcept;
[[nodiscard]] WEFT_API Result<std::vector<SettingNumber>> numbers_of(WorldSettings& settings) noexcept;

}  // namespace weft
