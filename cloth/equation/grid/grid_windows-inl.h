// Loops over a grid's rows with a window. Included as cloth/equation/sparse/stencil-inl.h.

#if defined(WEFT_CLOTH_EQUATION_GRID_GRID_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_EQUATION_GRID_GRID_WINDOWS_INL_H
#undef WEFT_CLOTH_EQUATION_GRID_GRID_WINDOWS_INL_H
#else
#define WEFT_CLOTH_EQUATION_GRID_GRID_WINDOWS_INL_H
#endif

#include <algorithm>
#include <array>

#include "cloth/equation/grid/grid_windows.h"
#include "cloth/equation/sparse/stencil-inl.h"
#include "engine/platform.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// A ring of rows of some vectors, turned into lanes. A row is read when the loop comes within reach of it,
/// and kept until the loop has passed it.
template <std::uint32_t vectors>
class RowsAhead {
    static_assert(vectors <= GridWindows::vectors);

  public:
    /// For a loop that begins at row `begin`. If it `goes_on`, the ring holds the rows that the loop before
    /// left there; otherwise the loop begins a reach earlier, with its halo.
    HWY_INLINE RowsAhead(float* ring, const Diagonals& diagonals, std::uint32_t begin, bool goes_on)
        : to_read_(diagonals.reach() + GridWindows::early),
          size_(GridWindows::ring_ahead(diagonals.reach())),
          all_(diagonals.groups() * group_lanes),
          row_(goes_on ? begin : begin - std::min(begin, diagonals.reach())),
          end_(goes_on ? begin + to_read_ : row_),
          place_(row_ % size_),
          ring_(ring),
          next_(size_ + group_lanes) {}

    [[nodiscard]] HWY_INLINE std::uint32_t row() const { return row_; }
    /// End of the ring's memory.
    [[nodiscard]] HWY_INLINE float* behind() const { return ring_ + 3 * vectors * next_; }

    /// row(j) gives the vectors in the lanes from row j on.
    template <class Row>
    HWY_INLINE void read(const Row& row) {
        for (const std::uint32_t end = row_ + part_lanes + to_read_; end_ < end; end_ += part_lanes) {
            const std::uint32_t at = place_after(end_ - row_);
            const auto rows = end_ < all_ ? row(end_) : std::array<Lanes3, vectors>{};
            for (std::uint32_t k = 0; k < vectors; ++k) {
                store(rows[k], k, at);
                if (at < group_lanes) store(rows[k], k, size_ + at);  // for loads across the ring's end
            }
        }
    }
    /// The lanes that begin `rows` rows ahead, at most a reach, plus `one_more`.
    HWY_INLINE Lanes3 after(std::uint32_t rows, std::uint32_t vector, std::uint32_t one_more = 0) const {
        const Tag d;
        const float* x = ring_ + 3 * vector * next_ + place_after(rows) + one_more;
        return {hn::LoadU(d, x), hn::LoadU(d, x + next_), hn::LoadU(d, x + 2 * next_)};
    }

    HWY_INLINE void go_on() {
        row_ += part_lanes;
        place_ = place_after(part_lanes);
    }

  private:
    HWY_INLINE std::uint32_t place_after(std::uint32_t rows) const {
        const std::uint32_t place = place_ + rows;
        return place < size_ ? place : place - size_;
    }
    HWY_INLINE void store(const Lanes3& values, std::uint32_t vector, std::uint32_t at) const {
        const Tag d;
        float* x = ring_ + 3 * vector * next_ + at;
        hn::StoreU(values.x, d, x);
        hn::StoreU(values.y, d, x + next_);
        hn::StoreU(values.z, d, x + 2 * next_);
    }

    std::uint32_t to_read_, size_, all_, row_, end_, place_;
    float* ring_;
    std::size_t next_;  // stride from value to value
};

/// The floats that an earlier neighbour gave.
struct Given {
    const float* values;
    std::size_t next;  ///< stride from value to value

    HWY_INLINE Lanes operator[](std::uint32_t k) const { return hn::LoadU(Tag(), values + k * next); }
    HWY_INLINE Lanes3 xyz(std::uint32_t k) const { return {(*this)[k], (*this)[k + 1], (*this)[k + 2]}; }
};

/// A loop over rows [first(), range.end); those before range.begin are its halo. The kernel does the
/// following at each part of a group, in this order: read_ahead; compute from the `own` rows and the `later`
/// neighbours'; take_from_far; give, for each diagonal; take_from_near; go_on.
///
/// Everything that has a GridLoop must be inlined into the kernel, so that its members stay in registers: in
/// memory they would be loaded again after each vector store, which the compiler takes to alias them.
template <std::uint32_t vectors, std::uint32_t exchanged>
class GridLoop {
  public:
    HWY_INLINE GridLoop(GridWindow& window, const Diagonals& diagonals, const BlockRange& range)
        : count_(diagonals.count), ahead_(window.values, diagonals, range.begin, window.at == range.begin) {
        window.at = range.end;
        float* const values = ahead_.behind();
        for (std::uint32_t d = 0; d < count_; ++d) {
            const std::uint32_t difference = diagonals.differences[d],
                                size = GridWindows::ring_of(difference);
            rings_[d] = {values + next_, difference, size - 1};
            next_ += size + group_lanes;
            near_ += GridWindows::is_near(difference);
        }
        if (first() == 0) std::fill(values, values + exchanged * next_, 0.0f);  // from rows before the grid
    }
    GridLoop(const GridLoop&) = delete;

    [[nodiscard]] HWY_INLINE std::uint32_t first() const { return ahead_.row(); }
    [[nodiscard]] HWY_INLINE std::uint32_t diagonals() const { return count_; }

    /// See RowsAhead.
    template <class Row>
    HWY_INLINE void read_ahead(const Row& row) {
        ahead_.read(row);
    }
    HWY_INLINE Lanes3 own(std::uint32_t vector) const { return ahead_.after(0, vector); }
    HWY_INLINE Lanes3 later(std::uint32_t vector, std::uint32_t d) const {
        return ahead_.after(rings_[d].difference, vector);
    }

    /// Calls take(d, given) for each neighbour that is a whole group of 16 or more before. It must be called
    /// before give(), which may overwrite the same places of the ring.
    template <class Take>
    HWY_INLINE void take_from_far(const Take& take) const {
        // Unrolled for each diagonal there may be, these loops took a tenth of a sweep's time.
        WEFT_NOT_UNROLLED
        for (std::uint32_t d = near_; d < count_; ++d) take(d, given(d));
    }
    template <class... Values>
    HWY_INLINE void give(std::uint32_t d, const Values&... values) const {
        static_assert(sizeof...(values) <= exchanged);
        const std::uint32_t place = ahead_.row() & rings_[d].mask;
        float* const first = rings_[d].values + place;
        float* to = first;
        ((hn::StoreU(values, Tag(), to), to += next_), ...);
        if (HWY_LIKELY(place >= group_lanes)) return;
        to = first + rings_[d].mask + 1;
        ((hn::StoreU(values, Tag(), to), to += next_), ...);
    }
    /// Calls take(d, given) for each nearer neighbour. It must be called after give(), since such a neighbour
    /// may be in the same group.
    template <class Take>
    HWY_INLINE void take_from_near(const Take& take) const {
        WEFT_NOT_UNROLLED
        for (std::uint32_t d = 0; d < near_; ++d) take(d, given(d));
    }

    HWY_INLINE void go_on() { ahead_.go_on(); }

  private:
    /// Ring buffer of the values given along one diagonal.
    struct Ring {
        float* values;
        std::uint32_t difference, mask;
    };

    HWY_INLINE Given given(std::uint32_t d) const {
        return {rings_[d].values + ((ahead_.row() - rings_[d].difference) & rings_[d].mask), next_};
    }

    std::uint32_t count_, near_ = 0;
    RowsAhead<vectors> ahead_;
    std::size_t next_ = 0;  // stride from value to value given
    std::array<Ring, Diagonals::most> rings_{};
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
