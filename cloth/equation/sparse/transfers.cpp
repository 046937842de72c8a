#include "cloth/equation/sparse/transfers.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/equation/sparse/transfers.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/sparse/transfers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

// Four sums side by side, so that no term waits for the one before it.
void restrict_rows(const Interpolation& p, const BlockRange& range, const Vec4* fine, Vec4* coarse) {
    const RowTag d;
    const std::uint32_t* const entries = p.entries.data();
    const float* const weights = p.weights.data();
    const auto add = [&](std::uint32_t e, RowLanes sum) HWY_ATTR {
        return add_weighted(weights[entries[e]], fine[entries[e] / Interpolation::width], sum);
    };
    for (std::uint32_t c = range.begin; c < range.end; ++c) {
        RowLanes s0 = hn::Zero(d), s1 = s0, s2 = s0, s3 = s0;
        std::uint32_t e = p.offsets[c];
        const std::uint32_t end = p.offsets[c + 1];
        for (; e + 4 <= end; e += 4) {
            s0 = add(e, s0);
            s1 = add(e + 1, s1);
            s2 = add(e + 2, s2);
            s3 = add(e + 3, s3);
        }
        for (; e < end; ++e) s0 = add(e, s0);
        hn::Store(hn::Add(hn::Add(s0, s1), hn::Add(s2, s3)), d, &coarse[c].x);
    }
}

void prolong_rows(const Correction& correction, const BlockRange& range, Vec4* fine) {
    const RowTag d;
    for (std::uint32_t i = range.begin; i < range.end; ++i)
        hn::Store(corrected(correction, i, hn::Load(d, &fine[i].x)), d, &fine[i].x);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // code that does not depend on the machine
namespace weft {

HWY_EXPORT(restrict_rows);
HWY_EXPORT(prolong_rows);

void restrict_to(Parallel& parallel, const Interpolation& p, std::span<const Vec4> fine,
                 std::span<Vec4> coarse) {
    coarse_ranges(parallel, p.coarse, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(restrict_rows)(p, range, fine.data(), coarse.data());
    });
}

void prolong_from(Parallel& parallel, const Correction& correction, std::span<Vec4> fine) {
    parallel.ranges(static_cast<std::uint32_t>(fine.size()), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(prolong_rows)(correction, range, fine.data());
    });
}

}  // namespace weft
#endif
