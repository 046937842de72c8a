// A CookedCloth as bytes: a head, then the model's lists and the report's, one behind the other, then levels.

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cloth/frame/cooked/cooked_cloth.h"
#include "cloth/frame/settings/validate.h"
#include "cloth/mesh/coordinates.h"
#include "cloth/mesh/list_checks.h"
#include "cloth/mesh/mesh_limits.h"
#include "engine/memory/without_exceptions.h"
#include "engine/state_hash.h"

namespace weft {

namespace {

static_assert(std::endian::native == std::endian::little, "lists are copied as they lie in memory");

/// Another number for each change of what follows, or of how meshes are cooked.
constexpr std::uint32_t cooked_version = 4;
constexpr std::array<char, 8> cooked_mark = {'W', 'E', 'F', 'T', 'C', 'O', 'O', 'K'};
constexpr std::size_t list_count = 22;

struct CookedHead {
    std::array<char, 8> mark = cooked_mark;
    std::uint32_t version = cooked_version;
    std::uint32_t particles = 0, rows = 0, columns = 0;
    std::array<std::uint64_t, list_count> items{};  ///< of each list
    std::uint64_t level_bytes = 0;                  ///< of the levels, at the end; 0: there are none
    std::uint64_t bytes = 0;                        ///< of all
    std::uint64_t hash = 0;                         ///< of the head with 0 here, and of all behind it
};
static_assert(std::has_unique_object_representations_v<CookedHead>);
static_assert(sizeof(ClothInfo) == 80, "without padding");

/// visit(list) for each list of numbers; `Info` is of one item.
template <class Model, class Info, class Report, class Visit>
void for_each_list(Model& model, Info& info, Report& report, const Visit& visit) {
    visit(info);
    visit(model.positions);
    visit(model.rest_area);
    visit(model.spring_offsets);
    visit(model.neighbours);
    visit(model.rest_lengths);
    visit(model.kinds);
    visit(model.bending);
    visit(model.bending_excess);
    visit(model.triangles);
    visit(model.panel_sides);
    visit(model.corner_offsets);
    visit(model.corner_triangles);
    visit(model.component_offsets);
    visit(model.component_particles);
    visit(model.vertex_to_particle);
    visit(model.texcoords);
    visit(model.vertex_triangles);
    visit(report.welded);
    visit(report.dropped);
    visit(report.turned);
    visit(report.loose);
}

Error refused(const std::string& why) {
    return {ErrorCode::malformed_file, "the cooked cloth " + why};
}

std::uint64_t hash_of(CookedHead head, std::span<const std::byte> behind) {
    head.hash = 0;
    StateHash hash;
    hash.add(head);
    hash.add(behind);
    return hash.value();
}

Result<CookedHead> read_head(std::span<const std::byte> saved) {
    CookedHead head;
    if (saved.size() < sizeof head) return refused("is cut short: it has no head");
    std::memcpy(&head, saved.data(), sizeof head);
    if (head.mark != cooked_mark) return refused("is none of Weft's: it does not begin with WEFTCOOK");
    if (head.version != cooked_version)
        return refused("has version " + std::to_string(head.version) + "; this library reads version " +
                       std::to_string(cooked_version) + ": cook the mesh again");
    if (head.bytes != saved.size())
        return refused("is of " + std::to_string(head.bytes) + " bytes, of which there are " +
                       std::to_string(saved.size()));
    if (head.level_bytes > saved.size() - sizeof head)
        return refused("says that more of it are levels than there are bytes");
    if (head.hash != hash_of(head, saved.subspan(sizeof head)))
        return refused("is damaged: its checksum is another");
    return head;
}

/// Takes lists from the bytes, and notes if these are too few.
class ListReader {
  public:
    ListReader(const CookedHead& head, std::span<const std::byte> bytes) : head_(head), left_(bytes) {}

    template <class List>
    void operator()(List& list) const {
        using Item = std::remove_cvref_t<decltype(list[0])>;
        static_assert(std::is_trivially_copyable_v<Item>);
        const std::uint64_t count = head_.items[next_++];
        if (count > left_.size() / sizeof(Item)) {
            is_short_ = true;
            return;
        }
        const std::span<const std::byte> bytes = left_.first(count * sizeof(Item));
        if constexpr (std::is_same_v<List, SharedBuffer<Item>>) {
            list = List(AlignedBuffer<Item>::from_bytes(bytes));
        } else {
            list = List(count);
            if (count > 0) std::memcpy(list.data(), bytes.data(), bytes.size());
        }
        left_ = left_.subspan(bytes.size());
    }
    /// Whether all bytes were needed, and no more.
    [[nodiscard]] bool fits() const { return !is_short_ && left_.empty(); }

  private:
    const CookedHead& head_;
    mutable std::span<const std::byte> left_;
    mutable std::size_t next_ = 0;
    mutable bool is_short_ = false;
};

/// All numbers of a list, whose items are made of them.
template <class Number, class Item>
std::span<const Number> numbers_of(const SharedBuffer<Item>& list) {
    static_assert(sizeof(Item) % sizeof(Number) == 0);
    return {reinterpret_cast<const Number*>(list.data()), list.size() * (sizeof(Item) / sizeof(Number))};
}

/// Numbers that a mesh could have led to.
bool are_sound(const ClothModel& model) {
    constexpr float most = std::numeric_limits<float>::max();
    std::uint32_t wrong = 0;
    for (const Vec4& p : model.positions) wrong |= p.w == 0 ? 0u : 1u;
    return wrong == 0 && are_within(model.rest_area.span(), 0, most) &&
           are_within(model.rest_lengths.span(), 0, most) && are_within(model.bending.span(), -most, most) &&
           are_within(model.bending_excess.span(), -most, most) &&
           are_within(numbers_of<float>(model.texcoords), -most, most) &&
           are_within(numbers_of<float>(model.positions), -runaway_distance, runaway_distance) &&
           are_within(numbers_of<float>(model.panel_sides), -most, most);
}

/// What it says of the mesh is so, as far as it can be seen here; edges are no longer than the mesh can be.
bool is_of(const ClothInfo& info, const ClothModel& model) {
    return info.particles == model.particle_count && info.vertices == model.vertex_to_particle.size() &&
           info.triangles == model.triangles.size() &&
           info.components + std::size_t{1} == model.component_offsets.size() &&
           are_within(std::span(&info.mean_edge, 1), 0, 4 * runaway_distance);
}

/// That triangles at a particle have it at a corner. Precondition: offsets and numbers are within their
/// lists.
bool have_their_corners(const ClothModel& model) {
    std::uint32_t wrong = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        for (std::uint32_t k = model.corner_offsets[i]; k < model.corner_offsets[i + 1]; ++k) {
            const Triangle& triangle = model.triangles[model.corner_triangles[k]];
            wrong |= (triangle[0] != i) & (triangle[1] != i) & (triangle[2] != i) ? 1u : 0u;
        }
    return wrong == 0;
}

/// Whether each particle is in one component. Precondition: the numbers are within the lists.
bool are_components(const ClothModel& model) {
    std::vector<std::uint8_t> is_in(model.particle_count);
    std::uint32_t wrong = 0;
    for (const std::uint32_t i : model.component_particles) wrong |= std::exchange(is_in[i], 1);
    return wrong == 0;
}

/// That no list names what another does not have.
bool is_whole(const ClothModel& model) {
    const std::size_t n = model.particle_count, springs = model.neighbours.size(),
                      triangles = model.triangles.size(), vertices = model.vertex_to_particle.size();
    const bool has_sizes =
        n > 0 && n <= most_vertices && model.positions.size() == n && model.rest_area.size() == n &&
        model.bending_excess.size() == n && model.rest_lengths.size() == springs &&
        model.kinds.size() == springs && model.bending.size() == springs && triangles > 0 &&
        (model.panel_sides.empty() || model.panel_sides.size() == triangles) &&
        model.component_particles.size() == n && !model.component_offsets.empty() && vertices >= n &&
        model.corner_triangles.size() == 3 * triangles &&
        (model.texcoords.empty() || model.texcoords.size() == vertices) &&
        (model.vertex_triangles.empty() || model.vertex_triangles.size() == triangles) &&
        (model.rows == 0 ? model.columns == 0 : std::uint64_t{model.rows} * model.columns == n);
    return has_sizes && are_offsets(model.spring_offsets.span(), n, springs) &&
           are_offsets(model.corner_offsets.span(), n, 3 * triangles) &&
           are_offsets(model.component_offsets.span(), model.component_offsets.size() - 1, n) &&
           are_below(model.neighbours.span(), n) && are_below(model.component_particles.span(), n) &&
           are_below(model.vertex_to_particle.span(), n) &&
           are_below(model.corner_triangles.span(), triangles) &&
           are_below(numbers_of<std::uint32_t>(model.triangles), n) &&
           are_below(numbers_of<std::uint32_t>(model.vertex_triangles), vertices) &&
           (!model.vertex_triangles.empty() || model.texcoords.empty() || vertices == n) &&
           std::ranges::all_of(model.kinds, [](SpringKind kind) { return kind <= SpringKind::bending; }) &&
           are_components(model) && have_their_corners(model);
}

}  // namespace

std::size_t CookedCloth::save_size() const noexcept {
    std::size_t bytes = sizeof(CookedHead);
    const std::span<const ClothInfo> info(&impl_->cloth.model.info, 1);
    for_each_list(impl_->cloth.model, info, impl_->report,
                  [&](const auto& list) { bytes += list.size() * sizeof(list[0]); });
    return bytes + (impl_->levels ? written_size(*impl_->levels) : 0);
}

Result<void> CookedCloth::save(std::span<std::byte> to) const {
    return without_exceptions([&]() -> Result<void> {
        const std::size_t bytes = save_size();
        if (to.size() != bytes)
            return Error{ErrorCode::invalid_argument, "the span has " + std::to_string(to.size()) +
                                                          " bytes; the cooked cloth takes " +
                                                          std::to_string(bytes)};
        const ClothModel& model = impl_->cloth.model;
        CookedHead head{.particles = model.particle_count, .rows = model.rows, .columns = model.columns};
        head.bytes = bytes;
        std::size_t at = sizeof head, list_number = 0;
        const std::span<const ClothInfo> info(&model.info, 1);
        for_each_list(model, info, impl_->report, [&](const auto& list) {
            const std::size_t size = list.size() * sizeof(list[0]);
            if (size > 0) std::memcpy(to.data() + at, list.data(), size);
            head.items[list_number++] = list.size();
            at += size;
        });
        head.level_bytes = bytes - at;
        if (impl_->levels) write(*impl_->levels, to.subspan(at));
        head.hash = hash_of(head, to.subspan(sizeof head));
        std::memcpy(to.data(), &head, sizeof head);
        return {};
    });
}

Result<CookedCloth> CookedCloth::load(std::span<const std::byte> saved, const ClothSettings& settings) {
    return without_exceptions([&]() -> Result<CookedCloth> {
        if (const auto valid = validate(settings); !valid) return valid.error();
        const Result<CookedHead> head = read_head(saved);
        if (!head) return head.error();
        ClothModel model;
        model.particle_count = head->particles;
        model.rows = head->rows;
        model.columns = head->columns;
        std::vector<ClothInfo> info;
        CookReport report;
        const std::size_t lists = saved.size() - sizeof(CookedHead) - head->level_bytes;
        const ListReader reader(*head, saved.subspan(sizeof(CookedHead), lists));
        for_each_list(model, info, report, reader);
        if (!reader.fits() || info.size() != 1 || !is_whole(model) || !are_sound(model) ||
            !is_of(info[0], model))
            return refused("is not whole, though its checksum is right: cook the mesh again");
        model.info = info[0];
        model.fingerprint = fingerprint_of(model);
        if (auto valid = validate_neighbours(model, settings); !valid) return valid.error();
        std::optional<SavedLevels> levels;
        if (head->level_bytes > 0) {
            levels = read_levels(saved.last(head->level_bytes));
            if (!levels) return refused("has levels that are not whole: cook the mesh again");
        }
        return CookedCloth(std::make_shared<const Impl>(std::move(model), std::move(report), settings,
                                                        Progress(), levels ? &*levels : nullptr));
    });
}

}  // namespace weft
