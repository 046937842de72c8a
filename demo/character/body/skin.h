#pragma once
// A body's surface as triangles that follow its skeleton. It is drawn, and cloth collides with it.

#include "demo/character/body/binding.h"
#include "weft/mesh.h"

namespace weft::demo {

class Skin {
  public:
    Skin() = default;
    /// A surface round all limbs of a body of this girth (Fit), bound to the nearest limbs. It joins limbs
    /// that overlap in a stance with arms and legs apart. Marching tetrahedra (Doi, Koide, "An efficient
    /// method of triangulating equi-valued surfaces by using tetrahedral cells", 1991) close it for any
    /// limbs. `cell` is the grid's spacing [m]; it must be less than the thinnest limb's thickness.
    [[nodiscard]] static Skin round_limbs(const Body& body, const Skeleton& skeleton, float girth = 1,
                                          float cell = 0.03f);
    /// A skin of a file's triangles, joints and weights. Error: Binding::by_weights()'s.
    [[nodiscard]] static Result<Skin> by_weights(const Mesh& mesh, const Pose& pose,
                                                 std::span<const std::uint32_t> joints,
                                                 std::span<const float> weights);

    [[nodiscard]] std::size_t size() const { return binding_.size(); }  ///< vertices; 0: no skin
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Writes each vertex's position in the pose [m]. Growth scales its distance from the limb's axis.
    /// Preconditions: `limbs` as Body::place() writes them, `to` has size() elements.
    void place(const Pose& pose, const std::vector<TaperedCapsule>& limbs, float growth,
               std::span<Vec3> to) const;

  private:
    /// The point on the nearest limb's axis that is nearest to a vertex.
    struct Core {
        std::size_t limb;
        float along;  // 0 at its end a to 1 at its end b
    };
    std::vector<Triangle> triangles_;
    Binding binding_;
    std::vector<Core> cores_;  // by vertex; empty: growth has no effect
};

}  // namespace weft::demo
