#pragma once
// Cloth made ready once, for as many cloths of Worlds as are wanted.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "weft/error.h"
#include "weft/export.h"
#include "weft/mesh.h"
#include "weft/settings.h"

namespace weft {

/// What cooking a mesh made of it.
struct ClothInfo {
    std::uint32_t vertices = 0;         ///< of the mesh that was given
    std::uint32_t particles = 0;        ///< after welding
    std::uint32_t welded_vertices = 0;  ///< whose particle is that of an earlier vertex
    std::uint32_t triangles = 0;
    std::uint32_t components = 0;
    std::uint32_t structural_springs = 0, shear_springs = 0;
    std::uint32_t bending_elements =
        0;  ///< threads' triples and cells of a sheet; up to three a particle of a mesh
    std::uint32_t border_edges = 0;        ///< edges of one triangle
    std::uint32_t dropped_triangles = 0;   ///< warning: left out, see DropReason
    std::uint32_t turned_triangles = 0;    ///< warning: wound the other way than their neighbours, and turned
    std::uint32_t flipped_triangles = 0;   ///< slivers, and their neighbours, that have other corners
    std::uint32_t softened_triangles = 0;  ///< warning: slivers that are less stiff than the fabric
    std::uint32_t misoriented_edges = 0;   ///< warning: shared edges whose two triangles stay wound against
                                           ///< each other, as on a Moebius strip
    std::uint32_t loose_particles =
        0;                ///< warning: particles of no triangle; they have no mass and stay where they are
    float mean_edge = 0;  ///< mean rest length of structural springs [m]
    float mass = 0;       ///< [kg]
    /// Warning where Fabric::bending is below it [N m]: folds want to be finer than the triangles, so that
    /// the mesh, not the fabric, says how many there are. Take a finer mesh, or so much bending.
    ///
    /// Weight bends cloth over the length s at which its moment, areal_density g s^2, is that of bending by a
    /// radius of s, B / s: s = (B / (areal_density g))^(1/3), g = 9.81 m/s^2. A fold's tip, half a circle of
    /// this radius, is to be no fewer than six edges long: s >= 2 mean_edge.
    float least_bending = 0;
    /// Memory of this cloth, solver included, within 1 %. Each step reuses it. Tethers to up to four holds
    /// take 8 bytes a particle each.
    std::uint64_t bytes = 0;
    /// Besides, the memory that it shares with all cloths of its CookedCloth: once for all of them. 0 for a
    /// cloth that was added by its mesh. Other settings may take a cloth of its own what it shared.
    std::uint64_t shared_bytes = 0;
    /// The part of `bytes` that only a step needs. Cloths share it: a World has it for as many cloths, the
    /// largest, as it has threads. Cloths with contact between features each add theirs, as do all in a World
    /// with bodies.
    std::uint64_t scratch_bytes = 0;
    friend bool operator==(const ClothInfo&, const ClothInfo&) = default;
};

/// Why a triangle is left out. Triangles are taken in the mesh's order, each if it has none of these.
enum class DropReason : std::uint32_t {
    no_area,         ///< lower than a millionth of its longest side, or smaller than 1e-14 m^2; see flipped
    doubled,         ///< of the same three vertices, once welded, as an earlier one
    crowded_edge,    ///< a third one at an edge, which bends between two
    crowded_vertex,  ///< another one at a vertex that has 1024
};

/// What cooking did to a mesh, item by item. All lists ascend.
struct CookReport {
    /// A vertex at exactly the position of an earlier one, whose particle it shares.
    struct Welded {
        std::uint32_t vertex, into;
        friend bool operator==(const Welded&, const Welded&) = default;
    };
    struct Dropped {
        std::uint32_t triangle;
        DropReason why;
        friend bool operator==(const Dropped&, const Dropped&) = default;
    };
    /// A sliver, a triangle lower than 1/10 of its longest side, that no flip made sound. Its springs would
    /// be over five times as stiff as the membrane, and pull at random, for rounding. `left` is the part of
    /// its stiffness that is left, above 0 and below 1, across the longest side; along it, all is. A finite
    /// element has the same part, or more, in all directions.
    struct Softened {
        std::uint32_t triangle;
        float left;
        friend bool operator==(const Softened&, const Softened&) = default;
    };
    std::vector<Welded> welded;
    std::vector<Dropped> dropped;
    /// Triangles that are now wound the other way. Of triangles that edges join, those turn that have less
    /// area than those that stay; of equal areas those stay that the first one agrees with.
    std::vector<std::uint32_t> turned;
    /// Triangles that have other corners than the mesh's. Between a sliver, even one without area, and its
    /// neighbour across the longest side the edge runs the other way, where that makes both sounder: so a
    /// T-junction that a sliver closes stays closed. The surface moves by less than the sliver's height. Not
    /// across seams, and not in grids.
    std::vector<std::uint32_t> flipped;
    std::vector<Softened> softened;    ///< slivers that no flip makes sound, as at borders
    std::vector<std::uint32_t> loose;  ///< vertices of no triangle that is left

    friend bool operator==(const CookReport&, const CookReport&) = default;
};

/// How far cooking is, for the host to show; it runs on the thread that cooks, and must not throw.
struct CookProgress {
    void* user = nullptr;  ///< handed back
    /// `done` grows from above 0 to 1, which comes last, when all is done; false ends the cooking there,
    /// unless it is 1. A handful of calls: a stage that begins is ended first.
    bool (*report)(void* user, float done) = nullptr;
};

/// All that of a cloth is constant, and one cloth at rest. Cooking takes a frame and more: it may be done on
/// any thread, for many meshes at a time, and be read back from a file. Copies share what they hold; one may
/// be added to Worlds on several threads at a time.
class WEFT_API CookedCloth {
  public:
    /// What a mesh may have is repaired or left out as CookReport lists it. Errors, which name the vertex or
    /// the triangle: a setting out of range; coordinates that are not finite or beyond 100 km; indices of no
    /// vertex; no triangle left; rows and columns of what is no grid, each cell of which has two triangles;
    /// ErrorCode::cancelled, where `progress` said so.
    [[nodiscard]] static Result<CookedCloth> create(const Mesh& mesh, const ClothSettings& settings = {},
                                                    const CookProgress& progress = {});

    /// As of a cloth that is added by its mesh. What create() made holds one besides; what was read holds
    /// little more than what all cloths share.
    [[nodiscard]] const ClothInfo& info() const noexcept;
    [[nodiscard]] const CookReport& report() const noexcept;

    /// How many bytes save() writes. They hold what the mesh was made into, the constant parts of its method
    /// with all coarse levels, those of its contact, and the report; the settings they do not hold. They are
    /// little-endian, with a version and a checksum.
    [[nodiscard]] std::size_t save_size() const noexcept;
    /// Error: another size than save_size().
    Result<void> save(std::span<std::byte> to) const;
    /// The bytes may be at any address; they are copied, once. With settings that have the cooking's method
    /// and force model, its Fabric's warp, weft, shear and stiffening, and its SelfCollision, nothing is made
    /// of them but checks; of these, the Fabric's four cost up to a third of cooking where they differ,
    /// another method, force model or Fabric::bending_ratio most of it. Errors: a setting out of range; what
    /// is no such save, of another version, cut short or damaged.
    [[nodiscard]] static Result<CookedCloth> load(std::span<const std::byte> saved,
                                                  const ClothSettings& settings = {});

    /// The same from bytes at a multiple of 64, as a mapped file's are: they are used where they lie, and
    /// only read. `owner` keeps them, as they are, until the last cloth is gone. At another address, or
    /// without an owner, they are copied.
    [[nodiscard]] static Result<CookedCloth> load_in_place(std::span<const std::byte> saved,
                                                           std::shared_ptr<const void> owner,
                                                           const ClothSettings& settings = {});

  private:
    friend class World;
    struct Impl;
    explicit CookedCloth(std::shared_ptr<const Impl> impl);
    std::shared_ptr<const Impl> impl_;
};

}  // namespace weft
