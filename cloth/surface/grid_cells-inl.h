// A grid's cells lane by lane. Included as cloth/equation/sparse/stencil-inl.h.

#if defined(WEFT_CLOTH_SURFACE_GRID_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_SURFACE_GRID_CELLS_INL_H
#undef WEFT_CLOTH_SURFACE_GRID_CELLS_INL_H
#else
#define WEFT_CLOTH_SURFACE_GRID_CELLS_INL_H
#endif

#include <algorithm>
#include <array>

#include "cloth/equation/grid/grid_windows-inl.h"
#include "cloth/surface/grid_cells.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The cross product; exactly 0 for equal a and b, since each product is rounded.
HWY_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// A vector's values at the corners of cells.
struct Corners {
    Lanes3 first, near_right, far_left, far_right;
};
/// Shares of a value that cells give to their corners.
struct Shares {
    Lanes first, near_right, far_left, far_right;
};

/// The two triangles of the cells whose first corners are the lanes from particle i on. The left one has the
/// first and the far left corner, the right one the far right and the near right. The cut decides which third
/// corner each has.
class CellLanes {
  public:
    HWY_INLINE CellLanes(const GridCells& cells, std::uint32_t i)
        : cut_(hn::ConvertTo(Tag(),
                             hn::PromoteTo(hn::RebindToSigned<Tag>(),
                                           hn::Load(hn::Rebind<std::int8_t, Tag>(), &cells.cuts[i])))) {}

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

    /// The shares of corners, each the sum of its triangles' values.
    HWY_INLINE Shares shares(Lanes left, Lanes right) const {
        const Lanes both = hn::Add(left, right);
        return {hn::IfThenElse(rises(), both, left), hn::IfThenElse(rises(), right, both),
                hn::IfThenElse(rises(), left, both), hn::IfThenElse(rises(), both, right)};
    }

  private:
    HWY_INLINE hn::Mask<Tag> rises() const { return hn::Gt(cut_, hn::Zero(Tag())); }

    Lanes cut_;
};

/// Moves lanes by one, part after part.
struct LaneBefore {
    Lanes last;  ///< of the previous part, moved to the first lane

    /// Returns in each lane the value of the lane before; in the first, the previous part's last.
    HWY_INLINE Lanes operator()(Lanes values) {
        const Tag d;
        const Lanes turned = hn::TableLookupLanes(values, hn::SetTableIndices(d, indices.data()));
        const Lanes moved = hn::IfThenElse(hn::FirstN(d, 1), last, turned);
        last = turned;
        return moved;
    }

    alignas(64) static constexpr auto indices = [] {
        std::array<std::int32_t, part_lanes> before{};
        for (std::uint32_t k = 0; k < part_lanes; ++k)
            before[k] = static_cast<std::int32_t>((k + part_lanes - 1) % part_lanes);
        return before;
    }();
};

/// A loop over the cells of a tile and of its halo, by their first corners. At each part of a group a kernel
/// calls read_ahead(), corners() for some vectors, sums() and go_on(). The loop must be inlined into the
/// kernel, as GridLoop must.
template <std::uint32_t vectors, std::uint32_t shared>
class CellLoop {
    static_assert(shared <= GridCells::most_shared);

  public:
    HWY_INLINE CellLoop(const GridCells& cells, const BlockRange& tile, const GridWindow& window)
        : columns_(cells.columns),
          ahead_(window.values, cells.diagonals, tile.begin, false),
          far_(ahead_.behind()),
          mask_(GridWindows::ring_of(columns_) - 1),
          next_(mask_ + 1 + group_lanes) {
        for (std::uint32_t k = 0; k < shared; ++k) near_right_[k].last = far_right_[k].last = hn::Zero(Tag());
        if (first() == 0) std::fill(far_, far_ + shared * next_, 0.0f);  // no cells come before the first row
    }
    CellLoop(const CellLoop&) = delete;

    [[nodiscard]] HWY_INLINE std::uint32_t first() const { return ahead_.row(); }

    /// See RowsAhead.
    template <class Row>
    HWY_INLINE void read_ahead(const Row& row) {
        ahead_.read(row);
    }
    HWY_INLINE Corners corners(std::uint32_t vector) const {
        return {ahead_.after(0, vector), ahead_.after(0, vector, 1), ahead_.after(columns_, vector),
                ahead_.after(columns_, vector, 1)};
    }

    /// Sums each value over the cells around the particles of these lanes. `shares` are those of the cells
    /// whose first corners are these lanes.
    HWY_INLINE std::array<Lanes, shared> sums(const std::array<Shares, shared>& shares) {
        const Tag d;
        const std::uint32_t place = ahead_.row() & mask_, place_before = (ahead_.row() - columns_) & mask_;
        std::array<Lanes, shared> sums, far;
        for (std::uint32_t k = 0; k < shared; ++k) {
            const Lanes near = hn::Add(shares[k].first, near_right_[k](shares[k].near_right));
            sums[k] = hn::Add(hn::LoadU(d, far_ + k * next_ + place_before), near);
            far[k] = hn::Add(shares[k].far_left, far_right_[k](shares[k].far_right));
            hn::StoreU(far[k], d, far_ + k * next_ + place);
        }
        if (HWY_UNLIKELY(place < group_lanes))  // for loads across the ring's end
            for (std::uint32_t k = 0; k < shared; ++k)
                hn::StoreU(far[k], d, far_ + k * next_ + mask_ + 1 + place);
        return sums;
    }

    HWY_INLINE void go_on() { ahead_.go_on(); }

  private:
    std::uint32_t columns_;
    RowsAhead<vectors> ahead_;
    float* far_;  // a ring for each value
    std::uint32_t mask_;
    std::size_t next_;
    std::array<LaneBefore, shared> near_right_, far_right_;
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
