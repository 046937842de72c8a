#pragma once
// A cooked cloth as a file: read back, and damaged.

#include <cstdint>

#include "weft/weft.h"

namespace weft::fuzz {

/// What was saved and read again. Cut off or with a flipped bit it is refused; with a flipped bit and a
/// checksum that was made right it is refused, or a World steps it without harm. Throws Failure.
[[nodiscard]] Result<CookedCloth> saved_and_read(const CookedCloth& cooked, const ClothSettings& settings,
                                                 std::uint64_t seed);

}  // namespace weft::fuzz
