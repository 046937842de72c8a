#pragma once
// A person's drawn surface: one smooth mesh within the capsules that cloth meets.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "demo/character/figure/figure_field.h"
#include "weft/mesh.h"

namespace weft::demo {

/// Vertices follow the limbs by weights, and are then moved to the smooth union of the limbs in the same pose
/// (Vaillant et al., "Implicit skinning", 2013), so that bent joints keep their girth. What is still outside
/// of all limbs is moved to the surface of the nearest.
class Figure {
  public:
    Figure() = default;
    /// Meshes the limbs in a stance in which those that are not joined are apart. Hands, feet and head are
    /// meshed finer than the rest, which has edges of about `cell` [m]. Precondition: at most 32 limbs, each
    /// after the one that it grows from, and a sole before its foot.
    Figure(std::vector<FigureLimb> stance, float cell);
    [[nodiscard]] std::size_t size() const { return vertices_.size(); }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Writes each vertex's place [m]. Preconditions: the limbs of the stance, in their order, in any pose;
    /// `to` has size() elements.
    void place(std::span<const FigureLimb> limbs, std::span<Vec3> to) const;

    /// How much of a vertex is hair, shoe, or what a suit covers with and without sleeves: 0 to 1.
    struct Wear {
        float hair = 0, shoe = 0, suit = 0, sleeve = 0;
    };
    [[nodiscard]] std::span<const Wear> wear() const { return wear_; }

  private:
    static constexpr std::size_t most = 6;  // limbs that a vertex follows
    struct Vertex {
        std::array<std::uint8_t, most> limbs{};  // ascending
        std::array<float, most> weights{};       // sum to 1
        std::array<float, most> along{};         // place on each limb's axis
        std::array<Vector3, most> aside;         // from there, in the limb's axes, over its radius
        std::uint8_t count = 0;                  // of these limbs
        [[nodiscard]] std::span<const std::uint8_t> near() const { return {limbs.data(), count}; }
    };
    [[nodiscard]] static Vertex bind(const Vector3& point, const FigureField& field,
                                     std::span<const FigureLimb> limbs);
    [[nodiscard]] static Vector3 follow(const Vertex& vertex, std::span<const FigureLimb> limbs);
    [[nodiscard]] std::uint32_t keep_inside(std::size_t v, std::span<const RoundCone> cones,
                                            std::span<Vec3> places) const;
    /// A placement that goes on, by vertex.
    struct Placing {
        std::span<std::uint32_t> holders;  // a bit for each limb that contains the vertex
        std::span<std::uint8_t> moved;
        std::span<Vec3> places;
    };
    void press_inside(const Triangle& triangle, const FigureField& field, std::span<const RoundCone> cones,
                      const Placing& of) const;
    void smooth(const FigureField& field, std::span<Vec3> places) const;

    std::vector<Triangle> triangles_;
    std::vector<Vertex> vertices_;
    std::vector<Wear> wear_;
};

/// The figure of a body that follows a skeleton.
class BodyFigure {
  public:
    /// Meshes the body with about `edges` edges from its soles to its crown.
    BodyFigure(const Body& body, const Skeleton& skeleton, float edges);

    [[nodiscard]] const Figure& figure() const { return figure_; }
    /// Writes each vertex's place [m]. Preconditions: `capsules` as Body::place() writes them for this pose,
    /// of any girth; `to` has as many elements as the figure has vertices.
    void place(const Pose& pose, std::span<const TaperedCapsule> capsules, std::span<Vec3> to) const;

  private:
    FigureRig rig_;
    Figure figure_;
};

}  // namespace weft::demo
