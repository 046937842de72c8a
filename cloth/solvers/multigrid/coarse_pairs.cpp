#include "cloth/solvers/multigrid/coarse_pairs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace weft {

namespace {

/// How many fine rows say where a coarse one acts; of the others only K is added.
constexpr std::uint32_t looked_at = 4;
/// Rows that hardly reach from one node to another say nothing that the level can move by.
constexpr float least_reach = 0.1f;

constexpr std::uint32_t none = ~0u;

}  // namespace

/// Collects P^T c, summed over some fine rows, by coarse nodes.
class CoarsePairs::Sum {
  public:
    void add(const Interpolation& p, std::span<const float> of_p, std::uint32_t fine, float c) {
        for (std::uint32_t e = Interpolation::width * fine; e < Interpolation::width * (fine + 1); ++e)
            if (of_p[e] != 0) add(p.nodes[e], c * of_p[e]);
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
    /// The nodes that have most of either sign, the lower number first; `none` where there is none.
    [[nodiscard]] Key key() const {
        std::uint32_t most = none, least = none;
        for (std::uint32_t k = 0; k < count_; ++k) {
            if (weights_[k] > 0 && (most == none || weights_[k] > weights_[most])) most = k;
            if (weights_[k] < 0 && (least == none || weights_[k] < weights_[least])) least = k;
        }
        if (most == none && least == none) return {none, none, 1};
        const std::uint32_t a = nodes_[most != none ? most : least], b = nodes_[least != none ? least : most];
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

/// Sum::key of one fine particle's nodes less another's. Mostly the two share none, and each side has its own
/// strongest one; `none` then for neither is asked further.
CoarsePairs::Key CoarsePairs::key_between(const Interpolation& p, std::span<const float> of_p,
                                          std::uint32_t most, std::uint32_t least) {
    constexpr std::uint32_t width = Interpolation::width;
    const std::uint32_t* const nodes_a = &p.nodes[width * most];
    const std::uint32_t* const nodes_b = &p.nodes[width * least];
    const float* const weights_a = &of_p[width * most];
    const float* const weights_b = &of_p[width * least];
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
    sum.add(p, of_p, most, 1);
    sum.add(p, of_p, least, -1);
    return sum.key();
}

void CoarsePairs::reserve(std::size_t fine_rows, std::uint32_t nodes) {
    *this = {};
    if (fine_rows == 0) return;
    keys_.reserve(fine_rows);
    order_.resize(fine_rows);
    active_.reserve(fine_rows);
    rows_.resize(std::min(fine_rows, rows_per_node * nodes + least_rows));
    starts_.resize(std::size_t{nodes} + 1);
}

// Rows between the same two nodes come to follow one another: counted by the lower node, then sorted by the
// higher. add_row(k, sum) adds P^T c of fine row k to the sum, unless that is null, and returns its K.
template <class AddRow>
void CoarsePairs::merge(const AddRow& add_row) {
    std::ranges::fill(starts_, 0u);
    for (const Key& key : keys_)
        if (key.low != none) ++starts_[key.low];
    std::uint32_t count = 0;
    for (std::uint32_t& start : starts_) count += std::exchange(start, count);
    for (std::uint32_t k = 0; k < keys_.size(); ++k)
        if (keys_[k].low != none) order_[starts_[keys_[k].low]++] = {.high = keys_[k].high, .row = k};
    size_ = 0;
    for (std::uint32_t begin = 0; begin < count;) {
        const std::uint32_t low = keys_[order_[begin].row].low, end = starts_[low];
        std::sort(order_.begin() + begin, order_.begin() + end);
        while (begin < end) {
            const std::uint32_t high = order_[begin].high;
            Sum sum;
            Symmetric3 stiffness;
            std::uint32_t looked = 0;
            for (; begin < end && order_[begin].high == high; ++begin) {
                const bool look = looked < looked_at;
                stiffness.add(add_row(order_[begin].row, look ? &sum : nullptr));
                looked += look ? 1 : 0;
            }
            const Row row = sum.row(1 / static_cast<float>(looked), stiffness);
            if (row.reach > least_reach && size_ < rows_.size()) rows_[size_++] = row;
        }
    }
}

// A group has room for more than one of its cloths: what is over is left to the finest level.
void CoarsePairs::list(PairRows& pairs, std::uint32_t first, std::uint32_t particles) {
    active_.clear();
    pairs.for_each_active_of(first, particles, [&](const PairRows::ActivePair& active) {
        if (active_.size() < order_.size()) active_.push_back(active);
    });
}

void CoarsePairs::gather(std::uint32_t first, std::uint32_t particles, const Interpolation& p,
                         std::span<const float> weights) {
    keys_.clear();
    has_outer_ = false;
    for (const PairRows::ActivePair& active : active_) {
        const auto is_inner = [&](std::uint32_t i) { return i - first < particles; };
        if (!std::ranges::all_of(active.pair.corners, is_inner)) {
            has_outer_ = true;
            keys_.push_back({none, none, 1});
            continue;
        }
        std::uint32_t most = 0, least = 0;
        for (std::uint32_t c = 1; c < 4; ++c) {
            if (active.shape.weight(c) > active.shape.weight(most)) most = c;
            if (active.shape.weight(c) < active.shape.weight(least)) least = c;
        }
        keys_.push_back(
            key_between(p, weights, active.pair.corners[most] - first, active.pair.corners[least] - first));
    }
    merge([&](std::uint32_t k, Sum* sum) {
        const PairRows::ActivePair& active = active_[k];
        if (sum != nullptr)
            for (std::uint32_t c = 0; c < 4; ++c)
                sum->add(p, weights, active.pair.corners[c] - first, keys_[k].sign * active.shape.weight(c));
        return active.stiffness();
    });
}

void CoarsePairs::gather(const CoarsePairs& finer, const Interpolation& p) {
    keys_.clear();
    const auto add_row = [&](const Row& row, float sign, Sum& sum) {
        for (std::uint32_t k = 0; k < row.count; ++k)
            sum.add(p, p.weights.span(), row.nodes[k], sign * row.weights[k]);
    };
    for (const Row& row : finer.rows()) {
        Sum sum;
        add_row(row, 1, sum);
        keys_.push_back(sum.key());
    }
    merge([&](std::uint32_t k, Sum* sum) {
        const Row& row = finer.rows()[k];
        if (sum != nullptr) add_row(row, keys_[k].sign, *sum);
        return row.stiffness;
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

std::size_t CoarsePairs::bytes() const noexcept {
    return keys_.capacity() * sizeof(Key) + order_.size() * sizeof(Placed) +
           starts_.size() * sizeof(std::uint32_t) + active_.capacity() * sizeof(PairRows::ActivePair) +
           rows_.size() * sizeof(Row);
}

}  // namespace weft
