#include "cloth/solvers/multigrid/multigrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "cloth/system/sparse/vectors.h"

namespace weft {

namespace {

constexpr float ratio = 9;                    // of nodes, from level to level
constexpr std::uint32_t coarsest_nodes = 16;  // few enough for a dense factorisation

/// Chebyshev semi-iteration on [low, high] (Golub and Varga 1961), from its first step on.
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
    const Stencil& stencil = system.stencil();
    const AlignedBuffer<Vec4> blocks = system.all_spring_blocks(parallel);
    SpringGraph graph;
    graph.offsets.push_back(0);
    for (std::uint32_t i = 0; i < stencil.nodes; ++i) {
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
            const std::uint32_t j = stencil.neighbours[s * Stencil::lanes + lane];
            if (j == i) continue;
            const std::uint32_t entry = system.entry_between(i, j);
            graph.neighbours.push_back(j);
            graph.stiffness.push_back(3 * blocks[entry].w + xyz(blocks[entry]).squaredNorm());
            graph.lengths.push_back((xyz(positions[j]) - xyz(positions[i])).norm());
        }
        graph.offsets.push_back(static_cast<std::uint32_t>(graph.neighbours.size()));
    }
    return graph;
}

}  // namespace

Multigrid::Multigrid(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> positions)
    : system_(&system), smooth_(positions.size()), remainder_(positions.size()) {
    SpringGraph graph = graph_of(parallel, system, positions);
    links_ = links_of(graph);
    std::erase_if(links_, [&](const Link& link) { return system.is_minor(link.first, link.second); });
    for (const Link& link : links_) slots_.push_back(entry_of(link) / Stencil::lanes);
    std::ranges::sort(slots_);
    slots_.erase(std::unique(slots_.begin(), slots_.end()), slots_.end());
    slots_of_links_ = slots_.size();
    links_.shrink_to_fit();
    slots_.shrink_to_fit();

    std::vector<Link> links = links_;
    while (graph.nodes() > coarsest_nodes) {
        Coarsening coarsening = coarsen(graph, ratio);
        if (coarsening.interpolation.coarse == 0 || coarsening.interpolation.coarse == graph.nodes()) break;
        GalerkinLists lists = make_galerkin_lists(links, coarsening.interpolation);
        graph = make_coarse_graph(graph, coarsening, links, lists);
        links = lists.links;
        if (coarse_.empty()) {
            weights_ = AlignedBuffer<float>(coarsening.interpolation.weights.size());
            for (std::uint32_t& link : lists.fine_links.span()) link = spring_of(links_[link]);
        } else {
            const std::vector<std::uint32_t>& places = coarse_.back().lists().places;
            for (std::uint32_t& link : lists.fine_links.span()) link = places[link];
        }
        coarse_.emplace_back(std::move(lists), std::move(coarsening.interpolation), graph);
    }
    const auto n = static_cast<Eigen::Index>(3 * (coarse_.empty() ? 0 : coarse_.back().nodes()));
    coarsest_.resize(n, n);
    factor_.compute(Eigen::MatrixXd::Identity(n, n));  // takes its memory
    coarsest_x_.resize(n);
    set_pins(positions);
}

std::uint32_t Multigrid::entry_of(const Link& link) const {
    return system_->entry_between(link.first, link.second);
}

std::uint32_t Multigrid::spring_of(const Link& link) const {
    const std::uint32_t entry = entry_of(link);
    // Behind the links' slots, which ascend, lie those of ties, which do not.
    const std::span slots = std::span(slots_).first(slots_of_links_);
    const auto slot = std::ranges::lower_bound(slots, entry / Stencil::lanes);
    return static_cast<std::uint32_t>(slot - slots.begin()) * Stencil::lanes + entry % Stencil::lanes;
}

void Multigrid::set_pins(std::span<const Vec4> positions) {
    if (coarse_.empty()) return;
    const Interpolation& p = coarse_.front().interpolation();
    for (std::uint32_t i = 0; i < p.fine; ++i) {
        for (std::uint32_t e = Interpolation::width * i; e < Interpolation::width * (i + 1); ++e)
            weights_[e] = positions[i].w == 0 ? 0 : p.weights[e];
    }
    tie_to(positions);
    if (springs_.size() != slots_.size() * Stencil::lanes)
        springs_ = AlignedBuffer<Vec4>(slots_.size() * Stencil::lanes);
}

void Multigrid::tie_to(std::span<const Vec4> positions) {
    slots_.resize(slots_of_links_);
    held_.clear();
    ties_.clear();
    const Interpolation& p = coarse_.front().interpolation();
    for (const Link& link : links_) {
        const bool first_is_pinned = positions[link.first].w == 0,
                   second_is_pinned = positions[link.second].w == 0;
        if (first_is_pinned || second_is_pinned) held_.push_back(spring_of(link));
        if (first_is_pinned == second_is_pinned) continue;
        // The free particle's own half-edge: blocks of pinned rows may hold anything.
        const Link own = second_is_pinned ? link : Link{link.second, link.first};
        const std::uint32_t entry = entry_of(own);
        const auto spring =
            static_cast<std::uint32_t>(slots_.size()) * Stencil::lanes + entry % Stencil::lanes;
        slots_.push_back(entry / Stencil::lanes);
        for (std::uint32_t e = Interpolation::width * own.first; e < Interpolation::width * (own.first + 1);
             ++e) {
            if (p.weights[e] != 0) ties_.push_back({p.nodes[e], spring, p.weights[e]});
        }
    }
    std::ranges::sort(ties_, [](const Tie& a, const Tie& b) {
        return std::tie(a.coarse, a.spring) < std::tie(b.coarse, b.spring);
    });
}

void Multigrid::build(Parallel& parallel, ImplicitSystem& system) {
    if (coarse_.empty()) return;
    system.spring_blocks(parallel, slots_, springs_.span());
    for (const std::uint32_t spring : held_) springs_[spring] = {};
    coarse_.front().sum_links(parallel, springs_.span());
    sum_first_ground(parallel, system);
    coarse_.front().finish(parallel);
    for (std::size_t k = 1; k < coarse_.size(); ++k) {
        coarse_[k].sum(parallel, coarse_[k - 1]);
        coarse_[k].finish(parallel);
    }
    factorise_coarsest();
}

void Multigrid::sum_first_ground(Parallel& parallel, const ImplicitSystem& system) {
    // The particles' rows are put where a cycle has its vectors: between cycles these are free.
    parallel.ranges(system.stencil().nodes, [&](const BlockRange& range) {
        ground_rows_block(range, system.right_side().data(), system.contacts(), smooth_.data(),
                          remainder_.data());
    });
    CoarseLevel& first = coarse_.front();
    first.sum_ground(parallel, smooth_.span(),
                     system.contacts() != nullptr ? remainder_.span() : std::span<const Vec4>());
    SymmetricRows& rows = first.matrix().ground_rows;
    for (const Tie& tie : ties_) {
        const Vec4& spring = springs_[tie.spring];
        Symmetric3 ground = rows[tie.coarse];
        ground.add(tie.weight * spring.w, std::sqrt(tie.weight) * xyz(spring));
        rows.set(tie.coarse, ground);
    }
}

void Multigrid::factorise_coarsest() {
    const CoarseMatrix& matrix = coarse_.back().matrix();
    const GalerkinLists& lists = coarse_.back().lists();
    coarsest_.setZero();
    for (std::uint32_t i = 0; i < matrix.stencil.nodes; ++i)
        coarsest_.block<3, 3>(3 * i, 3 * i) = matrix.ground_rows[i].full();
    for (std::size_t k = 0; k < lists.links.size(); ++k) {
        const Eigen::Matrix3d block = matrix.links[lists.places[k]].full();
        const Eigen::Index i = 3 * lists.links[k].first, j = 3 * lists.links[k].second;
        coarsest_.block<3, 3>(i, i) += block;
        coarsest_.block<3, 3>(j, j) += block;
        coarsest_.block<3, 3>(i, j) -= block;
        coarsest_.block<3, 3>(j, i) -= block;
    }
    const double largest = coarsest_.diagonal().maxCoeff();
    // Nodes of pinned particles alone have no rows; and W was summed in single precision.
    coarsest_.diagonal().array() += 1e-6 * largest;
    factor_.compute(coarsest_);
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
    if (k + 1 == coarse_.size()) return solve_coarsest();
    // Once on the largest of them, which costs as much as all others: a second step there gains less.
    const bool once = k == 0;
    level.relax_from_zero(parallel, once ? first_coarse_step : coarse_smoothing.first.step);
    if (!once) level.relax(parallel, coarse_smoothing.second);
    level.subtract_product(parallel, level.before());
    const Interpolation& p = coarse_[k + 1].interpolation();
    restrict_to(parallel, p, level.before(), coarse_[k + 1].b());
    solve_level(parallel, k + 1);
    prolong_from(parallel, {p, p.weights.span(), coarse_[k + 1].x()}, level.x());
    level.relax(parallel, once ? Relaxation{.step = first_coarse_step} : coarse_smoothing.first);
    if (!once) level.relax(parallel, coarse_smoothing.second);
}

void Multigrid::solve_coarsest() {
    CoarseLevel& level = coarse_.back();
    for (std::uint32_t i = 0; i < level.nodes(); ++i)
        coarsest_x_.segment<3>(3 * i) = xyz(level.b()[i]).cast<double>();
    factor_.solveInPlace(coarsest_x_);
    for (std::uint32_t i = 0; i < level.nodes(); ++i)
        level.x()[i] = to_vec4(coarsest_x_.segment<3>(3 * i).cast<float>(), 0);
}

std::size_t Multigrid::bytes() const noexcept {
    std::size_t sum = links_.size() * sizeof(Link) + (slots_.size() + held_.size()) * sizeof(std::uint32_t) +
                      springs_.bytes() + weights_.bytes() + ties_.size() * sizeof(Tie) + smooth_.bytes() +
                      remainder_.bytes();
    for (const CoarseLevel& level : coarse_) sum += level.bytes();
    return sum;
}

}  // namespace weft
