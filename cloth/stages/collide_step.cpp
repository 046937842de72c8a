#include "cloth/stages/collide_step.h"

#include <algorithm>
#include <utility>

#include "cloth/stages/report_contacts.h"
#include "cloth/stages/step_bodies.h"
#include "cloth/stages/worn_step.h"
#include "collision/thin/collide.h"

namespace weft {

ClothSide side_of(const Simulation& world, const Cloth& cloth, float h) {
    return cloth.side(2 * h * world.gravity_on(cloth).norm());
}

std::uint32_t collide(Simulation& world, Worker& worker, Cloth& cloth, float h,
                      std::span<const Vec4> starts) {
    const auto timer = world.timed(Stage::colliders);
    if (cloth.meets_bodies) return collide_with_bodies(world, worker, cloth, h, starts);
    if (world.reports_contacts())
        std::ranges::copy(std::as_const(cloth.state.velocities).span(), cloth.scratch_velocities.data());
    const std::uint32_t touching =
        weft::collide(worker.parallel, colliders_of(worker, cloth), side_of(world, cloth, h), h,
                      {.positions = cloth.state.positions.span(),
                       .velocities = cloth.state.velocities.span(),
                       .starts = starts,
                       .held = cloth.state.held.normals.span(),
                       .whole = cloth.whole ? &*cloth.whole : nullptr},
                      cloth.partial_counts.span());
    if (world.reports_contacts() && touching > 0)
        add_impulses_of_change(worker, cloth, std::as_const(cloth.scratch_velocities).span());
    return touching;
}

}  // namespace weft
