#include "cloth/solver/levels/coarse/coarse_pairs.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>

namespace weft {

namespace {

/// The number of fine rows whose weights a coarse row averages. Further rows only add their K.
constexpr std::uint32_t looked_at = 4;
/// Rows of less reach are left out: the level's motions hardly change their gap.
constexpr float least_reach = 0.1f;

constexpr std::uint32_t no_slot = ~0u;
/// Few, because a node has many rows.
constexpr std::uint32_t nodes_per_block = 16;

}  // namespace

/// Collects P^T c, summed over some fine rows, by coarse nodes.
class CoarsePairs::Sum {
  public:
    void add(const FreeRows::Row& row, float c) {
        for (std::uint32_t k = 0; k < Interpolation::width; ++k)
            if (row.weights[k] != 0) add(row.nodes[k], c * row.weights[k]);
    }
    void add(std::uint32_t node, float c) {
        for (std::uint32_t k = 0; k < count_; ++k) {
            if (nodes_[k] != node) continue;
            weights_[k] += c;
            return;
        }
        if (count_ == most_nodes) return;
        nodes_[count_] = node;
        weights_[count_++] = c;
    }
    /// The nodes of the largest weight of either sign, the lower number first; `no_slot` without weights.
    [[nodiscard]] Key key() const {
        std::uint32_t most = no_slot, least = no_slot;
        for (std::uint32_t k = 0; k < count_; ++k) {
            if (weights_[k] > 0 && (most == no_slot || weights_[k] > weights_[most])) most = k;
            if (weights_[k] < 0 && (least == no_slot || weights_[k] < weights_[least])) least = k;
        }
        if (most == no_slot && least == no_slot) return {no_slot, no_slot, 1};
        const std::uint32_t a = nodes_[most != no_slot ? most : least],
                            b = nodes_[least != no_slot ? least : most];
        return {std::min(a, b), std::max(a, b), a <= b ? 1.0f : -1.0f};
    }
    [[nodiscard]] Row row(float scale, const Symmetric3& stiffness) const {
        Row result{.count = count_, .nodes = {}, .weights = {}, .reach = 0, .stiffness = stiffness};
        for (std::uint32_t k = 0; k < count_; ++k) {
            result.nodes[k] = nodes_[k];
            result.weights[k] = scale * weights_[k];
            result.reach += std::abs(result.weights[k]);
        }
        return result;
    }

  private:
    std::uint32_t count_ = 0;
    std::uint32_t nodes_[most_nodes];
    float weights_[most_nodes];
};

/// Sum::key() of P's row `most` less row `least`. The rows mostly share no node: the key is then the node of
/// the largest weight in each, and no sum is made.
CoarsePairs::Key CoarsePairs::key_between(const FreeRows& p, std::uint32_t most, std::uint32_t least) {
    constexpr std::uint32_t width = Interpolation::width;
    const auto [nodes_a, weights_a] = p[most];
    const auto [nodes_b, weights_b] = p[least];
    std::uint32_t a = 0, b = 0;
    bool is_simple = true;
    for (std::uint32_t k = 0; k < width; ++k) {
        if (weights_a[k] > weights_a[a]) a = k;
        if (weights_b[k] > weights_b[b]) b = k;
        is_simple &= weights_a[k] >= 0 && weights_b[k] >= 0;
        for (std::uint32_t l = 0; l < width; ++l) is_simple &= nodes_a[k] != nodes_b[l];
        for (std::uint32_t l = 0; l < k; ++l)
            is_simple &= (nodes_a[k] != nodes_a[l] || weights_a[k] == 0) &&
                         (nodes_b[k] != nodes_b[l] || weights_b[k] == 0);
    }
    if (is_simple && weights_a[a] > 0 && weights_b[b] > 0)
        return {std::min(nodes_a[a], nodes_b[b]), std::max(nodes_a[a], nodes_b[b]),
                nodes_a[a] <= nodes_b[b] ? 1.0f : -1.0f};
    Sum sum;
    sum.add(p[most], 1);
    sum.add(p[least], -1);
    return sum.key();
}

void CoarsePairs::lay_out(Scratch& scratch, std::size_t fine_rows, std::uint32_t nodes) {
    clear();
    const bool any = fine_rows > 0;
    scratch.take_few(keys_, fine_rows);
    scratch.take_few(by_high_, fine_rows);
    scratch.take_few(order_, fine_rows);
    scratch.take_few(active_, fine_rows);
    scratch.take_few(rows_, std::min(fine_rows, rows_per_node * nodes + least_rows));
    scratch.take_few(starts_, any ? std::size_t{nodes} + 1 : 0);
    scratch.take_few(merged_, any ? std::size_t{nodes} + 1 : 0);
}

// Puts rows between the same two nodes next to one another, by two counting sorts: by the higher node, then
// by the lower, which keeps the order of rows with the same.
void CoarsePairs::sort_by_nodes(Parallel& parallel, std::uint32_t fine_rows) {
    const std::span<std::uint32_t> starts = starts_.span(), merged = merged_.span();
    const std::span<const Key> keys = keys_.span().first(fine_rows);
    std::ranges::fill(starts, 0u);
    std::ranges::fill(merged, 0u);
    for (const Key& key : keys) {
        if (key.low == no_slot) continue;
        ++starts[key.low + 1];
        ++merged[key.high + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::partial_sum(merged.begin(), merged.end(), merged.begin());
    for (std::uint32_t k = 0; k < fine_rows; ++k)
        if (keys[k].low != no_slot) by_high_[merged[keys[k].high]++] = k;
    std::ranges::copy(starts, merged.begin());
    for (const std::uint32_t k : by_high_.span().first(starts.back())) order_[merged[keys[k].low]++] = k;
    const auto nodes = static_cast<std::uint32_t>(starts_.size() - 1);
    parallel.ranges(
        nodes,
        [&](const BlockRange& range) {
            for (std::uint32_t low = range.begin; low < range.end; ++low) {
                std::uint32_t different = starts_[low] < starts_[low + 1] ? 1 : 0;
                for (std::uint32_t k = starts_[low] + 1; k < starts_[low + 1]; ++k)
                    different += keys_[order_[k]].high != keys_[order_[k - 1]].high;
                merged_[low] = different;
            }
        },
        nodes_per_block);
    merged[nodes] = 0;
    std::exclusive_scan(merged.begin(), merged.end(), merged.begin(), 0u);
}

// add_row(k, sum) adds P^T c of fine row k to the sum, unless that is null, and returns its K.
template <class AddRow>
void CoarsePairs::merge(Parallel& parallel, std::uint32_t fine_rows, const AddRow& add_row) {
    sort_by_nodes(parallel, fine_rows);
    const auto room = static_cast<std::uint32_t>(rows_.size());
    parallel.ranges(
        static_cast<std::uint32_t>(starts_.size() - 1),
        [&](const BlockRange& range) {
            for (std::uint32_t low = range.begin; low < range.end; ++low) {
                std::uint32_t next = merged_[low];
                for (std::uint32_t k = starts_[low], end = starts_[low + 1]; k < end && next < room;) {
                    const std::uint32_t high = keys_[order_[k]].high;
                    Sum sum;
                    Symmetric3 stiffness;
                    std::uint32_t looked = 0;
                    for (; k < end && keys_[order_[k]].high == high; ++k) {
                        const bool look = looked < looked_at;
                        stiffness.add(add_row(order_[k], look ? &sum : nullptr));
                        looked += look ? 1 : 0;
                    }
                    rows_[next++] = sum.row(1 / static_cast<float>(looked), stiffness);
                }
            }
        },
        nodes_per_block);
    const std::span<Row> merged = rows_.span().first(std::min(room, merged_[merged_.size() - 1]));
    const auto left_out =
        std::ranges::remove_if(merged, [](const Row& row) { return !(row.reach > least_reach); });
    size_ = static_cast<std::uint32_t>(merged.size() - left_out.size());
}

// A group may have more pairs than a cloth has room for. The others act on the finest level only.
void CoarsePairs::list(PairRows& pairs, const Numbering& number) {
    pairs_ = &pairs;
    const auto add = [&](std::uint32_t row) {
        if (listed_ < active_.size()) active_[listed_++] = row;
    };
    if (const auto ranges = number.ranges(); ranges.size() == 1)
        pairs.for_each_active_row_of(ranges[0].in_equation, ranges[0].count, add);
    else
        pairs.for_each_active_row([&](std::uint32_t row) {
            if (number.has_any_corner(pairs.active_pair(row).pair)) add(row);
        });
}

CoarsePairs::Key CoarsePairs::key_of(const PairRows::ActivePair& active, const Numbering& number,
                                     const FreeRows& p) {
    std::uint32_t most = 0, least = 0;
    for (std::uint32_t c = 1; c < 4; ++c) {
        if (active.shape.weight(c) > active.shape.weight(most)) most = c;
        if (active.shape.weight(c) < active.shape.weight(least)) least = c;
    }
    return key_between(p, number(active.pair.corners[most]), number(active.pair.corners[least]));
}

void CoarsePairs::gather(Parallel& parallel, const Numbering& number, const FreeRows& p) {
    const std::uint32_t count = listed_;
    std::atomic<bool> any_outer = false;
    parallel.ranges(count, [&](const BlockRange& range) {
        for (std::uint32_t k = range.begin; k < range.end; ++k) {
            const PairRows::ActivePair active = pairs_->active_pair(active_[k]);
            const bool inner = number.has_all_corners(active.pair);
            keys_[k] = inner ? key_of(active, number, p) : Key{no_slot, no_slot, 1};
            if (!inner) any_outer.store(true, std::memory_order_relaxed);
        }
    });
    has_outer_ = any_outer;
    merge(parallel, count, [&](std::uint32_t k, Sum* sum) {
        const PairRows::ActivePair active = pairs_->active_pair(active_[k]);
        if (sum != nullptr)
            for (std::uint32_t c = 0; c < 4; ++c)
                sum->add(p[number(active.pair.corners[c])], keys_[k].sign * active.shape.weight(c));
        return active.stiffness();
    });
}

void CoarsePairs::gather(Parallel& parallel, const CoarsePairs& finer, const Interpolation& p) {
    const std::span<const Row> fine = finer.rows();
    const auto count = static_cast<std::uint32_t>(fine.size());
    const auto add_row = [&](const Row& row, float sign, Sum& sum) {
        for (std::uint32_t k = 0; k < row.count; ++k)
            sum.add(FreeRows{p}[row.nodes[k]], sign * row.weights[k]);
    };
    parallel.ranges(count, [&](const BlockRange& range) {
        for (std::uint32_t k = range.begin; k < range.end; ++k) {
            Sum sum;
            add_row(fine[k], 1, sum);
            keys_[k] = sum.key();
        }
    });
    merge(parallel, count, [&](std::uint32_t k, Sum* sum) {
        if (sum != nullptr) add_row(fine[k], keys_[k].sign, *sum);
        return fine[k].stiffness;
    });
}

void CoarsePairs::correct(std::span<const Vec4> b, std::span<const Vec4> x, std::span<Vec4> corrected) const {
    std::ranges::copy(b, corrected.begin());
    for (const Row& row : rows()) {
        Vector3 across = Vector3::Zero();
        for (std::uint32_t k = 0; k < row.count; ++k) across += row.weights[k] * xyz(x[row.nodes[k]]);
        for (std::uint32_t k = 0; k < row.count; ++k) {
            const Vector3 bound = row.reach * std::abs(row.weights[k]) * xyz(x[row.nodes[k]]);
            Vec4& target = corrected[row.nodes[k]];
            target = to_vec4(xyz(target) - row.stiffness * (row.weights[k] * across - bound), 0);
        }
    }
}

}  // namespace weft
