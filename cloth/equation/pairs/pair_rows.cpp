#include "cloth/equation/pairs/pair_rows.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace weft {

namespace {

// A pair's spring over its mass, in units of gamma^-2. Softer springs let landing layers be pressed together;
// stiffer ones make stacks vibrate.
constexpr float spring_per_mass = 50;

}  // namespace

void PairRows::lay_out_rows(Scratch& scratch, const Room& room) {
    scratch.take(numbers_, room.rows);
    scratch.take(groups_, (room.rows + PairGroup::lanes - 1) / PairGroup::lanes);
    scratch.take(products_, room.rows);
    scratch.take(taken_, room.particles);
}

void PairRows::lay_out_solve(Scratch& scratch, const Room& room) {
    const std::size_t touched = std::min(room.particles, 4 * room.rows);
    incidence_.lay_out_rows(scratch, room.particles, room.rows);
    scratch.take_by_turns(
        [&] {
            scratch.take(pairs_, room.rows);
            incidence_.lay_out_build(scratch, room.rows);
        },
        [&] {
            scratch.take(shares_, room.rows);
            scratch.take(pushed_, 4 * room.rows);
        });
    scratch.take(particles_, touched);
    scratch.take(counts_, touched);
    scratch.take(block_counts_, block_count(static_cast<std::uint32_t>(room.pairs)));
    scratch.take(marks_, (room.rows + 63) / 64);
    scratch.take(partials_, block_counts_.size());
}

void PairRows::begin(Parallel& parallel, const PairList& list, std::span<const PairLaw> laws,
                     std::span<const Vec4> base_positions, float gamma) {
    list_ = &list;
    base_positions_ = base_positions;
    gamma_ = gamma;
    choose(parallel, laws);
    vertex_triangles_ = static_cast<std::uint32_t>(
        std::ranges::lower_bound(numbers_.span().first(size_), list.vertex_triangle) -
        numbers_.span().begin());
    incidence_.build(parallel, std::as_const(pairs_).span().first(size_), {});
    const PairSources sources{numbers_.data(), &list, laws.data(), base_positions.data()};
    parallel.ranges(size_, [&](const BlockRange& range) {
        fill_groups(sources, range, groups_.data());
        for (std::uint32_t k = range.begin; k < range.end; ++k)
            shares_[k].weights = list.shapes[numbers_[k]].weights;
    });
    // Particles whose vector is never taken have velocity 0: their body is already where it will be.
    for (std::uint32_t r = 0; r < incidence_.rows(); ++r) taken_[incidence_.particle(r)] = {};
    // No pair pushes before linearise().
    std::fill_n(counts_.data(), incidence_.rows(), 0u);
}

// Lists the pairs with a radius, in order, as far as there is room. Blocks are counted first, so that each
// knows where it writes.
void PairRows::choose(Parallel& parallel, std::span<const PairLaw> laws) {
    parallel.ranges(list_->size, [&](const BlockRange& range) {
        std::uint32_t count = 0;
        for (std::uint32_t k = range.begin; k < range.end; ++k) count += laws[k].radius > 0 ? 1 : 0;
        block_counts_[range.block] = count;
    });
    size_ = 0;
    for (std::uint32_t block = 0; block < block_count(list_->size); ++block)
        size_ += std::exchange(block_counts_[block], size_);
    const auto room = static_cast<std::uint32_t>(numbers_.size());
    size_ = std::min(size_, room);
    parallel.ranges(list_->size, [&](const BlockRange& range) {
        std::uint32_t to = block_counts_[range.block];
        for (std::uint32_t k = range.begin; k < range.end && to < room; ++k) {
            if (!(laws[k].radius > 0)) continue;
            numbers_[to] = k;
            pairs_[to++] = list_->pairs[k];
        }
    });
}

std::uint32_t PairRows::first_row(std::uint32_t particle) const {
    const std::span<const std::uint32_t> particles = incidence_.particles();
    return static_cast<std::uint32_t>(std::ranges::lower_bound(particles, particle) - particles.begin());
}

PairRows::RowRange PairRows::rows_of(std::uint32_t first, std::size_t count) const {
    return {first_row(first), first_row(first + static_cast<std::uint32_t>(count))};
}

void PairRows::take(Parallel& parallel, std::uint32_t first, std::span<const Vec4> vector) {
    const RowRange rows = rows_of(first, vector.size());
    parallel.ranges(rows.end - rows.begin, [&](const BlockRange& range) {
        for (std::uint32_t r = rows.begin + range.begin; r < rows.begin + range.end; ++r) {
            const std::uint32_t i = incidence_.particle(r);
            taken_[i] = vector[i - first];
        }
    });
    untangling_.take(first, vector);
}

void PairRows::linearise(Parallel& parallel) {
    untangling_.linearise();
    const PairStiffness stiffness{gamma_, spring_per_mass};
    parallel.ranges(size_, [&](const BlockRange& range) {
        linearise_groups(stiffness, taken_.data(), range, groups_.data(), shares_.data());
    });
    parallel.ranges(incidence_.rows(), [&](const BlockRange& range) {
        for (std::uint32_t r = range.begin; r < range.end; ++r) {
            const bool is_free = base_positions_[incidence_.particle(r)].w > 0;
            counts_[r] = is_free ? gather_shares(incidence_.places(r), shares_.data(), particles_[r],
                                                 pushed_.data() + incidence_.start(r))
                                 : 0;
        }
    });
}

void PairRows::begin_sweeps() {
    for (std::uint32_t k = 0; k < size_; ++k) products_[k] = {};
}

PairRows::Row PairRows::row(std::uint32_t k) const {
    const PairGroup& group = groups_[k / PairGroup::lanes];
    const std::uint32_t lane = k % PairGroup::lanes;
    Row row;
    for (std::uint32_t c = 0; c < 4; ++c) {
        row.corners[c] = group.corners[c][lane];
        row.weights[c] = group.weights[c][lane];
    }
    row.normal = {group.normal[0][lane], group.normal[1][lane], group.normal[2][lane]};
    return row;
}

// Friction is the rows' own, limited by Coulomb's law for this normal impulse.
PairRows::Push PairRows::push_of(std::uint32_t k) const {
    const PairGroup& group = groups_[k / PairGroup::lanes];
    const std::uint32_t lane = k % PairGroup::lanes;
    const Row pair = row(k);
    Vector3 u = Vector3::Zero(), point = Vector3::Zero();
    for (std::uint32_t c = 0; c < 4; ++c) {
        const std::uint32_t i = pair.corners[c];
        const Vector3 v = xyz(taken_[i]);
        u += pair.weights[c] * v;
        point += 0.5f * std::abs(pair.weights[c]) * (xyz(base_positions_[i]) + gamma_ * v);
    }
    const Vector3& n = pair.normal;
    const float along = products_[k].x, limit = group.friction[lane] * along;
    Vector3 rubbed = group.damper[lane] * (u - n.dot(u) * n);
    const float size = rubbed.norm();
    if (size > limit) rubbed *= limit / size;
    return {pair, k < vertex_triangles_ ? 1u : 2u, point, along * n - rubbed};
}

double PairRows::multiply(Parallel& parallel) {
    return parallel.reduce(
        size_, partials_.span(), untangling_.multiply(),
        [&](const BlockRange& range) {
            return multiply_groups(taken_.data(), range, groups_.data(), products_.data());
        },
        std::plus<>{});
}

void PairRows::add_products(Parallel& parallel, std::uint32_t first, std::span<Vec4> product) const {
    const RowRange rows = rows_of(first, product.size());
    parallel.ranges(rows.end - rows.begin, [&](const BlockRange& range) {
        add_pushed({.begin = rows.begin + range.begin,
                    .end = rows.begin + range.end,
                    .first = first,
                    .particles = incidence_.particles().data(),
                    .starts = incidence_.starts().data(),
                    .counts = counts_.data(),
                    .corners = pushed_.data()},
                   products_.data(), product.data());
    });
    untangling_.add_products(first, product);
}

}  // namespace weft
