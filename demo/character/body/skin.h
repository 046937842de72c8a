#pragma once
// The outside of a body as closed triangles that follow its skeleton: drawn, and met by cloth.

#include "demo/character/body/binding.h"
#include "weft/mesh.h"

namespace weft::demo {

class Skin {
  public:
    Skin() = default;
    /// Round all limbs of a body of this girth (Fit), bound to the nearest; limbs are joined where they meet
    /// in a stance with arms and legs apart. Cut from cells of this size [m], which is to be less than the
    /// thinnest limb is thick, by tetrahedra (Doi, Koide, "An efficient method of triangulating
    /// equi-valued surfaces by using tetrahedral cells", 1991): closed whatever the limbs are.
    [[nodiscard]] static Skin round_limbs(const Body& body, const Skeleton& skeleton, float girth = 1,
                                          float cell = 0.03f);
    /// As a file has it. Error: by_weights'.
    [[nodiscard]] static Result<Skin> by_weights(const Mesh& mesh, const Pose& pose,
                                                 std::span<const std::uint32_t> joints,
                                                 std::span<const float> weights);

    [[nodiscard]] std::size_t size() const { return binding_.size(); }  ///< vertices; 0: there is none
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Writes where the pose takes each vertex [m]; of a body that is still growing, from its limbs' axes
    /// that part of the way. Preconditions: `limbs` as Body::place() puts them, `to` has size() elements.
    void place(const Pose& pose, const std::vector<TaperedCapsule>& limbs, float growth,
               std::span<Vec3> to) const;

  private:
    /// Of a limb's axis, next to a vertex.
    struct Core {
        std::size_t limb;
        float along;  // from its end a, 0, to its end b, 1
    };
    std::vector<Triangle> triangles_;
    Binding binding_;
    std::vector<Core> cores_;  // none: it does not grow
};

}  // namespace weft::demo
