#include "cloth/system/pair_rows.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace weft {

namespace {

// A pair's spring over its mass, in units of gamma^-2. Softer ones let layers be pressed together where they
// land; stiffer ones make stacks buzz.
constexpr float spring_per_mass = 50;

}  // namespace

void PairRows::reserve(std::size_t particles, std::size_t pairs) {
    const std::size_t rows = std::min(particles, 4 * pairs);
    numbers_ = AlignedBuffer<std::uint32_t>(pairs);
    pairs_ = AlignedBuffer<FeaturePair>(pairs);
    groups_ = AlignedBuffer<PairGroup>((pairs + PairGroup::lanes - 1) / PairGroup::lanes);
    shares_ = AlignedBuffer<PairShare>(pairs);
    products_ = AlignedBuffer<Vec4>(pairs);
    taken_ = AlignedBuffer<Vec4>(particles);
    incidence_.reserve(particles, pairs);
    particles_ = AlignedBuffer<PushedParticle>(rows);
    counts_ = AlignedBuffer<std::uint32_t>(rows);
    pushed_ = AlignedBuffer<PushedCorner>(4 * pairs);
    block_counts_ = AlignedBuffer<std::uint32_t>(block_count(static_cast<std::uint32_t>(pairs)));
    marks_ = AlignedBuffer<std::uint64_t>((pairs + 63) / 64);
    partials_ = AlignedBuffer<double>(block_counts_.size());
}

void PairRows::begin(Parallel& parallel, const PairList& list, std::span<const PairLaw> laws,
                     std::span<const Vec4> base_positions, float gamma) {
    list_ = &list;
    base_positions_ = base_positions;
    gamma_ = gamma;
    choose(parallel, laws);
    incidence_.build(parallel, std::as_const(pairs_).span().first(size_), {});
    const PairSources sources{numbers_.data(), &list, laws.data(), base_positions.data()};
    parallel.ranges(size_, [&](const BlockRange& range) {
        fill_groups(sources, range, groups_.data());
        for (std::uint32_t k = range.begin; k < range.end; ++k)
            shares_[k].weights = list.shapes[numbers_[k]].weights;
    });
    // What is given no vector, as a body that is where it will be, has 0.
    for (std::uint32_t r = 0; r < incidence_.rows(); ++r) taken_[incidence_.particle(r)] = {};
    // Nothing pushes before it is linearised.
    std::fill_n(counts_.data(), incidence_.rows(), 0u);
}

// Those with a radius, in their order: blocks are counted, and each then knows where it writes.
void PairRows::choose(Parallel& parallel, std::span<const PairLaw> laws) {
    parallel.ranges(list_->size, [&](const BlockRange& range) {
        std::uint32_t count = 0;
        for (std::uint32_t k = range.begin; k < range.end; ++k) count += laws[k].radius > 0 ? 1 : 0;
        block_counts_[range.block] = count;
    });
    size_ = 0;
    for (std::uint32_t block = 0; block < block_count(list_->size); ++block)
        size_ += std::exchange(block_counts_[block], size_);
    parallel.ranges(list_->size, [&](const BlockRange& range) {
        std::uint32_t to = block_counts_[range.block];
        for (std::uint32_t k = range.begin; k < range.end; ++k) {
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

// Friction is the rows' own, as far as the normal impulse goes.
PairRows::Push PairRows::push_of(std::uint32_t k) const {
    const PairGroup& group = groups_[k / PairGroup::lanes];
    const std::uint32_t lane = k % PairGroup::lanes, number = numbers_[k];
    const FeaturePair& pair = list_->pairs[number];
    const PairShape& shape = list_->shapes[number];
    const Vector3 n = xyz(shape.normal);
    Vector3 u = Vector3::Zero(), point = Vector3::Zero();
    for (std::uint32_t c = 0; c < 4; ++c) {
        const std::uint32_t i = pair.corners[c];
        const Vector3 v = xyz(taken_[i]);
        u += shape.weight(c) * v;
        point += 0.5f * std::abs(shape.weight(c)) * (xyz(base_positions_[i]) + gamma_ * v);
    }
    const float along = products_[k].x, limit = group.friction[lane] * along;
    Vector3 rubbed = group.damper[lane] * (u - n.dot(u) * n);
    const float size = rubbed.norm();
    if (size > limit) rubbed *= limit / size;
    return {pair, shape, list_->corners_of_a(number), point, along * n - rubbed};
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

std::size_t PairRows::bytes() const noexcept {
    return numbers_.bytes() + pairs_.bytes() + groups_.bytes() + shares_.bytes() + products_.bytes() +
           taken_.bytes() + incidence_.bytes() + particles_.bytes() + counts_.bytes() + pushed_.bytes() +
           block_counts_.bytes() + marks_.bytes() + partials_.bytes() + untangling_.bytes();
}

}  // namespace weft
