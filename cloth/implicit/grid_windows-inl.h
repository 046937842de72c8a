// A grid's window in use. Included as cloth/implicit/lanes-inl.h.

#if defined(WEFT_CLOTH_IMPLICIT_GRID_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_IMPLICIT_GRID_WINDOWS_INL_H
#undef WEFT_CLOTH_IMPLICIT_GRID_WINDOWS_INL_H
#else
#define WEFT_CLOTH_IMPLICIT_GRID_WINDOWS_INL_H
#endif

#include <algorithm>
#include <array>

#include "cloth/implicit/grid_windows.h"
#include "cloth/implicit/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// What an earlier neighbour gave.
struct Given {
    const float* values;
    std::size_t next;  ///< from value to value

    HWY_INLINE Lanes operator[](std::uint32_t k) const { return hn::LoadU(Tag(), values + k * next); }
    HWY_INLINE Lanes3 xyz(std::uint32_t k) const { return {(*this)[k], (*this)[k + 1], (*this)[k + 2]}; }
};

/// A loop over rows [first(), range.end), those before range.begin being its halo: at each part of a group it
/// reads ahead, has `own` and `later` rows of some vectors, takes what far neighbours gave, `give`s each
/// diagonal's later neighbours what is theirs, and takes what near ones gave; then it goes on.
///
/// Whoever has one is inlined into the kernel, so that it lives in registers: a vector's store may be to any
/// object in memory, and members there would be read anew after each.
template <std::uint32_t vectors, std::uint32_t exchanged>
class GridLoop {
    static_assert(vectors <= GridWindows::vectors);

  public:
    HWY_INLINE GridLoop(GridWindow& window, const Diagonals& diagonals, const BlockRange& range)
        : count_(diagonals.count),
          to_read_(diagonals.reach() + GridWindows::early),
          size_(GridWindows::ring_ahead(diagonals.reach())),
          all_(diagonals.groups() * group_lanes),
          row_(range.begin),
          end_(range.begin + to_read_),
          ahead_(window.values),
          next_ahead_(size_ + group_lanes) {
        if (window.at != range.begin) row_ = end_ = range.begin - std::min(range.begin, diagonals.reach());
        window.at = range.end;
        place_ = row_ % size_;
        float* const values = ahead_ + 3 * vectors * next_ahead_;
        for (std::uint32_t d = 0; d < count_; ++d) {
            const std::uint32_t difference = diagonals.differences[d],
                                size = GridWindows::ring_of(difference);
            rings_[d] = {values + next_, difference, size - 1};
            next_ += size + group_lanes;
            near_ += GridWindows::is_near(difference);
        }
        if (row_ == 0) std::fill(values, values + exchanged * next_, 0.0f);  // by rows that are not there
    }
    GridLoop(const GridLoop&) = delete;

    [[nodiscard]] HWY_INLINE std::uint32_t first() const { return row_; }
    [[nodiscard]] HWY_INLINE std::uint32_t diagonals() const { return count_; }

    /// row(j) gives the vectors in the lanes from row j on.
    template <class Row>
    HWY_INLINE void read_ahead(const Row& row) {
        for (const std::uint32_t end = row_ + part_lanes + to_read_; end_ < end; end_ += part_lanes) {
            const std::uint32_t at = place_after(end_ - row_);
            const auto rows = end_ < all_ ? row(end_) : std::array<Lanes3, vectors>{};
            for (std::uint32_t k = 0; k < vectors; ++k) {
                store(rows[k], k, at);
                if (at < group_lanes) store(rows[k], k, size_ + at);  // for loads across the ring's end
            }
        }
    }
    HWY_INLINE Lanes3 own(std::uint32_t vector) const { return load(vector, place_); }
    HWY_INLINE Lanes3 later(std::uint32_t vector, std::uint32_t d) const {
        return load(vector, place_after(rings_[d].difference));
    }

    /// take(what it gave) for the neighbours that are a group or more away, before anything is given: that
    /// may come to lie where this does.
    template <class Take>
    HWY_INLINE void take_from_far(const Take& take) const {
// Peeled for each diagonal there may be, these loops took a tenth of a sweep's time.
#pragma GCC unroll 1
        for (std::uint32_t d = near_; d < count_; ++d) take(given(row_, d));
    }
    template <class... Values>
    HWY_INLINE void give(std::uint32_t d, const Values&... values) const {
        static_assert(sizeof...(values) == exchanged);
        const std::uint32_t place = row_ & rings_[d].mask;
        float* const first = rings_[d].values + place;
        float* to = first;
        ((hn::StoreU(values, Tag(), to), to += next_), ...);
        if (HWY_LIKELY(place >= group_lanes)) return;
        to = first + rings_[d].mask + 1;
        ((hn::StoreU(values, Tag(), to), to += next_), ...);
    }
    /// take(what it gave) for the neighbours that are nearer, all having been given.
    template <class Take>
    HWY_INLINE void take_from_near(const Take& take) const {
#pragma GCC unroll 1
        for (std::uint32_t d = 0; d < near_; ++d) take(given(row_, d));
    }
    /// To the part before. Where rows take long to finish, they are finished one part later: a neighbour next
    /// door gave it a moment ago, and what overlaps a store can be loaded only when all before it is done.
    template <class Take>
    HWY_INLINE void take_last_from_near(const Take& take) const {
#pragma GCC unroll 1
        for (std::uint32_t d = 0; d < near_; ++d) take(given(row_ - part_lanes, d));
    }

    HWY_INLINE void go_on() {
        row_ += part_lanes;
        place_ = place_after(part_lanes);
    }

  private:
    /// Of what is given along a diagonal.
    struct Ring {
        float* values;
        std::uint32_t difference, mask;
    };

    HWY_INLINE Given given(std::uint32_t row, std::uint32_t d) const {
        return {rings_[d].values + ((row - rings_[d].difference) & rings_[d].mask), next_};
    }
    /// Of those ahead.
    HWY_INLINE std::uint32_t place_after(std::uint32_t rows) const {
        const std::uint32_t place = place_ + rows;
        return place < size_ ? place : place - size_;
    }
    HWY_INLINE Lanes3 load(std::uint32_t vector, std::uint32_t at) const {
        const Tag d;
        const float* x = ahead_ + 3 * vector * next_ahead_ + at;
        return {hn::LoadU(d, x), hn::LoadU(d, x + next_ahead_), hn::LoadU(d, x + 2 * next_ahead_)};
    }
    HWY_INLINE void store(const Lanes3& values, std::uint32_t vector, std::uint32_t at) const {
        const Tag d;
        float* x = ahead_ + 3 * vector * next_ahead_ + at;
        hn::StoreU(values.x, d, x);
        hn::StoreU(values.y, d, x + next_ahead_);
        hn::StoreU(values.z, d, x + 2 * next_ahead_);
    }

    std::uint32_t count_, near_ = 0, to_read_, size_, all_, row_, end_, place_;
    float* ahead_;
    std::size_t next_ahead_, next_ = 0;  // from value to value, of those ahead and of what is given
    std::array<Ring, Diagonals::most> rings_{};
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
