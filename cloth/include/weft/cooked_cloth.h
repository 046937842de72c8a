#pragma once
// A cloth that is cooked once and added to Worlds any number of times.

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

/// Counts and sizes of a cooked cloth.
struct ClothInfo {
    std::uint32_t vertices = 0;         ///< vertices of the input mesh
    std::uint32_t particles = 0;        ///< distinct vertices after welding
    std::uint32_t welded_vertices = 0;  ///< vertices that share an earlier vertex's particle
    std::uint32_t triangles = 0;
    std::uint32_t components = 0;
    std::uint32_t structural_springs = 0, shear_springs = 0;
    std::uint32_t bending_elements =
        0;                           ///< sheet: triples along threads, and cells; mesh: up to 3 a particle
    std::uint32_t border_edges = 0;  ///< edges of one triangle
    std::uint32_t dropped_triangles = 0;   ///< warning: triangles left out, see DropReason
    std::uint32_t turned_triangles = 0;    ///< warning: triangles turned to be wound as their neighbours
    std::uint32_t flipped_triangles = 0;   ///< slivers and neighbours with an edge flipped
    std::uint32_t softened_triangles = 0;  ///< warning: slivers that are less stiff than the fabric
    std::uint32_t misoriented_edges = 0;   ///< warning: shared edges whose two triangles stay wound against
                                           ///< each other, as on a Moebius strip
    std::uint32_t loose_particles =
        0;                ///< warning: particles of no triangle; they have no mass and stay where they are
    float mean_edge = 0;  ///< mean rest length of structural springs [m]
    float mass = 0;       ///< [kg]
    /// Least flexural rigidity that the mesh resolves [N m]; a warning where Fabric::bending is lower. Folds
    /// then want to be finer than the triangles, so the mesh, not the fabric, sets their number. Use a finer
    /// mesh, or at least this rigidity.
    ///
    /// Weight bends cloth over a length s at which its moment, areal_density g s^2, equals the bending moment
    /// at radius s, B / s. So s = (B / (areal_density g))^(1/3), g = 9.81 m/s^2. A fold's tip, half a circle
    /// of radius s, should be at least six edges long: s >= 2 mean_edge.
    float least_bending = 0;
    /// Memory of this cloth, solver included, within 1 %. Each step reuses it. Tethers to up to four holds
    /// take 8 bytes a particle each.
    std::uint64_t bytes = 0;
    /// Further memory, shared with all cloths of its CookedCloth and counted once for all of them. 0 for a
    /// cloth that was added by its mesh. A change of settings may give a cloth its own copy of shared data.
    std::uint64_t shared_bytes = 0;
    /// The part of `bytes` that only a step needs. Cloths share it: a World with n threads has it for the n
    /// largest cloths. Cloths with contact between features each add theirs, as do all in a World with
    /// bodies.
    std::uint64_t scratch_bytes = 0;
    friend bool operator==(const ClothInfo&, const ClothInfo&) = default;
};

/// Why a triangle is left out. Triangles are added in the mesh's order, unless one of these applies.
enum class DropReason : std::uint32_t {
    no_area,         ///< height below a millionth of the longest side, or area below 1e-14 m^2; see flipped
    doubled,         ///< the same three vertices, after welding, as an earlier triangle's
    crowded_edge,    ///< a third triangle at an edge, which bends between two
    crowded_vertex,  ///< another triangle at a vertex that has 1024
};

/// Repairs that cooking made to a mesh, item by item. All lists ascend.
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
    /// A sliver (height below 1/10 of its longest side) that no edge flip could repair. At full stiffness its
    /// springs would be over five times as stiff as the membrane, and rounding would make them pull at
    /// random. `left` is the fraction of stiffness left across the longest side, above 0 and below 1; along
    /// that side it is full. A finite element keeps the same fraction, or more, in all directions.
    struct Softened {
        std::uint32_t triangle;
        float left;
        friend bool operator==(const Softened&, const Softened&) = default;
    };
    std::vector<Welded> welded;
    std::vector<Dropped> dropped;
    /// Triangles whose winding was reversed. Of triangles that edges join, those with the smaller total area
    /// are turned; of equal areas, those that disagree with the first triangle.
    std::vector<std::uint32_t> turned;
    /// Triangles whose corners differ from the mesh's. The edge between a sliver, even one without area, and
    /// its neighbour across the longest side is flipped where that makes both sounder. A T-junction that a
    /// sliver closes therefore stays closed. The surface moves by less than the sliver's height. Edges at
    /// seams and in grids are not flipped.
    std::vector<std::uint32_t> flipped;
    std::vector<Softened> softened;    ///< slivers that no edge flip could repair, as at borders
    std::vector<std::uint32_t> loose;  ///< vertices of no remaining triangle

    friend bool operator==(const CookReport&, const CookReport&) = default;
};

/// Progress of cooking, for the host to display. `report` runs on the thread that cooks, and must not throw.
struct CookProgress {
    void* user = nullptr;  ///< passed to `report`
    /// `done` grows from above 0 to 1; 1 is reported last. Returning false cancels the cooking, unless `done`
    /// is 1. There are a handful of calls, between stages: a stage that has begun is completed.
    bool (*report)(void* user, float done) = nullptr;
};

/// The constant data of a cloth, and one cloth at rest. Cooking takes a frame or more: it may run on any
/// thread, for many meshes at a time, and its result can be read back from a file. Copies share their data;
/// one may be added to Worlds on several threads at a time.
class WEFT_API CookedCloth {
  public:
    /// Cooks a mesh. Defects are repaired or left out as CookReport lists them. Errors, which name the vertex
    /// or the triangle: a setting out of range; coordinates that are not finite or beyond 100 km; indices of
    /// no vertex; no triangle left; rows and columns that describe no grid, each cell of which has two
    /// triangles; ErrorCode::cancelled, if `progress` returned false.
    [[nodiscard]] static Result<CookedCloth> create(const Mesh& mesh, const ClothSettings& settings = {},
                                                    const CookProgress& progress = {});

    /// Figures of a cloth that is added by its mesh. A CookedCloth from create() holds one such cloth
    /// besides; a loaded one holds little more than what all cloths share.
    [[nodiscard]] const ClothInfo& info() const noexcept;
    [[nodiscard]] const CookReport& report() const noexcept;

    /// Number of bytes that save() writes. They hold the cooked mesh, the constant parts of its method with
    /// all coarse levels, those of its contact, and the report, but no settings. They are little-endian, with
    /// a version and a checksum.
    [[nodiscard]] std::size_t save_size() const noexcept;
    /// Error: `to` has another size than save_size().
    Result<void> save(std::span<std::byte> to) const;
    /// Reads a saved cloth; the bytes may be at any address, and are copied once. Loading only checks them if
    /// the settings have the cooking's method, force model, SelfCollision, and Fabric::warp, weft, shear and
    /// stiffening. A difference in these four costs up to a third of cooking; another method, force model or
    /// Fabric::bending_ratio costs most of it. Errors: a setting out of range; bytes that are no such save,
    /// of another version, cut short or damaged.
    [[nodiscard]] static Result<CookedCloth> load(std::span<const std::byte> saved,
                                                  const ClothSettings& settings = {});

    /// Like load(), but uses bytes at an address that is a multiple of 64, as a mapped file's is, in place,
    /// and only reads them. `owner` keeps them unchanged until the last cloth is gone. At another address, or
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
