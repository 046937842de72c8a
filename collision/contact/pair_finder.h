#pragma once
// Detection: which features of bodies of triangles are near, or are brought together by a motion.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "collision/contact/contact_mesh.h"
#include "collision/contact/pairs.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// A body in a search: a mesh, and where its particles are among all bodies'.
struct ContactBody {
    const ContactMesh* mesh;
    std::uint32_t first;       ///< its first particle among all bodies'
    float reach;               ///< [m]; a pair of two bodies has the mean of theirs
    std::uint32_t layer = 1;   ///< bits: which layers it is in
    std::uint32_t mask = ~0u;  ///< bits: which layers it meets; two bodies meet if both masks allow it
    bool meets_itself = true;
};

class PairFinder {
  public:
    /// Takes the memory that searches of these bodies need, whatever their reach and positions.
    void reserve(std::span<const ContactBody> bodies);

    /// Lists every pair of features that share no vertex, of bodies that may meet, with
    ///     min over A of min(n . x, n . (x + m)) - max over B of max(n . x, n . (x + m)) < reach,
    /// n being the normal of the pair's closest points at x: those that can come nearer than reach, if each
    /// particle goes any part of its own motion m. positions[i].w is ignored. Both spans are of all bodies'
    /// particles. Pairs whose boxes over the motion are farther apart than reach are not looked at.
    void find(Parallel& parallel, std::span<const ContactBody> bodies, std::span<const Vec4> positions,
              std::span<const Vec4> motions, PairList& found);

    [[nodiscard]] std::size_t bytes() const noexcept;
};

}  // namespace weft
