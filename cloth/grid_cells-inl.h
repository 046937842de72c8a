// A grid's cells lane by lane. Included as cloth/implicit/lanes-inl.h.

#if defined(WEFT_CLOTH_GRID_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_GRID_CELLS_INL_H
#undef WEFT_CLOTH_GRID_CELLS_INL_H
#else
#define WEFT_CLOTH_GRID_CELLS_INL_H
#endif

#include "cloth/grid_cells.h"
#include "cloth/implicit/grid_windows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// 0 for equal a and b: each product is rounded.
HWY_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// The two triangles of the cells whose first corners are the lanes from particle i on: one at the first
/// corner and the far left, one at the far right and the near right; the cut says which third corner each
/// has.
class CellLanes {
  public:
    HWY_INLINE CellLanes(const GridCells& cells, std::uint32_t i)
        : cut_(hn::ConvertTo(Tag(),
                             hn::PromoteTo(hn::RebindToSigned<Tag>(),
                                           hn::Load(hn::Rebind<std::int8_t, Tag>(), &cells.cuts[i])))) {}

    /// At the corners: what a loop's vector has there.
    struct Corners {
        Lanes3 first, near_right, far_left, far_right;
    };
    template <class Loop>
    static HWY_INLINE Corners corners(const Loop& loop, std::uint32_t vector) {
        return {loop.own(vector), loop.later(vector, 0), loop.later(vector, 1), loop.later(vector, 2)};
    }
    HWY_INLINE Lanes3 third_of_left(const Corners& at) const {
        return either(rises(), at.far_right, at.near_right);
    }
    HWY_INLINE Lanes3 third_of_right(const Corners& at) const {
        return either(rises(), at.first, at.far_left);
    }

    struct Triangles {
        Lanes3 left, right;
    };
    /// Normals times twice the areas; 0 where there is no cell.
    HWY_INLINE Triangles area_normals(const Corners& x) const {
        const auto is_cell = hn::Ne(cut_, hn::Zero(Tag()));
        return {keep_where(is_cell, cross(x.far_left - x.first, third_of_left(x) - x.first)),
                keep_where(is_cell, cross(x.near_right - x.far_right, third_of_right(x) - x.far_right))};
    }

    /// What a triangle has goes to each of its corners.
    struct Shares {
        Lanes first, near_right, far_left, far_right;
    };
    HWY_INLINE Shares shares(Lanes left, Lanes right) const {
        const Lanes both = hn::Add(left, right);
        return {hn::IfThenElse(rises(), both, left), hn::IfThenElse(rises(), right, both),
                hn::IfThenElse(rises(), left, both), hn::IfThenElse(rises(), both, right)};
    }

  private:
    HWY_INLINE hn::Mask<Tag> rises() const { return hn::Gt(cut_, hn::Zero(Tag())); }

    Lanes cut_;
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
