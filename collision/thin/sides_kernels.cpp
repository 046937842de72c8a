#include "collision/thin/sides_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/thin/sides_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/shapes/round_lanes-inl.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

using SideBits = hn::Vec<hn::RebindToUnsigned<Tag>>;

/// The bits of one coordinate, given at both ends. `rounding`: its greatest error.
HWY_INLINE SideBits beyond(Lanes from, Lanes to, Lanes rounding, float lower, float upper,
                           std::uint32_t bit) {
    const hn::RebindToUnsigned<Tag> du;
    const auto below = hn::Lt(hn::Add(hn::Max(from, to), rounding), set(lower));
    const auto above = hn::Gt(hn::Sub(hn::Min(from, to), rounding), set(upper));
    return hn::Or(hn::IfThenElseZero(hn::RebindMask(du, below), hn::Set(du, bit)),
                  hn::IfThenElseZero(hn::RebindMask(du, above), hn::Set(du, 2 * bit)));
}

HWY_INLINE Lanes size_of(const Lanes3& v) {
    return hn::Add(hn::Abs(v.x), hn::Add(hn::Abs(v.y), hn::Abs(v.z)));
}

HWY_INLINE SideBits sides_of(const TurningBox& box, const Vec4* starts, const Vec4* positions) {
    const Lanes3 from = xyz(load_rows(starts)) - set3(box.origin_at_start);
    const Lanes3 to = xyz(load_rows(positions)) - set3(box.origin);
    const Lanes sizes = hn::Add(size_of(from), size_of(to));
    const Lanes rounding = hn::Mul(sizes, set(1e-6f));
    const Lanes3 first = turned(box.to_own_at_start, from), last = turned(box.to_own, to);
    const Vector3 &lower = box.lower, &upper = box.upper;
    const SideBits of_x = beyond(first.x, last.x, rounding, lower.x(), upper.x(), 1);
    const SideBits of_y = beyond(first.y, last.y, rounding, lower.y(), upper.y(), 4);
    const SideBits of_z = beyond(first.z, last.z, rounding, lower.z(), upper.z(), 16);
    const SideBits sides = hn::Or(of_x, hn::Or(of_y, of_z));
    const hn::RebindToUnsigned<Tag> du;
    const auto are_numbers = hn::Lt(sizes, set(1e30f));
    return hn::IfThenElseZero(hn::RebindMask(du, are_numbers), sides);
}

void sides_in(const TurningBox& box, std::span<const Vec4> starts, std::span<const Vec4> positions,
              std::span<std::uint32_t> sides) {
    const hn::RebindToUnsigned<Tag> du;
    std::size_t i = 0;
    for (; i + part_lanes <= positions.size(); i += part_lanes)
        hn::StoreU(sides_of(box, &starts[i], &positions[i]), du, &sides[i]);
    if (i == positions.size()) return;
    Vec4 from[part_lanes] = {}, to[part_lanes] = {};
    std::copy(starts.begin() + static_cast<std::ptrdiff_t>(i), starts.end(), from);
    std::copy(positions.begin() + static_cast<std::ptrdiff_t>(i), positions.end(), to);
    std::uint32_t last[part_lanes];
    hn::StoreU(sides_of(box, from, to), du, last);
    std::copy(last, last + (positions.size() - i), sides.begin() + static_cast<std::ptrdiff_t>(i));
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(sides_in);

void find_sides(const TurningBox& box, std::span<const Vec4> starts, std::span<const Vec4> positions,
                std::span<std::uint32_t> sides) {
    HWY_DYNAMIC_DISPATCH(sides_in)(box, starts, positions, sides);
}

}  // namespace weft
#endif
