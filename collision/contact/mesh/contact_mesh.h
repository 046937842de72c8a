#pragma once
// The part of a mesh that stays constant while it moves, for detection: its features, and their division
// among patches.

#include <array>
#include <cstdint>
#include <span>

#include "collision/contact/mesh/flat_rest.h"
#include "engine/memory/shared_buffer.h"
#include "weft/types.h"

namespace weft {

/// Features of one kind, by their corners, in groups of sixteen slots. One patch owns the first slots of a
/// group. The others are padding, and repeat a particle of the mesh.
template <std::uint32_t corner_count>
struct FeatureSlots {
    std::array<SharedBuffer<std::uint32_t>, corner_count> corners;

    [[nodiscard]] std::uint32_t groups() const noexcept {
        return static_cast<std::uint32_t>(corners[0].size() / 16);
    }
    [[nodiscard]] std::size_t bytes() const noexcept { return corner_count * corners[0].bytes(); }
};

/// Slots [first, first + count) of one kind of feature. `first` is a multiple of 16.
struct SlotSpan {
    std::uint32_t first, count;
};

/// The features that one patch owns.
struct ContactPatch {
    static constexpr std::uint32_t most_vertices = 16, most_triangles = 64, most_edges = 96;

    SlotSpan vertices, triangles, edges;
    SlotSpan corners;  ///< corners of all of these, each particle once
};

/// The constant part of a body in contact. Vertices without a triangle are left out, and so are triangles and
/// edges of which two corners are one particle.
class ContactMesh {
  public:
    using Triangle = std::array<std::uint32_t, 3>;  ///< particles
    using Edge = std::array<std::uint32_t, 2>;      ///< particles, the lower number first

    /// Precondition: triangles are indices into rest_positions. Positions that are not finite count as the
    /// origin: positions only decide how long a search takes.
    ContactMesh(std::span<const Vec4> rest_positions, std::span<const Triangle> triangles);

    /// An empty mesh, to be read into by for_each_list().
    ContactMesh() = default;
    /// Calls visit(list) and visit.value(number) for all members.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.particles_);
        visit.value(self.least_height_);
        visit(self.triangles_);
        visit(self.edges_);
        visit(self.corner_starts_);
        visit(self.corner_triangles_);
        visit(self.patches_);
        const auto visit_slots = [&](auto& slots) {
            for (auto& corner : slots.corners) visit(corner);
        };
        visit_slots(self.vertex_slots_);
        visit_slots(self.triangle_slots_);
        visit_slots(self.edge_slots_);
        visit_slots(self.corner_slots_);
        FlatRest::for_each_list(self.flat_rest_, visit);
    }
    /// Whether all indices in lists that were read are valid, for so many particles.
    [[nodiscard]] bool is_sound(std::uint32_t particle_count) const;

    [[nodiscard]] std::uint32_t particles() const noexcept { return particles_; }
    [[nodiscard]] std::span<const Triangle> triangles() const noexcept { return triangles_.span(); }
    /// Every edge once, in ascending order.
    [[nodiscard]] std::span<const Edge> edges() const noexcept { return edges_.span(); }
    /// Indices in triangles() of the triangles that have the particle as a corner, ascending.
    [[nodiscard]] std::span<const std::uint32_t> triangles_of(std::uint32_t particle) const noexcept {
        const std::uint32_t begin = corner_starts_[particle];
        return corner_triangles_.span().subspan(begin, corner_starts_[particle + 1] - begin);
    }
    /// The least height of a triangle at rest [m]: the features of a sliver are always that near.
    [[nodiscard]] float least_height() const noexcept { return least_height_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

    /// Every vertex of a triangle, every triangle and every edge belongs to one patch. Patches that follow
    /// one another lie together.
    [[nodiscard]] std::span<const ContactPatch> patches() const noexcept { return patches_.span(); }
    [[nodiscard]] const FeatureSlots<1>& vertex_slots() const noexcept { return vertex_slots_; }
    [[nodiscard]] const FeatureSlots<3>& triangle_slots() const noexcept { return triangle_slots_; }
    [[nodiscard]] const FeatureSlots<2>& edge_slots() const noexcept { return edge_slots_; }
    [[nodiscard]] const FeatureSlots<1>& corner_slots() const noexcept { return corner_slots_; }
    [[nodiscard]] const FlatRest& flat_rest() const noexcept { return flat_rest_; }

  private:
    /// Divides the features among patches; `vertices` are in the order of patches.
    void share_out(std::span<const Vec4> rest_positions, std::span<const std::uint32_t> vertices);
    void find_corners();

    std::uint32_t particles_ = 0;
    float least_height_ = 0;
    SharedBuffer<Triangle> triangles_;
    SharedBuffer<Edge> edges_;
    SharedBuffer<std::uint32_t> corner_starts_, corner_triangles_;  // by particle
    SharedBuffer<ContactPatch> patches_;
    FeatureSlots<1> vertex_slots_;
    FeatureSlots<3> triangle_slots_;
    FeatureSlots<2> edge_slots_;
    FeatureSlots<1> corner_slots_;
    FlatRest flat_rest_;
};

}  // namespace weft
