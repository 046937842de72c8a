#include "tests/targets/targets.h"

#include <hwy/highway.h>

namespace weft::test {

std::int64_t reference_target() {
    return HWY_SSSE3;
}

bool has_reference_target() {
    return (HWY_TARGETS & reference_target()) != 0;
}

std::vector<std::int64_t> vector_targets() {
    hwy::SetSupportedTargetsForTest(0);
    std::vector<std::int64_t> targets;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (target != reference_target()) targets.push_back(target);
    return targets;
}

bool is_fused(std::int64_t target) {
    constexpr std::int64_t fused = HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL | HWY_NEON;
    return (target & fused) != 0;
}

void use_target(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace weft::test
