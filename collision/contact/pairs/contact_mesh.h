#pragma once
// What detection needs of a mesh that moves but does not change: its features, and how they are shared out
// among patches.

#include <array>
#include <cstdint>
#include <span>

#include "collision/contact/pairs/flat_rest.h"
#include "engine/memory/shared_buffer.h"
#include "weft/types.h"

namespace weft {

/// Features of one kind, by their corners: slots in groups of sixteen, of which one patch owns the first few.
/// Spare slots repeat a particle of the mesh.
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
    SlotSpan corners;  ///< of all of these, each particle once
};

/// The constant part of a body in contact. Vertices without a triangle have no part in it, and neither have
/// triangles and edges of which two corners are one particle.
class ContactMesh {
  public:
    using Triangle = std::array<std::uint32_t, 3>;  ///< particles
    using Edge = std::array<std::uint32_t, 2>;      ///< particles, the lower number first

    /// Precondition: triangles name rest_positions. These, if not finite, count as the origin: they decide
    /// how long a search takes and nothing else.
    ContactMesh(std::span<const Vec4> rest_positions, std::span<const Triangle> triangles);

    /// An empty one, to be read into.
    ContactMesh() = default;
    /// visit(list) and visit.value(number) for all of it.
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
    /// Whether lists that were read name only what there is, for so many particles.
    [[nodiscard]] bool is_sound(std::uint32_t particle_count) const;

    [[nodiscard]] std::uint32_t particles() const noexcept { return particles_; }
    [[nodiscard]] std::span<const Triangle> triangles() const noexcept { return triangles_.span(); }
    /// Each once, in ascending order.
    [[nodiscard]] std::span<const Edge> edges() const noexcept { return edges_.span(); }
    /// The triangles that have the particle for a corner, by their places in triangles(), ascending.
    [[nodiscard]] std::span<const std::uint32_t> triangles_of(std::uint32_t particle) const noexcept {
        const std::uint32_t begin = corner_starts_[particle];
        return corner_triangles_.span().subspan(begin, corner_starts_[particle + 1] - begin);
    }
    /// The least height of a triangle at rest [m]: features of slivers are as near as that for ever.
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
    /// Among patches, of vertices in this order.
    void share_out(std::span<const Vec4> rest_positions, std::span<const std::uint32_t> vertices);
    void find_corners();

    std::uint32_t particles_ = 0;
    float least_height_ = 0;
    SharedBuffer<Triangle> triangles_;
    SharedBuffer<Edge> edges_;
    SharedBuffer<std::uint32_t> corner_starts_, corner_triangles_;  // of particles
    SharedBuffer<ContactPatch> patches_;
    FeatureSlots<1> vertex_slots_;
    FeatureSlots<3> triangle_slots_;
    FeatureSlots<2> edge_slots_;
    FeatureSlots<1> corner_slots_;
    FlatRest flat_rest_;
};

}  // namespace weft
