#include "cloth/solver/levels/multigrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cloth/equation/sparse/vectors.h"

namespace weft {

namespace {

constexpr float ratio = 9;  // of the nodes of a level to those of the next

/// The first two steps of a Chebyshev semi-iteration on [low, high] (Golub and Varga 1961).
struct Chebyshev2 {
    Relaxation first, second;
};
constexpr Chebyshev2 chebyshev2(float low, float high) {
    const float centre = 0.5f * (high + low), sigma = (high + low) / (high - low);
    const float rho = 1 / (2 * sigma - 1 / sigma);
    return {{1 / centre, 0}, {2 * rho / (0.5f * (high - low)), rho / sigma}};
}
// The spectrum of D^-1 W ends below 2 on the finest level. On coarse ones, where blocks may be
// indefinite, 3.4 was measured; the polynomial for [0.6, 3] damps up to 3.6.
constexpr float finest_step = 2 / (0.4f + 2.0f);
constexpr Chebyshev2 coarse_smoothing = chebyshev2(0.6f, 3.0f);
constexpr float first_coarse_step = 2 / (0.5f + 3.0f);

SpringGraph graph_of(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> positions) {
    const AlignedBuffer<Vec4> blocks = system.all_spring_blocks(parallel);
    SpringGraph graph;
    graph.offsets.push_back(0);
    for (std::uint32_t i = 0; i < system.stencil().nodes; ++i) {
        const ImplicitSystem::Neighbours row = system.neighbours_of(i);
        for (std::uint32_t k = 0; k < row.count; ++k) {
            const std::uint32_t j = row[k];
            if (j == i) continue;
            const std::uint32_t entry = system.entry_between(i, j);
            graph.neighbours.push_back(j);
            // Links of bending alone, and of bending that pushes apart, interpolate nothing.
            const float stiffness = 3 * blocks[entry].w + xyz(blocks[entry]).squaredNorm();
            graph.stiffness.push_back(std::max(stiffness, 0.0f));
            graph.lengths.push_back((xyz(positions[j]) - xyz(positions[i])).norm());
        }
        graph.offsets.push_back(static_cast<std::uint32_t>(graph.neighbours.size()));
    }
    return graph;
}

}  // namespace

Multigrid::Multigrid(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> positions)
    : system_(&system), pinned_(positions.size()) {
    SpringGraph graph = graph_of(parallel, system, positions);
    std::vector<Link> links = links_of(graph);
    std::vector<std::uint32_t> slots, numbers;
    std::vector<Link> constant_links;
    std::vector<float> weights;
    for (const Link& link : links) {
        const float weight = system.constant_block(link.first, link.second);
        numbers.push_back(weight != 0 ? static_cast<std::uint32_t>(constant_links.size()) : none);
        if (weight == 0) {
            slots.push_back(system.entry_between(link.first, link.second) / Stencil::lanes);
            continue;
        }
        constant_links.push_back(link);
        weights.push_back(weight);
    }
    std::ranges::sort(slots);
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    slots_ = SharedBuffer<std::uint32_t>(slots);
    constants_.links = SharedBuffer<Link>(constant_links);
    constants_.weights = SharedBuffer<float>(weights);
    make_levels(std::move(graph), std::move(links), numbers);
    set_pins(positions);
    lay_out_alone();
}

Multigrid::Multigrid(const ImplicitSystem& system, SavedLevels&& saved, std::uint32_t particles)
    : system_(&system),
      slots_(std::move(saved.slots)),
      constants_{std::move(saved.constant_links), std::move(saved.constant_weights)},
      pinned_(particles) {
    coarse_.reserve(saved.levels.size());
    for (CoarseLevel::Constants& level : saved.levels) {
        level.lists.constants.sums = AlignedBuffer<float>(level.lists.groups() * Stencil::lanes);
        coarse_.emplace_back(std::move(level));
    }
    if (coarse_.empty()) return;
    const SharedBuffer<float>& weights = coarse_.front().interpolation().weights;
    weights_ = AlignedBuffer<float>::from_bytes(std::as_bytes(weights.span()));
    has_pins_set_ = !saved.constant_sums.empty();
    std::ranges::copy(saved.constant_sums, coarse_.front().constants().sums.data());
}

void Multigrid::lay_out(Scratch& scratch, std::size_t pairs) {
    own_scratch_.free();
    has_pairs_ = pairs > 0;
    scratch.take(smooth_, pinned_.size());
    scratch.take(remainder_, pinned_.size());
    if (coarse_.empty()) return;
    scratch.take(springs_, slots_.size() * Stencil::lanes);
    for (CoarseLevel& level : coarse_) {
        level.lay_out(scratch, pairs);
        pairs = level.pairs().room();
    }
}

SavedLevels Multigrid::constant_part() const {
    SavedLevels part;
    part.slots = slots_;
    part.constant_links = constants_.links;
    part.constant_weights = constants_.weights;
    if (!coarse_.empty() && held_.empty())
        part.constant_sums = SharedBuffer<float>(coarse_.front().lists().constants.sums.span());
    part.levels.reserve(coarse_.size());
    for (const CoarseLevel& level : coarse_) part.levels.push_back(level.constant_part());
    part.springs = system_->springs();
    return part;
}

// Adds levels until all components are small. Each keeps a ninth of its nodes on the next level. A level that
// would keep more than half, because lengths have overflowed, is left to relaxation.
void Multigrid::make_levels(SpringGraph graph, std::vector<Link> links,
                            std::span<const std::uint32_t> numbers) {
    Components components = components_of(graph);
    for (;;) {
        const std::uint32_t most_direct = coarse_.empty() ? 0 : ComponentSolver::most_nodes;
        Coarsening coarsening = coarsen(graph, components, ratio, most_direct);
        const std::uint32_t nodes = coarsening.interpolation.coarse;
        if (nodes == 0 || nodes > graph.nodes() / 2) break;
        const bool finest = coarse_.empty();
        std::vector<bool> is_constant;
        std::vector<std::uint32_t> springs;  // by finest link
        for (std::size_t k = 0; finest && k < links.size(); ++k) {
            is_constant.push_back(numbers[k] != none);
            springs.push_back(is_constant[k] ? 0 : spring_of(links[k]));
        }
        GalerkinLists lists = make_galerkin_lists(links, coarsening.interpolation, is_constant);
        graph = make_coarse_graph(graph, coarsening, links, lists);
        links.assign(lists.links.begin(), lists.links.end());
        components = components_of(graph);
        if (finest) {
            weights_ = AlignedBuffer<float>(coarsening.interpolation.weights.size());
            std::ranges::copy(coarsening.interpolation.weights.span(), weights_.data());
            for (std::uint32_t& link : lists.fine_links.numbers)
                link = springs[link];  // padding may name any link
            for (std::uint32_t& link : lists.constants.fine_links.numbers) link = numbers[link];
        } else {
            const SharedBuffer<std::uint32_t>& places = coarse_.back().lists().places;
            for (std::uint32_t& link : lists.fine_links.numbers.span()) link = places[link];
        }
        lists.pack_fine_links();
        coarse_.emplace_back(std::move(lists), std::move(coarsening.interpolation), graph, components);
    }
    coarse_.shrink_to_fit();
}

void Multigrid::sum_constant(std::uint32_t k) noexcept {
    GalerkinLists::Constants& terms = coarse_.front().constants();
    double sum = 0;
    for (std::uint32_t t = terms.offsets[k]; t < terms.offsets[k + 1]; ++t) {
        // The number is in range, except in levels from a malicious file.
        const std::size_t number =
            std::min<std::size_t>(terms.fine_links.of(k, t), constants_.links.size() - 1);
        const Link& link = constants_.links[number];
        if (pinned_[link.first] != 0 || pinned_[link.second] != 0) continue;
        sum += static_cast<double>(terms.factors[t] * constants_.weights[number]);
    }
    terms.sums[coarse_.front().lists().places[k]] = static_cast<float>(sum);
}

// A link has terms in the coarse links between the nodes that its two ends are interpolated from.
void Multigrid::sum_constants_at(std::uint32_t particle) noexcept {
    const GalerkinLists& lists = coarse_.front().lists();
    const Interpolation& p = coarse_.front().interpolation();
    for_each_link_of(particle, [&](std::uint32_t, const Link& link) {
        if (!std::ranges::binary_search(constants_.links, link)) return;
        std::array<std::uint32_t, 2 * std::size_t{Interpolation::width}> nodes;
        std::size_t count = 0;
        for (const std::uint32_t end : {link.first, link.second})
            for (std::uint32_t e = Interpolation::width * end; e < Interpolation::width * (end + 1); ++e)
                if (p.weights[e] != 0) nodes[count++] = p.nodes[e];
        for (const std::uint32_t a : std::span(nodes).first(count)) {
            for (const std::uint32_t b : std::span(nodes).first(count)) {
                if (a >= b) continue;
                const auto at = std::ranges::lower_bound(lists.links, Link{a, b});
                if (at != lists.links.end() && *at == Link{a, b})
                    sum_constant(static_cast<std::uint32_t>(at - lists.links.begin()));
            }
        }
    });
}

std::uint32_t Multigrid::spring_of(const Link& link) const {
    const std::uint32_t entry = system_->entry_between(link.first, link.second);
    const auto slot = std::ranges::lower_bound(slots_, entry / Stencil::lanes);
    // The slot is listed, except in levels from a malicious file.
    const auto at = std::min<std::ptrdiff_t>(slot - slots_.begin(), std::ssize(slots_.span()) - 1);
    return static_cast<std::uint32_t>(at) * Stencil::lanes + entry % Stencil::lanes;
}

template <class Body>
void Multigrid::for_each_link_of(std::uint32_t particle, const Body& body) const {
    const ImplicitSystem::Neighbours row = system_->neighbours_of(particle);
    for (std::uint32_t k = 0; k < row.count; ++k) {
        const std::uint32_t neighbour = row[k];
        if (neighbour == particle) continue;
        const Link link{std::min(particle, neighbour), std::max(particle, neighbour)};
        body(neighbour, link);
    }
}

std::size_t Multigrid::links_of_particle(std::uint32_t particle) const {
    std::size_t count = 0;
    for_each_link_of(particle, [&](std::uint32_t, const Link&) { ++count; });
    return count;
}

void Multigrid::hold_springs_of(std::uint32_t particle, HeldSprings::iterator at) const {
    for_each_link_of(particle, [&](std::uint32_t neighbour, const Link& link) {
        const float weight = system_->constant_block(link.first, link.second);
        *at++ = {particle, neighbour, weight == 0 ? spring_of(link) : constant, weight};
    });
}

void Multigrid::mark(std::uint32_t particle, bool pinned) noexcept {
    pinned_[particle] = pinned ? 1 : 0;
    const Interpolation& p = coarse_.front().interpolation();
    for (std::uint32_t e = Interpolation::width * particle; e < Interpolation::width * (particle + 1); ++e)
        weights_[e] = pinned ? 0 : p.weights[e];
}

void Multigrid::pin(std::uint32_t particle) {
    if (coarse_.empty() || pinned_[particle] != 0) return;
    const auto later = std::ranges::upper_bound(held_, particle, {}, &HeldSpring::pinned) - held_.begin();
    const auto at = held_.insert(held_.begin() + later, links_of_particle(particle), HeldSpring{});
    hold_springs_of(particle, at);
    mark(particle, true);
    sum_constants_at(particle);
}

void Multigrid::unpin(std::uint32_t particle) noexcept {
    if (coarse_.empty() || pinned_[particle] == 0) return;
    const auto own = std::ranges::equal_range(held_, particle, {}, &HeldSpring::pinned);
    held_.erase(own.begin(), own.end());
    mark(particle, false);
    sum_constants_at(particle);
}

void Multigrid::set_pins(std::span<const Vec4> positions) {
    if (coarse_.empty() || (has_pins_set_ && are_pinned(positions))) return;
    has_pins_set_ = true;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        if (positions[i].w == 0) count += links_of_particle(i);
    held_.reserve(count);
    held_.resize(count);
    auto at = held_.begin();
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        mark(i, positions[i].w == 0);
        if (pinned_[i] == 0) continue;
        hold_springs_of(i, at);
        at += static_cast<std::ptrdiff_t>(links_of_particle(i));
    }
    for (std::uint32_t k = 0; k < coarse_.front().lists().links.size(); ++k) sum_constant(k);
}

bool Multigrid::are_pinned(std::span<const Vec4> positions) const {
    std::uint32_t others = 0;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        others |= pinned_[i] ^ (positions[i].w == 0 ? 1u : 0u);
    return others == 0;
}

void Multigrid::reserve_pins(std::size_t count) {
    if (most_links_ == 0) {
        for (std::uint32_t i = 0; i < pinned_.size(); ++i) {
            const std::uint32_t of_particle = system_->neighbours_of(i).count;
            most_links_ = std::max(most_links_, of_particle);
            all_links_ += of_particle;
        }
    }
    // `count` particles have at most this many links; and no link is listed more than once from each end.
    held_.reserve(std::min(count * most_links_, all_links_));
}

void Multigrid::list_pairs(PairRows* pairs, std::span<SeamRows* const> seams, std::uint32_t first) {
    if (coarse_.empty() || !has_pairs_) return;
    first_ = first;
    for (CoarseLevel& level : coarse_) level.pairs().clear();
    if (pairs != nullptr && !pairs->empty())
        coarse_.front().pairs().list(*pairs, first, static_cast<std::uint32_t>(pinned_.size()));
    for (const SeamRows* seam : seams)
        coarse_.front().pairs().list(*seam, first, static_cast<std::uint32_t>(pinned_.size()));
}

void Multigrid::build(Parallel& parallel, ImplicitSystem& system) {
    if (coarse_.empty()) return;
    if (has_pairs_) gather_pairs(parallel);
    system.spring_blocks(parallel, slots_, springs_.span());
    sum_first_ground(parallel, system);
    for (const HeldSpring& held : held_)
        if (held.spring != constant) springs_[held.spring] = {};
    coarse_.front().sum_links(parallel, springs_.span(), system.constant_scale());
    for (std::size_t k = 1; k < coarse_.size(); ++k) coarse_[k].sum(parallel, coarse_[k - 1]);
    // A level's bound is added after the sums: it is no ground of the next level, which has its own rows.
    for (CoarseLevel& level : coarse_) {
        level.add_bound_of_pairs();
        level.finish(parallel);
    }
}

void Multigrid::gather_pairs(Parallel& parallel) {
    CoarsePairs& pairs = coarse_.front().pairs();
    if (pairs.listed().empty()) return;
    pairs.gather(parallel, first_, coarse_.front().interpolation(), weights_.span());
    for (std::size_t k = 1; k < coarse_.size(); ++k)
        coarse_[k].pairs().gather(parallel, coarse_[k - 1].pairs(), coarse_[k].interpolation());
}

// Other cloth that touches this one counts as fixed: its pairs are added to the ground of each corner's
// particle, which restriction then takes to the coarse nodes.
void Multigrid::hold_other_bodies() {
    const auto particles = static_cast<std::uint32_t>(pinned_.size());
    for (const PairRows::ActivePair& active : coarse_.front().pairs().listed()) {
        if (CoarsePairs::is_inner(active, first_, particles)) continue;
        const Symmetric3 stiffness = active.stiffness();
        for (std::uint32_t c = 0; c < 4; ++c) {
            const std::uint32_t i = active.pair.corners[c] - first_;
            if (i >= particles || pinned_[i] != 0) continue;
            const float bound = 2 * std::abs(active.shape.weight(c));
            set_xyz(smooth_[i], xyz(smooth_[i]) + bound * Vector3(stiffness.xx, stiffness.yy, stiffness.zz));
            set_xyz(remainder_[i],
                    xyz(remainder_[i]) + bound * Vector3(stiffness.xy, stiffness.xz, stiffness.yz));
        }
    }
}

void Multigrid::sum_first_ground(Parallel& parallel, const ImplicitSystem& system) {
    // The particles' ground lies in the vectors of the cycle, which are unused between cycles.
    parallel.ranges(system.stencil().nodes, [&](const BlockRange& range) {
        ground_rows_block(range, system.right_side().data(), system.contacts(), smooth_.data(),
                          remainder_.data());
    });
    CoarseLevel& first = coarse_.front();
    if (first.pairs().has_outer()) hold_other_bodies();
    first.sum_ground(parallel, smooth_.span(),
                     system.contacts() != nullptr ? remainder_.span() : std::span<const Vec4>());
    // A spring to a pinned particle holds the coarse nodes that its free end is interpolated from.
    const Interpolation& p = first.interpolation();
    SymmetricRows& rows = first.matrix().ground_rows;
    for (const HeldSpring& held : held_) {
        if (pinned_[held.neighbour] != 0) continue;
        const Vec4 spring = held.spring != constant ? springs_[held.spring]
                                                    : Vec4{0, 0, 0, system.constant_scale() * held.weight};
        for (std::uint32_t k = 0; k < Interpolation::width; ++k) {
            const std::uint32_t e = Interpolation::width * held.neighbour + k;
            if (p.weights[e] == 0) continue;
            Symmetric3 ground = rows[p.nodes[e]];
            ground.add(p.weights[e] * spring.w, std::sqrt(p.weights[e]) * xyz(spring));
            rows.set(p.nodes[e], ground);
        }
    }
}

void Multigrid::cycle(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> r,
                      std::span<Vec4> z) {
    if (coarse_.empty()) {
        system.precondition(parallel, r, finest_step, smooth_.span());
        system.relax(parallel, r, smooth_.span(), {.step = finest_step}, z);
        return;
    }
    CoarseLevel& first = coarse_.front();
    system.subtract_first_step(parallel, r, finest_step, smooth_.span(), remainder_.span());
    restrict_to(parallel, first.interpolation(), remainder_.span(), first.b());
    solve_level(parallel, 0);
    system.relax_corrected(parallel, r, finest_step, smooth_.span(),
                           {first.interpolation(), weights_.span(), first.x()}, z);
}

void Multigrid::solve_level(Parallel& parallel, std::size_t k) {
    CoarseLevel& level = coarse_[k];
    if (!level.has_small_components_only()) relax_and_correct(parallel, k);
    level.solve_small_components(parallel);
}

void Multigrid::relax_and_correct(Parallel& parallel, std::size_t k) {
    CoarseLevel& level = coarse_[k];
    // One step on the first coarse level, which costs as much as all others: a second step there gains less.
    const bool once = k == 0;
    level.relax_from_zero(parallel, once ? first_coarse_step : coarse_smoothing.first.step);
    if (!once) level.relax(parallel, coarse_smoothing.second);
    if (k + 1 < coarse_.size()) {
        level.subtract_product(parallel, level.before());
        const Interpolation& p = coarse_[k + 1].interpolation();
        restrict_to(parallel, p, level.before(), coarse_[k + 1].b());
        solve_level(parallel, k + 1);
        prolong_from(parallel, {p, p.weights.span(), coarse_[k + 1].x()}, level.x());
    }
    level.relax(parallel, once ? Relaxation{.step = first_coarse_step} : coarse_smoothing.first);
    if (!once) level.relax(parallel, coarse_smoothing.second);
}

std::size_t Multigrid::bytes() const noexcept {
    std::size_t sum = slots_.bytes() + held_.capacity() * sizeof(HeldSpring) + pinned_.bytes() +
                      constants_.links.bytes() + constants_.weights.bytes() + weights_.bytes() +
                      coarse_.size() * sizeof(CoarseLevel);
    for (const CoarseLevel& level : coarse_) sum += level.bytes();
    return sum;
}

}  // namespace weft
