// A CookedCloth as bytes: a head, then the model's lists and the report's, those of its surface, of its
// solver and of its contact, packed as they are used: see engine/memory/packed_lists.h.

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cloth/mesh/coordinates.h"
#include "cloth/mesh/mesh_limits.h"
#include "cloth/settings/validate.h"
#include "cloth/store/cooked_cloth.h"
#include "engine/memory/list_checks.h"
#include "engine/memory/packed_lists.h"
#include "engine/memory/without_exceptions.h"
#include "engine/state_hash.h"

namespace weft {

namespace {

static_assert(std::endian::native == std::endian::little, "lists are copied as they lie in memory");

/// Raised with each change of the format below, or of how meshes are cooked.
constexpr std::uint32_t cooked_version = 12;
constexpr std::array<char, 8> cooked_mark = {'W', 'E', 'F', 'T', 'C', 'O', 'O', 'K'};

struct CookedHead {
    std::array<char, 8> mark = cooked_mark;
    std::uint32_t version = cooked_version;
    std::uint32_t particles = 0, rows = 0, columns = 0;
    std::uint32_t has_levels = 0;
    std::uint32_t has_contact_mesh = 0, has_neighbours = 0;
    std::uint32_t has_neighbours_of_features = 0;  ///< those by contact's rule rather than by avoidance's
    std::uint32_t bending_ratio = 0;               ///< the float's bits
    std::uint32_t unused = 0;
    std::uint64_t bytes = 0;  ///< of the whole file
    std::uint64_t hash = 0;   ///< of the head with 0 here, and of all behind it, in pieces
};
static_assert(std::has_unique_object_representations_v<CookedHead>);
static_assert(sizeof(CookedHead) == memory_alignment, "lists begin behind it");
static_assert(sizeof(ClothInfo) == 96, "without padding");

/// Calls visit(list) for each list of the model and the report; `info` is a list of one item.
template <class Model, class Info, class Report, class Visit>
void for_each_list(Model& model, Info& info, Report& report, Visit& visit) {
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
    visit(report.flipped);
    visit(report.softened);
    visit(report.loose);
}

Error refused(const std::string& why) {
    return {ErrorCode::malformed_file, "the cooked cloth " + why};
}

/// Hash of a head, its own hash taken as 0, and of the bytes behind it, each piece after prepare(at, piece).
template <class Prepare>
std::uint64_t hash_of(CookedHead head, std::span<const std::byte> behind, const Prepare& prepare) {
    constexpr std::size_t piece = std::size_t{1} << 16;
    head.hash = 0;
    StateHash hash;
    hash.add(head);
    for (std::size_t at = 0; at < behind.size(); at += piece) {
        const auto bytes = behind.subspan(at, std::min(piece, behind.size() - at));
        prepare(at, bytes);
        hash.add(bytes);
    }
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
    return head;
}

/// The bytes behind the head, and who owns them.
struct KeptBytes {
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;
};

/// Checks the checksum, and returns the bytes in place, or in a copy if they have no owner or are unaligned.
Result<KeptBytes> keep(const CookedHead& head, KeptBytes saved) {
    const bool is_aligned = reinterpret_cast<std::uintptr_t>(saved.bytes.data()) % memory_alignment == 0;
    std::uint64_t hash = 0;
    if (saved.owner && is_aligned) {
        hash = hash_of(head, saved.bytes, [](std::size_t /*at*/, auto /*piece*/) {});
    } else {
        const std::size_t size = saved.bytes.size();
        const std::shared_ptr<std::byte> copy(static_cast<std::byte*>(take_memory(size)),
                                              [size](std::byte* memory) { give_memory_back(memory, size); });
        hash = hash_of(head, saved.bytes, [&](std::size_t at, std::span<const std::byte> piece) {
            std::memcpy(copy.get() + at, piece.data(), piece.size());
        });
        saved = {{copy.get(), size}, copy};
    }
    if (hash != head.hash) return refused("is damaged: its checksum is another");
    return saved;
}

/// Whether a mesh could have led to the model's numbers.
bool are_sound(const ClothModel& model) {
    std::uint32_t bits = 0;
    for (const Vec4& p : model.positions) bits |= std::bit_cast<std::uint32_t>(p.w);
    return bits == 0 && model.bending_ratio >= least_bending_ratio &&
           model.bending_ratio <= greatest_bending_ratio && are_from_zero(model.rest_area.span()) &&
           are_from_zero(model.rest_lengths.span()) &&
           are_within(model.rest_lengths.span(), 4 * runaway_distance) && are_within(model.bending.span()) &&
           are_within(model.bending_excess.span()) && are_within(numbers_of<float>(model.texcoords)) &&
           are_within(numbers_of<float>(model.positions), runaway_distance) &&
           are_within(numbers_of<float>(model.panel_sides));
}

/// Whether rest areas of particles are ones that triangles can have, and 0 for loose particles. Precondition:
/// lists have their right sizes.
bool have_areas(const ClothModel& model) {
    constexpr float least = 0.3f * static_cast<float>(least_area);  // a third, rounded
    constexpr float most = 8 * runaway_distance * runaway_distance * most_triangles_at_particle;
    bool are_right = true;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const bool is_loose = model.corner_offsets[i] == model.corner_offsets[i + 1];
        const float area = model.rest_area[i];
        are_right &= is_loose ? area == 0 : area >= least && area <= most;
    }
    return are_right;
}

/// Whether the counts are those of the model, and the mean edge is no longer than a mesh can be.
bool is_of(const ClothInfo& info, const ClothModel& model) {
    return info.particles == model.particle_count && info.vertices == model.vertex_to_particle.size() &&
           info.triangles == model.triangles.size() &&
           info.components + std::size_t{1} == model.component_offsets.size() &&
           are_from_zero(std::span(&info.mean_edge, 1)) && info.mean_edge <= 4 * runaway_distance;
}

/// Whether the triangles listed for a particle have it at a corner, each listed once. Precondition: offsets
/// and numbers are within their lists.
bool have_their_corners(const ClothModel& model) {
    std::uint32_t wrong = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        std::uint32_t next = 0;
        for (std::uint32_t k = model.corner_offsets[i]; k < model.corner_offsets[i + 1]; ++k) {
            const std::uint32_t t = model.corner_triangles[k];
            const Triangle& triangle = model.triangles[t];
            wrong |= (triangle[0] != i) & (triangle[1] != i) & (triangle[2] != i) ? 1u : 0u;
            wrong |= t < next ? 1u : 0u;
            next = t + 1;
        }
    }
    return wrong == 0;
}

bool are_kinds(std::span<const SpringKind> kinds) {
    std::uint8_t most = 0;
    for (const SpringKind kind : kinds) most = std::max(most, static_cast<std::uint8_t>(kind));
    return most <= static_cast<std::uint8_t>(SpringKind::bending);
}

/// Whether each particle is in one component. Precondition: the numbers are within the lists.
bool are_components(const ClothModel& model) {
    std::vector<std::uint8_t> is_in(model.particle_count);
    std::uint32_t wrong = 0;
    for (const std::uint32_t i : model.component_particles) wrong |= std::exchange(is_in[i], 1);
    return wrong == 0;
}

/// Whether lists have matching sizes, and numbers in them are in range.
bool is_whole(const ClothModel& model) {
    const std::size_t n = model.particle_count, springs = model.neighbours.size(),
                      triangles = model.triangles.size(), vertices = model.vertex_to_particle.size();
    const bool has_sizes =
        n > 0 && n <= most_vertices && springs > 0 && model.positions.size() == n &&
        model.rest_area.size() == n && model.bending_excess.size() == n &&
        model.rest_lengths.size() == springs && model.kinds.size() == springs &&
        model.bending.size() == springs && triangles > 0 &&
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
           are_kinds(model.kinds.span()) && have_areas(model) && are_components(model) &&
           have_their_corners(model);
}

/// Visits all lists behind the head.
template <class Visit>
void visit_saved(const Cloth& cloth, const CookReport& report, const std::optional<SavedLevels>& levels,
                 Visit& visit) {
    const std::span<const ClothInfo> info(&cloth.model.info, 1);
    for_each_list(cloth.model, info, report, visit);
    TriangleGroups::for_each_list(cloth.surface.groups(), visit);
    if (levels) visit_lists(*levels, visit);
    if (cloth.contact_mesh) ContactMesh::for_each_list(*cloth.contact_mesh, visit);
    if (cloth.rest_neighbours) RestNeighbours::for_each_list(*cloth.rest_neighbours, visit);
}

/// What a CookedCloth is made of.
struct ReadCloth {
    ClothModel model;
    CookReport report;
    SavedCloth constants;
};

Result<ReadCloth> read(const CookedHead& head, const KeptBytes& bytes, const ClothSettings& settings) {
    PackedReader reader(bytes.bytes, bytes.owner);
    ClothModel model;
    model.particle_count = head.particles;
    model.rows = head.rows;
    model.columns = head.columns;
    model.bending_ratio = std::bit_cast<float>(head.bending_ratio);
    std::vector<ClothInfo> info;
    CookReport report;
    for_each_list(model, info, report, reader);
    TriangleGroups groups;
    TriangleGroups::for_each_list(groups, reader);
    const Error not_whole = refused("is not whole, though its checksum is right: cook the mesh again");
    if (!reader.is_sound() || info.size() != 1 || !is_whole(model) || !are_sound(model) ||
        !is_of(info[0], model))
        return not_whole;
    model.info = info[0];
    model.fingerprint = fingerprint_of(model);
    if (auto valid = validate_neighbours(model, settings); !valid) return valid.error();
    Surface surface(model, std::move(groups));
    if (!surface.is_sound(model.particle_count)) return not_whole;
    std::optional<SavedLevels> levels;
    if (head.has_levels != 0) {
        levels = read_levels(reader, model);
        if (!levels) return refused("has levels that are not whole: cook the mesh again");
    }
    std::shared_ptr<ContactMesh> contact_mesh;
    if (head.has_contact_mesh != 0) {
        contact_mesh = std::make_shared<ContactMesh>();
        ContactMesh::for_each_list(*contact_mesh, reader);
    }
    std::optional<RestNeighbours> neighbours;
    if (head.has_neighbours != 0) RestNeighbours::for_each_list(neighbours.emplace(), reader);
    if (!reader.fits() || (contact_mesh && !contact_mesh->is_sound(model.particle_count)) ||
        (neighbours && !neighbours->is_sound(model.particle_count)))
        return not_whole;
    const bool by_features = head.has_neighbours_of_features != 0;
    const bool has_its_bending = model.bending_ratio == settings.fabric.bending_ratio;
    if (!has_its_bending) model = with_bending_ratio(std::move(model), settings.fabric.bending_ratio);
    if (!has_its_bending || (levels && levels->kind != SystemKind(settings))) levels.reset();
    if (!has_features(settings.self_collision)) contact_mesh.reset();
    if (!has_its_bending || settings.self_collision.method == SelfCollisionMethod::off ||
        has_features(settings.self_collision) != by_features)
        neighbours.reset();
    return ReadCloth{std::move(model),
                     std::move(report),
                     {std::move(surface), std::move(levels), std::move(contact_mesh), std::move(neighbours)}};
}

}  // namespace

std::size_t CookedCloth::save_size() const noexcept {
    PackedSize size;
    visit_saved(impl_->cloth, impl_->report, impl_->levels, size);
    return sizeof(CookedHead) + size.bytes();
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
        const Cloth& cloth = impl_->cloth;
        head.bending_ratio = std::bit_cast<std::uint32_t>(model.bending_ratio);
        head.has_levels = impl_->levels ? 1 : 0;
        head.has_contact_mesh = cloth.contact_mesh ? 1 : 0;
        head.has_neighbours = cloth.rest_neighbours ? 1 : 0;
        head.has_neighbours_of_features = has_features(cloth.settings.self_collision) ? 1 : 0;
        head.bytes = bytes;
        const std::span<std::byte> behind = to.subspan(sizeof head);
        PackedWriter writer(behind);
        visit_saved(impl_->cloth, impl_->report, impl_->levels, writer);
        head.hash = hash_of(head, behind, [](std::size_t /*at*/, auto /*piece*/) {});
        std::memcpy(to.data(), &head, sizeof head);
        return {};
    });
}

Result<CookedCloth> CookedCloth::load(std::span<const std::byte> saved, const ClothSettings& settings) {
    return load_in_place(saved, nullptr, settings);
}

Result<CookedCloth> CookedCloth::load_in_place(std::span<const std::byte> saved,
                                               std::shared_ptr<const void> owner,
                                               const ClothSettings& settings) {
    return without_exceptions([&]() -> Result<CookedCloth> {
        if (const auto valid = validate(settings); !valid) return valid.error();
        const Result<CookedHead> head = read_head(saved);
        if (!head) return head.error();
        const auto kept = keep(*head, {saved.subspan(sizeof(CookedHead)), std::move(owner)});
        if (!kept) return kept.error();
        auto made = read(*head, *kept, settings);
        if (!made) return made.error();
        ReadCloth cloth = std::move(made).value();
        if (auto valid = validate_filling(cloth.model, settings); !valid) return valid.error();
        return CookedCloth(std::make_shared<const Impl>(std::move(cloth.model), std::move(cloth.report),
                                                        settings, std::move(cloth.constants)));
    });
}

}  // namespace weft
