#include "cloth/solver/levels/levels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/memory/list_checks.h"

namespace weft {

namespace {

/// visit(list) for each list of one level.
template <class Level, class Visit>
void visit_level(Level& level, Visit& visit) {
    visit(level.lists.group_slots);
    visit(level.lists.fine_links.numbers);
    visit(level.lists.factors);
    visit(level.lists.fine_links.bases);
    visit(level.lists.fine_links.from_base);
    visit.value(level.interpolation.fine);
    visit.value(level.interpolation.coarse);
    visit(level.interpolation.nodes);
    visit(level.interpolation.weights);
    visit(level.interpolation.kept);
    visit(level.interpolation.offsets);
    visit(level.interpolation.entries);
    visit.value(level.stencil.nodes);
    Stencil::for_each_list(level.stencil, visit);
    visit(level.link_rows);
    SmallComponents::for_each_list(level.small_components, visit);
}

/// Visits every saved list. Precondition when reading: the head has been read.
template <class Saved, class Visit>
void visit_all_lists(Saved& saved, Visit& visit) {
    visit(saved.slots);
    visit(saved.constants);
    visit(saved.shifts);
    for (auto& level : saved.levels) visit_level(level, visit);
    if (saved.springs) SavedSprings::for_each_list(*saved.springs, visit);
}

struct LevelsHead {
    std::uint32_t kind = 0, levels = 0, springs = 0;
};

std::uint32_t bits_of(const SystemKind& kind) {
    return kind.elements | kind.bending << 1 | kind.dihedral << 2 | kind.consistent_mass << 3 |
           kind.stiffening << 4;
}
SystemKind kind_of(std::uint32_t bits) {
    SystemKind kind{ClothSettings()};
    kind.elements = (bits & 1) != 0;
    kind.bending = (bits & 2) != 0;
    kind.dihedral = (bits & 4) != 0;
    kind.consistent_mass = (bits & 8) != 0;
    kind.stiffening = (bits & 16) != 0;
    return kind;
}

template <class Visit>
void visit_saved(const SavedLevels& levels, Visit& visit) {
    visit.value(LevelsHead{bits_of(levels.kind), static_cast<std::uint32_t>(levels.levels.size()),
                           levels.springs ? 1u : 0u});
    visit_all_lists(levels, visit);
}

bool are_weights(std::span<const float> numbers) {
    return are_within(numbers, 1e6f);
}

/// Whether there are `terms` terms in `rows` rows.
bool are_fine_links(const FineLinks& links, std::size_t rows, std::size_t terms) {
    if (!links.is_packed()) return links.numbers.size() == terms;
    return links.numbers.empty() && links.from_base.size() == terms && links.bases.size() == rows;
}

/// Whether base + number is below `end` for each of the numbers.
[[gnu::noinline]] bool are_near(std::span<const std::uint16_t> numbers, std::uint32_t base, std::size_t end) {
    if (numbers.empty()) return true;
    if (base >= end) return false;
    const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(end - base - 1, 65535));
    std::uint32_t bits = 0;
    for (const std::uint16_t number : numbers) bits |= last - number;
    return bits < first_bit;
}

/// Whether all terms of sums name links below `end`. Precondition: the groups' slots are within the terms.
bool name_links_below(const GalerkinLists& lists, std::size_t end) {
    const FineLinks& links = lists.fine_links;
    if (!links.is_packed()) return are_below(links.numbers.span(), end);
    constexpr std::size_t width = Stencil::lanes;
    for (std::size_t group = 0; group < links.bases.size(); ++group) {
        const std::size_t first = width * lists.group_slots[group];
        const auto of_group =
            links.from_base.span().subspan(first, width * lists.group_slots[group + 1] - first);
        if (!are_near(of_group, links.bases[group], end)) return false;
    }
    return true;
}

bool fits_transpose(const Interpolation& p) {
    return are_offsets(p.offsets.span(), p.coarse, p.entries.size()) &&
           are_below(p.entries.span(), std::size_t{Interpolation::width} * p.fine);
}

/// `fine`, `springs`: the finer level's numbers of nodes and springs.
bool fits_level(const CoarseLevel::Constants& level, std::uint32_t fine, std::size_t springs) {
    const GalerkinLists& lists = level.lists;
    const Interpolation& p = level.interpolation;
    constexpr std::uint32_t lanes = Stencil::lanes;
    const std::size_t groups = lists.groups();
    const std::size_t weights = std::size_t{Interpolation::width} * Stencil::whole_groups(fine);
    return p.fine == fine && p.coarse > 0 && p.coarse <= fine / 2 && p.kept.size() == p.coarse &&
           p.nodes.size() == weights && p.weights.size() == weights && are_below(p.kept, fine) &&
           are_below(p.nodes.span(), p.coarse) && are_weights(p.weights) &&
           lists.factors.size() % lanes == 0 &&
           are_offsets(lists.group_slots.span(), groups, lists.factors.size() / lanes) &&
           are_fine_links(lists.fine_links, groups, lists.factors.size()) &&
           name_links_below(lists, springs) && are_weights(lists.factors) && fits_transpose(p) &&
           level.stencil.is_sound(p.coarse, 0) && level.link_rows.size() == level.stencil.neighbours.size() &&
           are_below(level.link_rows.span(), groups * lanes + 1) &&
           level.small_components.is_sound(p.coarse, groups * lanes);
}

}  // namespace

void visit_lists(const SavedLevels& levels, PackedSize& size) {
    visit_saved(levels, size);
}

void visit_lists(const SavedLevels& levels, PackedWriter& writer) {
    visit_saved(levels, writer);
}

std::optional<SavedLevels> read_levels(PackedReader& reader, const ClothModel& model) {
    constexpr std::uint32_t most_levels = 64;
    LevelsHead head;
    reader.value(head);
    if (!reader.is_sound() || head.levels > most_levels) return std::nullopt;
    SavedLevels levels;
    levels.kind = kind_of(head.kind);
    levels.levels.resize(head.levels);
    if (head.springs != 0) levels.springs.emplace();
    visit_all_lists(levels, reader);
    if (!reader.is_sound()) return std::nullopt;
    if (!levels.springs) return levels;
    levels.springs->diagonals = diagonals_of(model);
    const bool are_sound = levels.springs->is_sound(model, levels.kind.stiffening) &&
                           fit(levels, model.particle_count, levels.springs->entries());
    return are_sound ? std::optional(std::move(levels)) : std::nullopt;
}

bool fit(const SavedLevels& levels, std::uint32_t particles, std::size_t entries) {
    if (levels.levels.empty())
        return levels.slots.empty() && levels.constants.empty() && levels.shifts.empty();
    if (levels.slots.empty() || !are_below(levels.slots.span(), entries / Stencil::lanes) ||
        levels.constants.size() != std::size_t{levels.levels.front().lists.groups()} * Stencil::lanes ||
        levels.shifts.size() != levels.constants.size() || !are_from_zero(levels.shifts.span()) ||
        !std::ranges::all_of(levels.constants, [](double sum) { return std::isfinite(sum); }))
        return false;
    std::uint32_t fine = particles;
    std::size_t springs = levels.slots.size() * Stencil::lanes;
    for (const CoarseLevel::Constants& level : levels.levels) {
        if (!fits_level(level, fine, springs)) return false;
        fine = level.interpolation.coarse;
        springs = std::size_t{level.lists.groups()} * Stencil::lanes;
    }
    return true;
}

std::unique_ptr<Multigrid> make_levels(const ClothModel& model, ImplicitSystem& system, SavedLevels* saved) {
    if (saved != nullptr && (saved->springs || fit(*saved, model.particle_count, system.entries())))
        return std::make_unique<Multigrid>(system, std::move(*saved), model.particle_count);
    const AlignedBuffer<Vec4> positions = linearise_at_rest(model, system);
    Parallel serial(1);
    return std::make_unique<Multigrid>(serial, system, positions.span());
}

AlignedBuffer<Vec4> linearise_at_rest(const ClothModel& model, ImplicitSystem& system) {
    Parallel serial(1);
    const ClothSettings settings;
    const AlignedBuffer<Vec4> at_rest(model.particle_count);
    AlignedBuffer<Vec4> free(model.particle_count);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const float mass = settings.fabric.areal_density * model.rest_area[i];
        free[i] = to_vec4(xyz(model.positions[i]), mass > 0 ? 1.0f / mass : 0.0f);
    }
    const StepEquation equation{.settings = settings,
                                .h = 1.0f / 60,
                                .gamma = 1.0f / 60,
                                .rigidity = settings.fabric.bending,
                                .positions = free.span(),
                                .velocities = at_rest.span(),
                                .base_positions = free.span(),
                                .base_velocities = at_rest.span(),
                                .external = {}};
    system.linearise(serial, equation, at_rest.span(), LinearisedAbout::base);
    return free;
}

}  // namespace weft
