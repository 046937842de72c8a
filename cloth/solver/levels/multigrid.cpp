#include "cloth/solver/levels/multigrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cloth/equation/seam_rows.h"
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
// On coarse levels, where blocks may be indefinite, the spectrum of D^-1 W was measured to end at 3.4; the
// polynomial for [0.6, 3] damps up to 3.6.
constexpr Chebyshev2 coarse_smoothing = chebyshev2(0.6f, 3.0f);
constexpr float first_coarse_step = 2 / (0.5f + 3.0f);

/// Adds the rows of a cloth whose particles are numbered from `first` on.
void add_rows(Parallel& parallel, const Multigrid::Source& cloth, std::uint32_t first, SpringGraph& graph) {
    ImplicitSystem& system = cloth.system;
    const AlignedBuffer<Vec4> blocks = system.all_spring_blocks(parallel);
    for (std::uint32_t i = 0; i < system.stencil().nodes; ++i) {
        const ImplicitSystem::Neighbours row = system.neighbours_of(i);
        for (std::uint32_t k = 0; k < row.count; ++k) {
            const std::uint32_t j = row[k];
            if (j == i) continue;
            const std::uint32_t entry = system.entry_between(i, j);
            graph.neighbours.push_back(first + j);
            // Links of bending alone, and of bending that pushes apart, interpolate nothing.
            const float stiffness = 3 * blocks[entry].w + xyz(blocks[entry]).squaredNorm();
            graph.stiffness.push_back(std::max(stiffness, 0.0f));
            graph.lengths.push_back((xyz(cloth.positions[j]) - xyz(cloth.positions[i])).norm());
        }
        graph.offsets.push_back(static_cast<std::uint32_t>(graph.neighbours.size()));
    }
}

SpringGraph graph_of(Parallel& parallel, std::span<const Multigrid::Source> cloths) {
    const std::vector<std::uint32_t> firsts = Multigrid::first_particles(cloths);
    SpringGraph graph;
    graph.offsets.push_back(0);
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        graph.offsets.resize(firsts[k] + std::size_t{1}, graph.offsets.back());
        add_rows(parallel, cloths[k], firsts[k], graph);
    }
    return graph;
}

/// Sorts numbers or links, each once.
template <class Value>
void make_set(std::vector<Value>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

bool is_linked(const SpringGraph& graph, const Link& link) {
    return std::ranges::binary_search(graph.neighbours.begin() + graph.offsets[link.first],
                                      graph.neighbours.begin() + graph.offsets[link.first + 1], link.second);
}

/// The graph with stitches as springs of no length, as stiff as the stiffest of it.
SpringGraph with_stitches(const SpringGraph& graph, const std::vector<Link>& stitches) {
    std::vector<Link> at_ends = stitches;
    for (const Link& link : stitches) at_ends.push_back({link.second, link.first});
    std::ranges::sort(at_ends);
    const float stiffest = graph.stiffness.empty() ? 0 : std::ranges::max(graph.stiffness);
    SpringGraph sum;
    sum.offsets.push_back(0);
    auto stitch = at_ends.begin();
    const auto add = [&](std::uint32_t neighbour, float stiffness, float length) {
        sum.neighbours.push_back(neighbour);
        sum.stiffness.push_back(stiffness);
        sum.lengths.push_back(length);
    };
    for (std::uint32_t i = 0; i < graph.nodes(); ++i) {
        const auto add_stitches_below = [&](std::uint32_t end) {
            for (; stitch != at_ends.end() && stitch->first == i && stitch->second < end; ++stitch)
                add(stitch->second, stiffest, 0);
        };
        for (std::uint32_t e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
            add_stitches_below(graph.neighbours[e]);
            add(graph.neighbours[e], graph.stiffness[e], graph.lengths[e]);
        }
        add_stitches_below(graph.nodes());
        sum.offsets.push_back(static_cast<std::uint32_t>(sum.neighbours.size()));
    }
    return sum;
}

}  // namespace

std::vector<std::uint32_t> Multigrid::first_particles(std::span<const Source> cloths) {
    std::vector<std::uint32_t> firsts;
    std::uint32_t end = 0;
    for (const Source& cloth : cloths) {
        firsts.push_back(Stencil::whole_groups(end));
        end = firsts.back() + cloth.system.stencil().nodes;
    }
    firsts.push_back(end);
    return firsts;
}

Multigrid::Multigrid(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> positions)
    : Multigrid(parallel, std::array{Source{system, positions}}, {}) {
    set_pins(positions);
    lay_out_alone();
}

Multigrid::Multigrid(Parallel& parallel, std::span<const Source> cloths, std::vector<Link> stitches)
    : ranges_(cloths.size()), stitches_(std::move(stitches)), pinned_(first_particles(cloths).back()) {
    for (const Link& link : stitches_) stitched_.insert(stitched_.end(), {link.first, link.second});
    make_set(stitched_);
    make_set(stitches_);
    SpringGraph graph = graph_of(parallel, cloths);
    std::erase_if(stitches_, [&](const Link& link) { return is_linked(graph, link); });
    if (!stitches_.empty()) graph = with_stitches(graph, stitches_);
    std::vector<Link> links = links_of(graph);
    std::vector<float> constants(links.size());
    std::vector<std::uint32_t> slots;
    const std::vector<std::uint32_t> firsts = first_particles(cloths);
    auto link = links.begin();
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        ImplicitSystem& system = cloths[k].system;
        const std::uint32_t first = firsts[k], count = system.stencil().nodes;
        std::vector<std::uint32_t> own;
        for (; link != links.end() && link->first < first + count; ++link) {
            if (std::ranges::binary_search(stitches_, *link)) continue;
            const std::uint32_t i = link->first - first, j = link->second - first;
            // The constants of two cloths have two scales, so that common levels have none.
            float& block = constants[static_cast<std::size_t>(link - links.begin())];
            block = is_common() ? 0 : system.constant_block(i, j);
            if (block == 0) own.push_back(system.entry_between(i, j) / Stencil::lanes);
        }
        make_set(own);
        parts_.push_back({.system = &system,
                          .first = first,
                          .count = count,
                          .first_slot = static_cast<std::uint32_t>(slots.size()),
                          .slots = static_cast<std::uint32_t>(own.size())});
        slots.insert(slots.end(), own.begin(), own.end());
    }
    slots_ = SharedBuffer<std::uint32_t>(slots);
    if (is_common()) held_.reserve(2 * links.size());
    make_levels(std::move(graph), std::move(links), constants);
    if (is_common()) leave();
}

Multigrid::Multigrid(ImplicitSystem& system, SavedLevels&& saved, std::uint32_t particles)
    : parts_{{.system = &system,
              .first = 0,
              .count = particles,
              .first_slot = 0,
              .slots = static_cast<std::uint32_t>(saved.slots.size())}},
      ranges_(1),
      slots_(std::move(saved.slots)),
      constants_(AlignedBuffer<double>::from_bytes(std::as_bytes(std::as_const(saved.constants).span()))),
      shifts_(std::move(saved.shifts)),
      pinned_(particles) {
    coarse_.reserve(saved.levels.size());
    for (CoarseLevel::Constants& level : saved.levels) coarse_.emplace_back(std::move(level));
}

// The springs are summed up before finish() makes a level's matrix, which takes their place. Stitches, which
// are among the springs of common levels, are in use longer.
void Multigrid::lay_out_cycle(Scratch& scratch, std::size_t pairs) {
    own_scratch_.free();
    has_pairs_ = pairs > 0;
    scratch.take(smooth_, pinned_.size());
    scratch.take(remainder_, pinned_.size());
    if (coarse_.empty()) return;
    for (CoarseLevel& level : coarse_) {
        level.lay_out_pairs(scratch, pairs);
        pairs = level.pairs().room();
    }
    const auto springs = [&] { scratch.take(springs_, slots_.size() * Stencil::lanes + stitches_.size()); };
    const auto cycle = [&] {
        for (CoarseLevel& level : coarse_) level.lay_out_cycle(scratch);
    };
    if (!is_common()) return scratch.take_by_turns(springs, cycle);
    springs();
    cycle();
}

SavedLevels Multigrid::constant_part() const {
    SavedLevels part;
    part.slots = slots_;
    part.constants = SharedBuffer<double>(constants_.span());
    part.shifts = shifts_;
    part.levels.reserve(coarse_.size());
    for (const CoarseLevel& level : coarse_) part.levels.push_back(level.constant_part());
    part.springs = parts_.front().system->springs();
    return part;
}

// Adds levels until all components are small. Each keeps a ninth of its nodes on the next level. A level that
// would keep more than half, because lengths have overflowed, is left to relaxation.
void Multigrid::make_levels(SpringGraph graph, std::vector<Link> links, std::span<const float> constants) {
    Components components = components_of(graph);
    std::vector<std::uint32_t> places;  // by link, from the second level on
    for (;;) {
        const std::uint32_t most_direct = coarse_.empty() ? 0 : ComponentSolver::most_nodes;
        Coarsening coarsening = coarsen(graph, components, ratio, most_direct);
        const std::uint32_t nodes = coarsening.interpolation.coarse;
        if (nodes == 0 || nodes > graph.nodes() / 2) break;
        const bool finest = coarse_.empty();
        std::vector<std::uint32_t> springs;  // by finest link
        for (std::size_t k = 0; finest && k < links.size(); ++k)
            springs.push_back(constants[k] != 0 ? 0 : spring_of(links[k]));
        CoarseLinks coarse =
            make_coarse_links(links, coarsening.interpolation, finest ? constants : std::span<const float>());
        GalerkinLists& lists = coarse.lists;
        graph = make_coarse_graph(graph, coarsening, links, coarse);
        components = components_of(graph);
        if (finest) {
            constants_ = AlignedBuffer<double>::from_bytes(std::as_bytes(std::span(coarse.constants)));
            shifts_ = SharedBuffer<float>(std::span<const float>(coarse.shifts));
            for (std::uint32_t& link : lists.fine_links.numbers)
                link = springs[link];  // padding may name any link
        } else {
            for (std::uint32_t& link : lists.fine_links.numbers.span()) link = places[link];
        }
        lists.pack_fine_links();
        coarse_.emplace_back(coarse, std::move(coarsening.interpolation), graph, components);
        links = std::move(coarse.links);
        places = std::move(coarse.places);
    }
    coarse_.shrink_to_fit();
}

void Multigrid::leave() noexcept {
    entered_ = 0;
    leader_ = none;
    if (!is_common()) return;
    for (Part& part : parts_) part.system = nullptr;
}

void Multigrid::enter(std::uint32_t k, ImplicitSystem& system, const StepEquation& equation) noexcept {
    Part& part = parts_[k];
    part.system = &system;
    part.equation = &equation;
    ranges_[entered_++] = {equation.first, part.first, part.count};
    leader_ = std::min(leader_, k);
}

void Multigrid::list_pairs(PairRows* pairs) {
    if (coarse_.empty() || !has_pairs_) return;
    for (CoarseLevel& level : coarse_) level.pairs().clear();
    if (pairs != nullptr && !pairs->empty()) coarse_.front().pairs().list(*pairs, numbering());
}

void Multigrid::build(Parallel& parallel) {
    if (coarse_.empty()) return;
    if (has_pairs_) gather_pairs(parallel);
    for (const Part& part : parts_) {
        const std::span<Vec4> blocks = springs_.span().subspan(std::size_t{part.first_slot} * Stencil::lanes,
                                                               std::size_t{part.slots} * Stencil::lanes);
        if (part.system != nullptr)
            part.system->spring_blocks(parallel, slots_of(part), blocks);
        else
            std::ranges::fill(blocks, Vec4{});
    }
    sum_ground_of_particles(parallel);
    sum_stitches();
    sum_first_ground(parallel);
    for (const HeldSpring& held : held_)
        if (held.spring != constant) springs_[held.spring] = {};
    coarse_.front().sum_links(parallel, springs_.span(), constants_.span(), constant_scale());
    for (std::size_t k = 1; k < coarse_.size(); ++k) coarse_[k].sum(parallel, coarse_[k - 1]);
    // A level's bound is added after the sums: it is no ground of the next level, which has its own rows.
    for (CoarseLevel& level : coarse_) {
        level.add_bound_of_pairs();
        level.finish(parallel);
    }
}

void Multigrid::gather_pairs(Parallel& parallel) {
    CoarsePairs& pairs = coarse_.front().pairs();
    if (!pairs.has_listed()) return;
    pairs.gather(parallel, numbering(), {coarse_.front().interpolation(), pinned_.data()});
    for (std::size_t k = 1; k < coarse_.size(); ++k)
        coarse_[k].pairs().gather(parallel, coarse_[k - 1].pairs(), coarse_[k].interpolation());
}

// Other cloth that touches this one counts as fixed: its pairs are added to the ground of each corner's
// particle, which restriction then takes to the coarse nodes.
void Multigrid::hold_other_bodies() {
    const Numbering number = numbering();
    coarse_.front().pairs().for_each_listed([&](const PairRows::ActivePair& active) {
        if (number.has_all_corners(active.pair)) return;
        const Symmetric3 stiffness = active.stiffness();
        for (std::uint32_t c = 0; c < 4; ++c)
            hold(active.pair.corners[c], 2 * std::abs(active.shape.weight(c)), stiffness);
    });
}

void Multigrid::hold(std::uint32_t particle, float factor, const Symmetric3& stiffness) {
    const std::uint32_t i = numbering()(particle);
    if (i == Numbering::none || pinned_[i] != 0) return;
    set_xyz(smooth_[i], xyz(smooth_[i]) + factor * Vector3(stiffness.xx, stiffness.yy, stiffness.zz));
    set_xyz(remainder_[i], xyz(remainder_[i]) + factor * Vector3(stiffness.xy, stiffness.xz, stiffness.yz));
}

// The particles' ground lies in the vectors of the cycle, which are unused between cycles.
void Multigrid::sum_ground_of_particles(Parallel& parallel) {
    for (const Part& part : parts_) {
        const std::span<Vec4> diagonal = of(part, smooth_), off_diagonal = of(part, remainder_);
        const bool is_present = part.system != nullptr;
        const bool has_contacts = is_present && part.system->contacts() != nullptr;
        if (is_present)
            parallel.ranges(part.count, [&](const BlockRange& range) {
                ground_rows_block(range, part.system->right_side().data(), part.system->contacts(),
                                  diagonal.data(), off_diagonal.data());
            });
        else
            std::ranges::fill(diagonal, Vec4{});
        if (!has_contacts && has_contact_rows()) std::ranges::fill(off_diagonal, Vec4{});
    }
}

void Multigrid::sum_first_ground(Parallel& parallel) {
    CoarseLevel& first = coarse_.front();
    if (first.pairs().has_outer()) hold_other_bodies();
    first.sum_ground(parallel, smooth_.span(),
                     has_contact_rows() ? remainder_.span() : std::span<const Vec4>());
    // A spring to a pinned particle holds the coarse nodes that its free end is interpolated from.
    const Interpolation& p = first.interpolation();
    SymmetricRows& rows = first.matrix().ground_rows;
    for (const HeldSpring& held : held_) {
        if (pinned_[held.neighbour] != 0) continue;
        const Vec4 spring =
            held.spring != constant ? springs_[held.spring] : Vec4{0, 0, 0, constant_scale() * held.weight};
        for (std::uint32_t k = 0; k < Interpolation::width; ++k) {
            const std::uint32_t e = Interpolation::width * held.neighbour + k;
            if (p.weights[e] == 0) continue;
            Symmetric3 ground = rows[p.nodes[e]];
            ground.add(p.weights[e] * spring.w, std::sqrt(p.weights[e]) * xyz(spring));
            rows.set(p.nodes[e], ground);
        }
    }
}

void Multigrid::cycle(Parallel& parallel) {
    if (coarse_.empty()) {
        for (const Part& part : parts_) {
            if (part.system == nullptr) continue;
            part.system->precondition(parallel, part.r, finest_step, of(part, smooth_));
            part.system->relax(parallel, part.r, of(part, smooth_), {.step = finest_step}, part.z);
        }
        return;
    }
    CoarseLevel& first = coarse_.front();
    for (const Part& part : parts_) {
        if (part.system != nullptr)
            part.system->subtract_first_step(parallel, part.r, finest_step, of(part, smooth_),
                                             of(part, remainder_));
        else
            std::ranges::fill(of(part, remainder_), Vec4{});
    }
    subtract_stitches();
    restrict_to(parallel, first.interpolation(), remainder_.span(), first.b());
    solve_level(parallel, 0);
    for (const Part& part : parts_)
        if (part.system != nullptr)
            part.system->relax_corrected(parallel, part.r, finest_step, of(part, smooth_),
                                         {first.interpolation(), first.x(), pinned_.data(), part.first},
                                         part.z);
    relax_stitches();
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
        prolong_from(parallel, {p, coarse_[k + 1].x()}, level.x());
    }
    level.relax(parallel, once ? Relaxation{.step = first_coarse_step} : coarse_smoothing.first);
    if (!once) level.relax(parallel, coarse_smoothing.second);
}

std::size_t Multigrid::bytes() const noexcept {
    std::size_t sum = slots_.bytes() + held_.capacity() * sizeof(HeldSpring) + pinned_.bytes() +
                      constants_.bytes() + shifts_.bytes() + coarse_.size() * sizeof(CoarseLevel) +
                      parts_.size() * sizeof(Part) + stitches_.size() * sizeof(Link) +
                      stitched_.size() * sizeof(std::uint32_t);
    for (const CoarseLevel& level : coarse_) sum += level.bytes();
    return sum;
}

}  // namespace weft
