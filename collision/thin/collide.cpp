#include "collision/thin/collide.h"

#include "collision/thin/whole_triangles.h"

namespace weft {

std::uint32_t collide(Parallel& parallel, std::span<const ColliderMotion> colliders, const ClothSide& cloth,
                      float h, const CollidingParticles& particles, std::span<std::uint32_t> block_partials) {
    if (colliders.empty()) return 0;
    const std::uint32_t met = collide_particles(parallel, colliders, cloth, h, particles, block_partials);
    if (particles.whole == nullptr || particles.starts.empty()) return met;
    return met + particles.whole->keep_out(parallel, colliders, cloth, h, particles);
}

}  // namespace weft
