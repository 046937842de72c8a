#pragma once
// Damage to files that knows how they are built: JSON values, words and lines of text, numbers in binary
// data.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

/// Flips, overwrites, cuts out, doubles or cuts off bytes, once to three times.
[[nodiscard]] std::string mutated_bytes(Random& random, std::string bytes);

/// Of text: other numbers or words in place of some, lines left out, doubled or swapped, and now and then
/// damaged bytes.
[[nodiscard]] std::string mutated_text(Random& random, std::string text);

/// Values changed, removed, doubled or copied elsewhere, once to three times. As text: some of it is no JSON.
[[nodiscard]] std::string mutated_json(Random& random, nlohmann::json json);

/// Writes a number into four bytes that are aligned to four: one that is not finite, huge, negative, or an
/// index beyond all.
void spoil_word(Random& random, std::span<std::byte> bytes);

}  // namespace weft::fuzz
