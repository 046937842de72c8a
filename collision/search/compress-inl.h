// Compression: moves the lanes that pass a test together. Included as engine/simd/lanes-inl.h is.
//
// Highway 1.0.3's Compress for 8 and 4 lanes has its table in a local array: g++ copies that to the stack
// at every call, which took two thirds of a search's time on AVX2.

#if defined(WEFT_COLLISION_SEARCH_COMPRESS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SEARCH_COMPRESS_INL_H
#undef WEFT_COLLISION_SEARCH_COMPRESS_INL_H
#else
#define WEFT_COLLISION_SEARCH_COMPRESS_INL_H
#endif

#include <array>
#include <bit>
#include <cstdint>

#include "collision/search/cells-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

using IndexMask = hn::Mask<IndexTag>;

/// For each byte, the numbers of its set bits, ascending.
inline constexpr auto numbers_of_bits = [] {
    std::array<std::array<std::uint8_t, 8>, 256> numbers{};
    for (std::uint32_t bits = 0; bits < 256; ++bits)
        for (std::uint32_t rest = bits, k = 0; rest != 0; rest &= rest - 1)
            numbers[bits][k++] = static_cast<std::uint8_t>(std::countr_zero(rest));
    return numbers;
}();

/// Moves the lanes of a mask to the front, in ascending order.
class Kept {
  public:
    HWY_INLINE explicit Kept(IndexMask mask) : mask_(mask) {}

    [[nodiscard]] HWY_INLINE std::uint32_t count() const {
        return static_cast<std::uint32_t>(hn::CountTrue(IndexTag(), mask_));
    }
    /// The values in these lanes, then arbitrary ones.
    [[nodiscard]] HWY_INLINE Indices of(Indices values) const {
        if constexpr (part_lanes == 16)
            return hn::Compress(values, mask_);
        else
            return hn::TableLookupLanes(values, hn::IndicesFromVec(IndexTag(), lanes()));
    }
    /// The same of the numbers first, first + 1, ..
    [[nodiscard]] HWY_INLINE Indices of_numbers_from(std::uint32_t first) const {
        if constexpr (part_lanes == 16)
            return hn::Compress(indices_from(first), mask_);
        else
            return hn::Add(set_index(first), lanes());
    }

  private:
    HWY_INLINE Indices lanes() const {
        std::uint8_t bits[8];
        hn::StoreMaskBits(IndexTag(), mask_, bits);
        const hn::Rebind<std::uint8_t, IndexTag> bytes;
        return hn::PromoteTo(IndexTag(), hn::LoadU(bytes, numbers_of_bits[bits[0]].data()));
    }

    IndexMask mask_;
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
