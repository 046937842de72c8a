#pragma once
// Random shapes, meshes and settings: each value within its documented range, with a bias to the ends; now
// and then beyond it.

#include <array>
#include <vector>

#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

/// A shape that owns what its spans show.
struct OwnedShape {
    enum class Kind { mesh, hull, ground, distances };
    Kind kind = Kind::mesh;
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool closed = true;
    std::uint32_t rows = 0, columns = 0;
    std::vector<float> heights;
    float size = 0.1f;  ///< of ground's and of distances' cells [m]

    [[nodiscard]] Shape shape() const;
};

/// A mesh, open or closed, a hull, ground, a distance field, or a broken one. At most some 300 triangles,
/// within a metre.
[[nodiscard]] Drawn<OwnedShape> random_shape(Random& random);
/// As many vertices, moved a little; or another number of them, or some that are not finite.
[[nodiscard]] Drawn<std::vector<Vec3>> random_deformation(Random& random, const OwnedShape& shape);

/// A sheet, a general mesh, several components, a pattern with seams, or a broken one. At most some 1700
/// vertices, within a few metres of the origin.
[[nodiscard]] Drawn<Mesh> random_mesh(Random& random);

/// Passes over the particles that a step of the cloth takes with these settings, about.
[[nodiscard]] std::uint64_t passes_of(const ClothSettings& settings);

/// A cloth that takes at most `most_passes` of them.
[[nodiscard]] Drawn<ClothSettings> random_cloth_settings(Random& random, std::uint64_t most_passes);
[[nodiscard]] Drawn<WorldSettings> random_world_settings(Random& random, int most_substeps);
[[nodiscard]] Drawn<Collider> random_collider(Random& random);
[[nodiscard]] Drawn<BodySettings> random_body(Random& random);
[[nodiscard]] BodyState random_body_state(Random& random);
/// An instance of the shape that was added as the so manieth; generations are the player's.
[[nodiscard]] Drawn<Collider> random_instance(Random& random, std::size_t shape);
/// The same kind of shape elsewhere, now and then far off.
[[nodiscard]] Drawn<Collider> random_move(Random& random, const Collider& from);

/// A rotation and a way, now and then a long one; or what is neither.
[[nodiscard]] Drawn<Transform> random_transform(Random& random);
/// A map; `either` for those that a cloth may refuse because of its other maps and settings.
[[nodiscard]] Drawn<Map> random_map(Random& random);
[[nodiscard]] float map_value(Random& random, Map map);

/// Runs the blocks in the caller's thread, the last one first.
[[nodiscard]] Executor backwards_executor();

}  // namespace weft::fuzz
