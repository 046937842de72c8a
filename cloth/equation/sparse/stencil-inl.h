// Loads of Vec4 rows, a stencil's own and its neighbours'. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_CLOTH_EQUATION_SPARSE_STENCIL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_EQUATION_SPARSE_STENCIL_INL_H
#undef WEFT_CLOTH_EQUATION_SPARSE_STENCIL_INL_H
#else
#define WEFT_CLOTH_EQUATION_SPARSE_STENCIL_INL_H
#endif

#include "cloth/equation/sparse/stencil.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

static_assert(Stencil::lanes == group_lanes);

/// The rows of the neighbours in the part of slot s that begins at `lane`.
HWY_INLINE Lanes3 neighbour_rows(const Stencil& stencil, std::uint32_t s, std::uint32_t lane,
                                 const Vec4* rows) {
    const std::uint32_t first = stencil.runs[s];
    return first != Stencil::no_run ? xyz(load_rows(rows + first + lane))
                                    : gather_rows(rows, &stencil.neighbours[s * Stencil::lanes + lane]);
}

/// A vector as it lies in memory.
struct RowsInMemory {
    const Stencil& stencil;
    const Vec4* rows;

    HWY_INLINE void come_to(std::uint32_t /*i*/) {}
    /// The rows of the lanes from row i on.
    HWY_INLINE Lanes3 own(std::uint32_t i) const { return xyz(load_rows(rows + i)); }
    /// The rows of the neighbours in the part of slot s that begins at `lane`.
    HWY_INLINE Lanes3 neighbours(std::uint32_t s, std::uint32_t lane) const {
        return neighbour_rows(stencil, s, lane, rows);
    }
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
