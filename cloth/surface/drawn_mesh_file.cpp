// A DrawnMesh as bytes: a head, then the bonds as they lie in memory.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "cloth/surface/drawn_bonds.h"
#include "engine/memory/without_exceptions.h"
#include "engine/state_hash.h"

namespace weft {

namespace {

static_assert(std::endian::native == std::endian::little, "bonds are copied as they lie in memory");

/// Raised with each change of the format below, or of update()'s formula.
constexpr std::uint32_t drawn_version = 1;
constexpr std::array<char, 8> drawn_mark = {'W', 'E', 'F', 'T', 'D', 'R', 'A', 'W'};

struct DrawnHead {
    std::array<char, 8> mark = drawn_mark;
    std::uint32_t version = drawn_version;
    std::uint32_t particles = 0, triangles = 0;  ///< of the cloth
    std::uint32_t rounding = 0;                  ///< the float's bits
    std::uint64_t mesh_hash = 0;
    std::uint64_t vertices = 0;
    std::uint64_t hash = 0;  ///< of the head with 0 here, and of the bonds
    std::array<std::uint64_t, 2> unused{};
};
static_assert(std::has_unique_object_representations_v<DrawnHead> && sizeof(DrawnHead) == 64);

Error refused_bonds(const std::string& why) {
    return {ErrorCode::malformed_file, "the saved drawn mesh " + why};
}

std::uint64_t hash_of(DrawnHead head, std::span<const std::byte> bonds) {
    head.hash = 0;
    StateHash hash;
    hash.add(head);
    hash.add(bonds);
    return hash.value();
}

Result<DrawnHead> read_head(std::span<const std::byte> saved) {
    DrawnHead head;
    if (saved.size() < sizeof head) return refused_bonds("is cut short: it has no head");
    std::memcpy(&head, saved.data(), sizeof head);
    if (head.mark != drawn_mark) return refused_bonds("is none of Weft's: it does not begin with WEFTDRAW");
    if (head.version != drawn_version)
        return refused_bonds("has version " + std::to_string(head.version) + "; this library reads version " +
                             std::to_string(drawn_version) + ": bind the mesh again");
    const std::size_t bytes = saved.size() - sizeof head;
    if (bytes % sizeof(DrawnBond) != 0 || bytes / sizeof(DrawnBond) != head.vertices)
        return refused_bonds("is of " + std::to_string(head.vertices) +
                             " vertices, which take 64 bytes each; " + std::to_string(bytes) +
                             " bytes follow its head");
    if (hash_of(head, saved.subspan(sizeof head)) != head.hash)
        return refused_bonds("is damaged: its checksum is another");
    return head;
}

Result<void> check_mesh(const BoundMesh& saved, const BoundMesh& own) {
    if (saved == own) return {};
    const std::string end = ": bind it to this cloth";
    if (saved.particles == own.particles && saved.triangles == own.triangles)
        return refused_bonds("is bound to other triangles than the cloth has" + end);
    return refused_bonds("is bound to a cloth of " + std::to_string(saved.particles) + " particles and " +
                         std::to_string(saved.triangles) + " triangles; this one has " +
                         std::to_string(own.particles) + " and " + std::to_string(own.triangles) + end);
}

bool is_sound(const DrawnBond& bond, std::uint32_t particles) {
    bool sound = bond.second >= 0 && bond.third >= 0 && bond.second + bond.third <= 1.0001f &&
                 std::isfinite(bond.tangent[0]) && std::isfinite(bond.tangent[1]) &&
                 std::abs(bond.handedness) == 1;
    for (std::size_t c = 0; c < 3; ++c)
        sound = sound && bond.particles[c] < particles && std::isfinite(bond.offset[c]) &&
                std::abs(bond.normal[c]) <= 1.0001f;
    return sound;
}

}  // namespace

BoundMesh::BoundMesh(const ClothView& cloth)
    : particles(static_cast<std::uint32_t>(cloth.positions.size())),
      triangles(static_cast<std::uint32_t>(cloth.triangles.size())) {
    StateHash of_triangles;
    of_triangles.add(cloth.triangles);
    hash = of_triangles.value();
}

std::size_t DrawnMesh::save_size() const noexcept {
    return sizeof(DrawnHead) + size() * sizeof(DrawnBond);
}

Result<void> DrawnMesh::save(std::span<std::byte> to) const {
    return without_exceptions([&]() -> Result<void> {
        if (to.size() != save_size())
            return Error{ErrorCode::invalid_argument, "the span has " + std::to_string(to.size()) +
                                                          " bytes; the drawn mesh takes " +
                                                          std::to_string(save_size())};
        DrawnHead head{.particles = bonds_->mesh.particles, .triangles = bonds_->mesh.triangles};
        head.rounding = std::bit_cast<std::uint32_t>(bonds_->rounding);
        head.mesh_hash = bonds_->mesh.hash;
        head.vertices = size();
        const auto bonds = std::as_bytes(std::span(bonds_->without_blend()));
        head.hash = hash_of(head, bonds);
        std::memcpy(to.data(), &head, sizeof head);
        std::ranges::copy(bonds, to.begin() + sizeof head);
        return {};
    });
}

Result<DrawnMesh> DrawnMesh::load(std::span<const std::byte> saved, const ClothView& cloth) {
    return without_exceptions([&]() -> Result<DrawnMesh> {
        const auto head = read_head(saved);
        if (!head) return head.error();
        auto bonds = std::make_unique<Bonds>();
        bonds->mesh.particles = head->particles;
        bonds->mesh.triangles = head->triangles;
        bonds->mesh.hash = head->mesh_hash;
        bonds->rounding = std::bit_cast<float>(head->rounding);
        if (auto fits = check_mesh(bonds->mesh, BoundMesh(cloth)); !fits) return fits.error();
        bonds->of_vertex.resize(head->vertices);
        const auto to = std::as_writable_bytes(std::span(bonds->of_vertex));
        std::ranges::copy(saved.subspan(sizeof(DrawnHead)), to.begin());
        const bool sound = bonds->rounding >= 0 && bonds->rounding <= 1 &&
                           std::ranges::all_of(bonds->of_vertex, [&](const DrawnBond& bond) {
                               return is_sound(bond, head->particles);
                           });
        if (!sound) return refused_bonds("is not whole, though its checksum is right: bind the mesh again");
        return DrawnMesh(std::move(bonds));
    });
}

}  // namespace weft
