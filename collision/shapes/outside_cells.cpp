#include "collision/shapes/outside_cells.h"

#include <algorithm>
#include <cmath>

namespace weft {

namespace {

/// Bits of `free` that runs of free bits connect to bits of `from`, which are free.
std::uint64_t filled(std::uint64_t from, std::uint64_t free) {
    std::uint64_t down = from, down_free = free;
    for (int step = 1; step < 64; step *= 2) {
        down |= down_free & down >> step;
        down_free &= down_free >> step;
    }
    const std::uint64_t up = free & ((free + down) ^ free);  // a sum's carry runs through free bits
    return up | down;
}

/// The bits of a row's word for cells before `end`.
std::uint64_t below(std::uint32_t end, std::uint32_t word) {
    const std::uint32_t first = 64 * word;
    if (end <= first) return 0;
    return end - first < 64 ? (std::uint64_t{1} << (end - first)) - 1 : ~std::uint64_t{0};
}

}  // namespace

void OutsideCells::reserve() {
    touched_.reserve(std::size_t{most} * most);
    outside_.reserve(std::size_t{most} * most);
}

std::uint32_t OutsideCells::cell_at(int axis, float place) const {
    const float at = (place - origin_[axis]) * per_cell_;
    const auto last = static_cast<float>(counts_[static_cast<std::size_t>(axis)] - 1);
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::min(std::max(at, 0.0f), last)));
}

/// The border is one cell wide and no triangle touches it: sweeps spread the outside from there, forwards and
/// back, until none finds more.
void OutsideCells::find(const TriangleTree& tree) {
    const Eigen::AlignedBox3f box = tree.box();
    const float cell = std::max(box.sizes().maxCoeff() / static_cast<float>(most - 3), 1e-9f);
    per_cell_ = 1 / cell;
    origin_ = box.min() - Vector3::Constant(1.5f * cell);
    for (int axis = 0; axis < 3; ++axis)
        counts_[static_cast<std::size_t>(axis)] =
            std::min(static_cast<std::uint32_t>(box.sizes()[axis] * per_cell_) + 4, most);
    touched_.assign(std::size_t{counts_[1]} * counts_[2], Row{});
    outside_.assign(touched_.size(), Row{});
    for (const TriangleLeaf& leaf : tree.leaves()) touch(leaf);
    outside_.front().fill(~std::uint64_t{0});
    const auto rows = static_cast<std::uint32_t>(touched_.size());
    for (bool found = true; found;) {
        found = false;
        for (std::uint32_t row = 0; row < rows; ++row) found |= spread(row % counts_[1], row / counts_[1]);
        for (std::uint32_t row = rows; row-- > 0;) found |= spread(row % counts_[1], row / counts_[1]);
    }
}

void OutsideCells::touch(const TriangleLeaf& leaf) {
    constexpr std::uint32_t size = TriangleLeaf::size;
    std::array<std::array<std::uint32_t, size>, 3> first, last;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float margin = 1e-3f / per_cell_;  // so that rounding leaves out no cell
        const TriangleLeaf::Row &a = leaf.corners[0][axis], &b = leaf.corners[1][axis],
                                &c = leaf.corners[2][axis];
        for (std::uint32_t k = 0; k < size; ++k) {
            first[axis][k] = cell_at(static_cast<int>(axis), std::min(a[k], std::min(b[k], c[k])) - margin);
            last[axis][k] = cell_at(static_cast<int>(axis), std::max(a[k], std::max(b[k], c[k])) + margin);
        }
    }
    for (std::uint32_t k = 0; k < size && std::isfinite(leaf.corners[0][0][k]); ++k) {
        Row along;
        for (std::uint32_t w = 0; w < words; ++w)
            along[w] = below(last[0][k] + 1, w) & ~below(first[0][k], w);
        for (std::uint32_t z = first[2][k]; z <= last[2][k]; ++z)
            for (std::uint32_t y = first[1][k]; y <= last[1][k]; ++y)
                for (std::uint32_t w = 0; w < words; ++w)
                    touched_[y + std::size_t{counts_[1]} * z][w] |= along[w];
    }
}

/// Spreads the outside to a row from the four rows beside it, and along it. Returns whether it has grown.
bool OutsideCells::spread(std::uint32_t y, std::uint32_t z) {
    const std::size_t row = y + std::size_t{counts_[1]} * z;
    Row& own = outside_[row];
    Row from = own;
    const auto add = [&](std::size_t other) {
        for (std::uint32_t w = 0; w < words; ++w) from[w] |= outside_[other][w] & ~touched_[row][w];
    };
    if (y > 0) add(row - 1);
    if (y + 1 < counts_[1]) add(row + 1);
    if (z > 0) add(row - counts_[1]);
    if (z + 1 < counts_[2]) add(row + counts_[1]);
    if (from == own) return false;
    for (std::uint32_t k = 0; k < 2 * words; ++k) {  // up the words, and down again
        const std::uint32_t w = k < words ? k : 2 * words - 1 - k;
        const std::uint64_t free = ~touched_[row][w], before = from[w];
        if (w > 0) from[w] |= free & from[w - 1] >> 63;
        if (w + 1 < words) from[w] |= free & from[w + 1] << 63;
        if (k < words || from[w] != before) from[w] = filled(from[w], free);
    }
    own = from;
    return true;
}

bool OutsideCells::is_outside(const Vector3& q) const {
    const std::uint32_t x = cell_at(0, q.x()), y = cell_at(1, q.y()), z = cell_at(2, q.z());
    return (outside_[y + std::size_t{counts_[1]} * z][x / 64] >> x % 64 & 1) != 0;
}

bool OutsideCells::come_near(const Vector3& q, float distance) const {
    if (is_outside(q)) return true;
    for (int k = 0; k < 27; ++k) {
        const Vector3 direction(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 % 3 - 1),
                                static_cast<float>(k / 9 - 1));
        if (is_outside(q + 0.99f * distance * direction.stableNormalized())) return true;
    }
    return false;
}

}  // namespace weft
