#include "collision/thin/collide.h"

#include "collision/thin/lead_out.h"
#include "collision/thin/whole_triangles.h"

namespace weft {

std::uint32_t collide(Parallel& parallel, std::span<const ColliderMotion> colliders, const ClothSide& cloth,
                      float h, const CollidingParticles& particles, std::span<std::uint32_t> block_partials) {
    if (colliders.empty()) return 0;
    const bool has_whole = particles.whole != nullptr && !particles.starts.empty();
    CollidingParticles all = particles;
    // From both sides of an edge, shallower ways out draw it out by less than lead_out() looks for.
    if (has_whole) all.deep = 0.125f * particles.whole->mean_edge();
    const MetParticles met = collide_particles(parallel, colliders, cloth, h, all, block_partials);
    if (!has_whole) return met.count;
    if (met.left_deep)
        lead_out(particles.whole->triangles(), particles.whole->mean_edge(), colliders, cloth, h, particles);
    return met.count + particles.whole->keep_out(parallel, colliders, cloth, h, particles);
}

}  // namespace weft
