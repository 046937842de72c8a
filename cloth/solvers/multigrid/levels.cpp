#include "cloth/solvers/multigrid/levels.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

#include "cloth/mesh/list_checks.h"

namespace weft {

namespace {

/// visit(list) for each list of one level.
template <class Level, class Visit>
void for_each_level_list(Level& level, const Visit& visit) {
    visit(level.lists.links);
    visit(level.lists.places);
    visit(level.lists.group_slots);
    visit(level.lists.fine_links.numbers);
    visit(level.lists.factors);
    visit(level.lists.fine_links.bases);
    visit(level.lists.fine_links.from_base);
    visit(level.lists.constants.offsets);
    visit(level.lists.constants.fine_links.numbers);
    visit(level.lists.constants.factors);
    visit(level.lists.constants.fine_links.bases);
    visit(level.lists.constants.fine_links.from_base);
    visit(level.interpolation.nodes);
    visit(level.interpolation.weights);
    visit(level.interpolation.kept);
}

template <class Saved, class Visit>
void for_each_list_of(Saved& saved, const Visit& visit) {
    visit(saved.slots);
    visit(saved.constant_links);
    visit(saved.constant_weights);
    for (auto& level : saved.levels) for_each_level_list(level, visit);
}

/// A list's items, and what fills them up to whole words.
std::size_t padded_bytes(std::size_t bytes) {
    return (bytes + 7) / 8 * 8;
}

struct LevelsHead {
    std::uint32_t kind, levels;
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

/// Takes lists, each behind its count.
class LevelReader {
  public:
    explicit LevelReader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class Number>
    [[nodiscard]] Number number() {
        Number value{};
        is_short_ = is_short_ || left_.size() < sizeof value;
        if (is_short_) return value;
        std::memcpy(&value, left_.data(), sizeof value);
        left_ = left_.subspan(sizeof value);
        return value;
    }
    template <class List>
    void take(List& list) {
        using Item = std::remove_cvref_t<decltype(list[0])>;
        static_assert(std::is_trivially_copyable_v<Item>);
        const auto all = number<std::uint64_t>();
        is_short_ = is_short_ || all > left_.size() / sizeof(Item);
        const std::size_t count = is_short_ ? 0 : static_cast<std::size_t>(all), bytes = count * sizeof(Item);
        is_short_ = is_short_ || padded_bytes(bytes) > left_.size();
        if (is_short_) return;
        if constexpr (std::is_same_v<List, std::vector<Item>>) {
            list.resize(count);
            if (bytes > 0) std::memcpy(list.data(), left_.data(), bytes);
        } else {
            list = List(AlignedBuffer<Item>::from_bytes(left_.first(bytes)));
        }
        left_ = left_.subspan(padded_bytes(bytes));
    }
    [[nodiscard]] bool fits() const { return !is_short_ && left_.empty(); }

  private:
    std::span<const std::byte> left_;
    bool is_short_ = false;
};

bool are_weights(std::span<const float> numbers) {
    return are_within(numbers, -1e6f, 1e6f);
}

bool are_links(const SharedBuffer<Link>& links, std::uint32_t nodes) {
    std::uint64_t before = 0;
    std::uint32_t wrong = 0;
    for (const Link& link : links) {
        const std::uint64_t now = (std::uint64_t{link.first} << 32 | link.second) + 1;
        wrong |= (link.first >= link.second ? 1u : 0u) | (link.second >= nodes ? 1u : 0u) |
                 (now <= before ? 1u : 0u);
        before = now;
    }
    return wrong == 0;
}

/// Whether base + each is below `end`.
bool are_near(std::span<const std::uint16_t> numbers, std::uint32_t base, std::size_t end) {
    if (numbers.empty()) return true;
    if (base >= end) return false;
    const auto most = static_cast<std::uint16_t>(std::min<std::size_t>(end - base - 1, 65535));
    std::uint16_t wrong = 0;
    for (const std::uint16_t number : numbers)
        wrong = static_cast<std::uint16_t>(wrong | (number > most ? 1u : 0u));
    return wrong == 0;
}

/// Whether so many terms, in rows as FineLinks::pack() is told, name links below `end`. Precondition: offsets
/// are within the terms.
bool are_fine_links(const FineLinks& links, std::span<const std::uint32_t> offsets, std::uint32_t width,
                    std::size_t terms, std::size_t end) {
    if (!links.is_packed()) return links.numbers.size() == terms && are_below(links.numbers.span(), end);
    if (!links.numbers.empty() || links.from_base.size() != terms || links.bases.size() + 1 != offsets.size())
        return false;
    const std::span<const std::uint16_t> from_base = links.from_base.span();
    for (std::size_t row = 0; row < links.bases.size(); ++row) {
        const std::size_t first = std::size_t{offsets[row]} * width;
        const auto of_row = from_base.subspan(first, std::size_t{offsets[row + 1]} * width - first);
        if (!are_near(of_row, links.bases[row], end)) return false;
    }
    return true;
}

/// `fine`: nodes of the finer level, which has so many springs and, of these, constants.
bool fits_level(const SavedLevels::Level& level, std::uint32_t fine, std::size_t springs,
                std::size_t constants) {
    const GalerkinLists& lists = level.lists;
    const Interpolation& p = level.interpolation;
    constexpr std::uint32_t lanes = Stencil::lanes;
    const std::size_t links = lists.links.size(), groups = lists.groups();
    const std::size_t weights = std::size_t{Interpolation::width} * Stencil::whole_groups(fine);
    return p.fine == fine && p.coarse > 0 && p.coarse <= fine / 2 && p.kept.size() == p.coarse &&
           p.nodes.size() == weights && p.weights.size() == weights && are_below(p.kept, fine) &&
           are_below(p.nodes.span(), p.coarse) && are_weights(p.weights) &&
           are_links(lists.links, p.coarse) && lists.places.size() == links &&
           are_below(lists.places.span(), groups * lanes) && lists.factors.size() % lanes == 0 &&
           are_offsets(lists.group_slots.span(), groups, lists.factors.size() / lanes) &&
           are_fine_links(lists.fine_links, lists.group_slots.span(), lanes, lists.factors.size(), springs) &&
           are_weights(lists.factors) &&
           are_offsets(lists.constants.offsets.span(), links, lists.constants.factors.size()) &&
           are_fine_links(lists.constants.fine_links, lists.constants.offsets.span(), 1,
                          lists.constants.factors.size(), constants) &&
           are_weights(lists.constants.factors);
}

}  // namespace

std::size_t written_size(const SavedLevels& levels) {
    std::size_t bytes = sizeof(LevelsHead) + levels.levels.size() * sizeof(std::uint64_t);
    for_each_list_of(levels, [&](const auto& list) {
        bytes += sizeof(std::uint64_t) + padded_bytes(list.size() * sizeof(list[0]));
    });
    return bytes;
}

void write(const SavedLevels& levels, std::span<std::byte> to) {
    std::ranges::fill(to, std::byte{});
    std::byte* at = to.data();
    const auto put = [&](const auto& value) {
        std::memcpy(at, &value, sizeof value);
        at += sizeof value;
    };
    put(LevelsHead{bits_of(levels.kind), static_cast<std::uint32_t>(levels.levels.size())});
    for (const SavedLevels::Level& level : levels.levels) {
        put(level.interpolation.fine);
        put(level.interpolation.coarse);
    }
    for_each_list_of(levels, [&](const auto& list) {
        const std::size_t bytes = list.size() * sizeof(list[0]);
        put(std::uint64_t{list.size()});
        if (bytes > 0) std::memcpy(at, list.data(), bytes);
        at += padded_bytes(bytes);
    });
}

std::optional<SavedLevels> read_levels(std::span<const std::byte> bytes) {
    LevelReader reader(bytes);
    const auto head = reader.number<LevelsHead>();
    if (head.levels > bytes.size() / sizeof(std::uint64_t)) return std::nullopt;
    SavedLevels levels;
    levels.kind = kind_of(head.kind);
    levels.levels.resize(head.levels);
    for (SavedLevels::Level& level : levels.levels) {
        level.interpolation.fine = reader.number<std::uint32_t>();
        level.interpolation.coarse = reader.number<std::uint32_t>();
    }
    for_each_list_of(levels, [&](auto& list) { reader.take(list); });
    if (!reader.fits()) return std::nullopt;
    return levels;
}

bool fit(const SavedLevels& levels, std::uint32_t particles, std::size_t entries) {
    if (levels.levels.empty())
        return levels.slots.empty() && levels.constant_links.empty() && levels.constant_weights.empty();
    if (levels.slots.empty() || !are_below(levels.slots, entries / Stencil::lanes) ||
        !std::ranges::is_sorted(levels.slots) || !are_links(levels.constant_links, particles) ||
        levels.constant_weights.size() != levels.constant_links.size() ||
        !are_weights(levels.constant_weights))
        return false;
    std::uint32_t fine = particles;
    std::size_t springs = levels.slots.size() * Stencil::lanes, constants = levels.constant_links.size();
    for (const SavedLevels::Level& level : levels.levels) {
        if (!fits_level(level, fine, springs, constants)) return false;
        fine = level.interpolation.coarse;
        springs = std::size_t{level.lists.groups()} * Stencil::lanes;
        constants = 0;
    }
    return true;
}

std::unique_ptr<Multigrid> make_levels(const ClothModel& model, ImplicitSystem& system, SavedLevels* saved) {
    if (saved != nullptr && fit(*saved, model.particle_count, system.entries()))
        return std::make_unique<Multigrid>(system, std::move(*saved), model.particle_count);
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
                                .positions = free.span(),
                                .velocities = at_rest.span(),
                                .base_positions = free.span(),
                                .base_velocities = at_rest.span(),
                                .external = {}};
    system.linearise(serial, equation, at_rest.span(), LinearisedAbout::base);
    return std::make_unique<Multigrid>(serial, system, free.span());
}

}  // namespace weft
