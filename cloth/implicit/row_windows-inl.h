// What kernels read neighbours' rows by. Included as cloth/implicit/lanes-inl.h.

#if defined(WEFT_CLOTH_IMPLICIT_ROW_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_IMPLICIT_ROW_WINDOWS_INL_H
#undef WEFT_CLOTH_IMPLICIT_ROW_WINDOWS_INL_H
#else
#define WEFT_CLOTH_IMPLICIT_ROW_WINDOWS_INL_H
#endif

#include <algorithm>

#include "cloth/implicit/lanes-inl.h"
#include "cloth/implicit/row_windows.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// As they lie in memory.
struct RowsInMemory {
    const Stencil& stencil;
    const Vec4* rows;

    HWY_INLINE void come_to(std::uint32_t /*i*/) {}
    /// Of the lanes from row i on.
    HWY_INLINE Lanes3 own(std::uint32_t i) const { return xyz(load_rows(rows + i)); }
    /// Of a part of slot s, which begins at `lane`.
    HWY_INLINE Lanes3 neighbours(std::uint32_t s, std::uint32_t lane) const {
        return neighbour_rows(stencil, s, lane, rows);
    }
};

/// A window in use, by a loop over some rows.
class OpenWindow {
  public:
    HWY_INLINE OpenWindow(RowWindow& window, const Stencil& stencil, const BlockRange& range)
        : window_(window),
          stencil_(stencil),
          x_(window.values),
          y_(x_ + window.rows + group_lanes),
          z_(y_ + window.rows + group_lanes),
          ring_(window.rows),
          ahead_(part_lanes + window.reach),
          all_(stencil.groups() * group_lanes),
          origin_(window.origin),
          end_(window.end),
          range_end_(range.end) {
        if (window.at != range.begin) origin_ = end_ = range.begin - std::min(range.begin, window.reach);
    }
    OpenWindow(const OpenWindow&) = delete;
    ~OpenWindow() {
        window_.origin = origin_;
        window_.end = end_;
        window_.at = range_end_;
    }

    /// Makes neighbours of the lanes from row i on readable: row(j) gives the lanes from row j on.
    template <class Row>
    HWY_INLINE void come_to(std::uint32_t i, const Row& row) {
        for (const std::uint32_t end = std::min(all_, i + ahead_); end_ < end; end_ += part_lanes) {
            if (end_ - origin_ == ring_) origin_ = end_;
            const std::uint32_t at = end_ - origin_;
            const Lanes3 values = row(end_);
            store(values, at);
            if (at < group_lanes) store(values, ring_ + at);  // for loads across the ring's end
        }
    }
    HWY_INLINE Lanes3 own(std::uint32_t i) const { return load(i); }
    HWY_INLINE Lanes3 neighbours(std::uint32_t s, std::uint32_t lane) const {
        const std::uint32_t first = stencil_.runs[s];
        return HWY_LIKELY(first != Stencil::no_run)
                   ? load(first + lane)
                   : one_by_one(&stencil_.neighbours[s * Stencil::lanes + lane]);
    }

  private:
    HWY_INLINE std::uint32_t place_of(std::uint32_t row) const {
        return row - origin_ + (row < origin_ ? ring_ : 0);
    }
    HWY_INLINE Lanes3 load(std::uint32_t row) const {
        const Tag d;
        const std::uint32_t at = place_of(row);
        return {hn::LoadU(d, x_ + at), hn::LoadU(d, y_ + at), hn::LoadU(d, z_ + at)};
    }
    HWY_INLINE void store(const Lanes3& values, std::uint32_t at) const {
        const Tag d;
        hn::StoreU(values.x, d, x_ + at);
        hn::StoreU(values.y, d, y_ + at);
        hn::StoreU(values.z, d, z_ + at);
    }
    HWY_NOINLINE Lanes3 one_by_one(const std::uint32_t* rows) const {
        alignas(64) float x[part_lanes], y[part_lanes], z[part_lanes];
        for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
            const std::uint32_t at = place_of(rows[lane]);
            x[lane] = x_[at];
            y[lane] = y_[at];
            z[lane] = z_[at];
        }
        return {load_lanes(x), load_lanes(y), load_lanes(z)};
    }

    RowWindow& window_;
    const Stencil& stencil_;
    float *x_, *y_, *z_;
    std::uint32_t ring_, ahead_, all_, origin_, end_, range_end_;
};

/// Rows in a window on their vector.
class RowsInWindow : public OpenWindow {
  public:
    HWY_INLINE RowsInWindow(RowWindow& window, const Stencil& stencil, const BlockRange& range,
                            const Vec4* rows)
        : OpenWindow(window, stencil, range), rows_(rows) {}
    HWY_INLINE void come_to(std::uint32_t i) {
        OpenWindow::come_to(i, [this](std::uint32_t j) HWY_ATTR { return xyz(load_rows(rows_ + j)); });
    }

  private:
    const Vec4* rows_;
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
