#pragma once
// What a script leaves as a recording: stepped again, and damaged.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

[[nodiscard]] RecordingSink sink_to(std::vector<std::byte>& bytes);

/// It has the same bytes on two threads; cut off anywhere it is replayed up to there; a flipped bit is
/// refused, and one whose checksums were made right does no harm. Throws Failure.
void check_recording(std::uint64_t seed, std::span<const std::byte> recorded);

}  // namespace weft::fuzz
