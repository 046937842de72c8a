#pragma once
// Highway's targets: which this machine can run, and which one the kernels use.

#include <cstdint>
#include <vector>

namespace weft::test {

/// The narrowest of x86, which rounds after each product: what all others are compared with.
[[nodiscard]] std::int64_t reference_target();
/// Other machines do not, nor builds for processors that have more.
[[nodiscard]] bool has_reference_target();
/// All others that are compiled and that this machine can run, the widest first.
[[nodiscard]] std::vector<std::int64_t> vector_targets();
/// Whether a * b + c is rounded once.
[[nodiscard]] bool is_fused(std::int64_t target);
/// From here on, in all kernels of this process.
void use_target(std::int64_t target);

}  // namespace weft::test
