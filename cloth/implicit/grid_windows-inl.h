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
    std::uint32_t next;  ///< from value to value

    HWY_INLINE Lanes operator[](std::uint32_t k) const { return hn::LoadU(Tag(), values + k * next); }
    HWY_INLINE Lanes3 xyz(std::uint32_t k) const { return {(*this)[k], (*this)[k + 1], (*this)[k + 2]}; }
};

/// A loop over rows [first(), range.end), those before range.begin being its halo: at each part of a group it
/// comes to the part, reads `own` and `later` rows of some vectors, and `give`s each diagonal's later
/// neighbours what is theirs; `given` is what earlier neighbours gave; then it goes on.
template <std::uint32_t vectors, std::uint32_t exchanged>
class GridLoop {
    static_assert(vectors <= GridWindows::vectors);

  public:
    HWY_INLINE GridLoop(GridWindow& window, const Diagonals& diagonals, const BlockRange& range)
        : window_(window),
          count_(diagonals.count),
          to_read_(diagonals.reach() + GridWindows::early),
          size_(GridWindows::ring_ahead(diagonals.reach())),
          all_(diagonals.groups() * group_lanes),
          range_end_(range.end),
          first_(range.begin),
          end_(range.begin + to_read_),
          place_(window.ahead),
          ahead_(window.values) {
        const bool begins = window.at != range.begin;
        if (begins) {
            first_ = end_ = range.begin - std::min(range.begin, diagonals.reach());
            place_ = 0;
        }
        float* values = ahead_ + 3 * vectors * (size_ + group_lanes);
        for (std::uint32_t d = 0; d < count_; ++d) {
            const std::uint32_t difference = diagonals.differences[d],
                                size = GridWindows::ring_of(difference);
            rings_[d] = {values, begins ? 0 : window.exchanged[d], size, difference};
            values += exchanged * (size + group_lanes);
        }
        if (begins && first_ == 0) std::fill(rings_[0].values, values, 0.0f);  // by rows that are not there
    }
    GridLoop(const GridLoop&) = delete;
    ~GridLoop() {
        window_.at = range_end_;
        window_.ahead = place_;
        for (std::uint32_t d = 0; d < count_; ++d) window_.exchanged[d] = rings_[d].place;
    }

    [[nodiscard]] HWY_INLINE std::uint32_t first() const { return first_; }
    [[nodiscard]] HWY_INLINE std::uint32_t diagonals() const { return count_; }

    /// row(j) gives the vectors in the lanes from row j on.
    template <class Row>
    HWY_INLINE void come_to(std::uint32_t i, const Row& row) {
        for (const std::uint32_t end = i + part_lanes + to_read_; end_ < end; end_ += part_lanes) {
            std::uint32_t at = place_ + (end_ - i);
            if (at >= size_) at -= size_;
            const auto rows = end_ < all_ ? row(end_) : std::array<Lanes3, vectors>{};
            for (std::uint32_t k = 0; k < vectors; ++k) {
                store(rows[k], k, at);
                if (at < group_lanes) store(rows[k], k, size_ + at);  // for loads across the ring's end
            }
        }
    }
    HWY_INLINE Lanes3 own(std::uint32_t vector) const { return load(vector, place_); }
    HWY_INLINE Lanes3 later(std::uint32_t vector, std::uint32_t d) const {
        const std::uint32_t at = place_ + rings_[d].difference;
        return load(vector, at < size_ ? at : at - size_);
    }

    template <class... Values>
    HWY_INLINE void give(std::uint32_t d, const Values&... values) const {
        static_assert(sizeof...(values) == exchanged);
        const std::uint32_t place = rings_[d].place, size = rings_[d].size, next = size + group_lanes;
        float* const first = rings_[d].values + place;
        float* to = first;
        ((hn::StoreU(values, Tag(), to), to += next), ...);
        if (HWY_LIKELY(place >= group_lanes)) return;
        to = first + size;
        ((hn::StoreU(values, Tag(), to), to += next), ...);
    }
    HWY_INLINE Given given(std::uint32_t d) const { return given_before(d, 0); }
    /// To the part before. Where rows take long to finish, they are finished one part later: a neighbour next
    /// door gave it a moment ago, and what overlaps a store can be loaded only when all before it is done.
    HWY_INLINE Given given_last(std::uint32_t d) const { return given_before(d, part_lanes); }

    HWY_INLINE void go_on() {
        place_ = next(place_, size_);
        for (std::uint32_t d = 0; d < count_; ++d) rings_[d].place = next(rings_[d].place, rings_[d].size);
    }

  private:
    /// Of what is given along a diagonal.
    struct Ring {
        float* values;
        std::uint32_t place, size, difference;
    };

    HWY_INLINE Given given_before(std::uint32_t d, std::uint32_t rows) const {
        const std::uint32_t place = rings_[d].place, size = rings_[d].size;
        const std::uint32_t back = rings_[d].difference + rows;
        return {rings_[d].values + (place < back ? place + size : place) - back, size + group_lanes};
    }
    static HWY_INLINE std::uint32_t next(std::uint32_t place, std::uint32_t size) {
        return place + part_lanes == size ? 0 : place + part_lanes;
    }
    HWY_INLINE Lanes3 load(std::uint32_t vector, std::uint32_t at) const {
        const Tag d;
        const std::uint32_t next = size_ + group_lanes;
        const float* x = ahead_ + 3 * vector * next + at;
        return {hn::LoadU(d, x), hn::LoadU(d, x + next), hn::LoadU(d, x + 2 * next)};
    }
    HWY_INLINE void store(const Lanes3& values, std::uint32_t vector, std::uint32_t at) const {
        const Tag d;
        const std::uint32_t next = size_ + group_lanes;
        float* x = ahead_ + 3 * vector * next + at;
        hn::StoreU(values.x, d, x);
        hn::StoreU(values.y, d, x + next);
        hn::StoreU(values.z, d, x + 2 * next);
    }

    GridWindow& window_;
    std::uint32_t count_, to_read_, size_, all_, range_end_, first_, end_, place_;
    float* ahead_;
    std::array<Ring, Diagonals::most> rings_{};
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
