#pragma once
// Faces of many corners, cut into triangles.

#include <span>
#include <vector>

#include "weft/mesh.h"
#include "weft/types.h"

namespace weft {

/// Fills `triangles` with the n - 2 triangles that a face with this outline is cut into, by numbers of its
/// corners. They turn as the outline does, and cover the face once, as seen along its normal (Newell's:
/// Sutherland, Sproull, Schumacker 1974). Faces of up to 64 corners are cut into fans about their first
/// corner, larger ones by halving; where such a cut would turn a triangle over, by ears (Meisters 1975,
/// "Polygons have ears"), the smallest circumscribed circle first. An outline may touch itself, as that of a
/// face with a hole does along an edge there and back. It gets triangles without area where it encloses
/// nothing.
///
/// Returns false if the outline crosses itself, so that no cut is right. `triangles` are then those of the
/// fan, or of the halving.
///
/// Precondition: the outline has at least three corners, all finite.
[[nodiscard]] bool triangulate(std::span<const Vec3> outline, std::vector<Triangle>& triangles);

}  // namespace weft
