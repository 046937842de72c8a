#pragma once
// Settings, each field within its documented range, with a bias to the ends; now and then beyond it.

#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

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
/// Of those that a cloth may refuse for other maps and settings that it has: either.
[[nodiscard]] Drawn<Map> random_map(Random& random);
[[nodiscard]] float map_value(Random& random, Map map);

/// Runs the blocks in the caller's thread, the last one first.
[[nodiscard]] Executor backwards_executor();

}  // namespace weft::fuzz
