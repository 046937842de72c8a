#include "cloth/stages/forces/filling_step.h"

#include <cmath>
#include <utility>

#include "cloth/equation/sparse/vectors.h"

namespace weft {

void begin_filling(Worker& worker, Cloth& cloth, const StepEquation& equation) {
    if (!cloth.filling) return;
    cloth.filling->begin();
    if (!cloth.solver->joins())
        cloth.filling->linearise(worker.parallel, cloth.model, equation.positions, 0, equation.velocities);
}

// Places move along the response of the equation, in which what presses a collider hardly gives way. As with
// the push that is made up for, velocities stay.
void restore_volume(Worker& worker, Cloth& cloth) {
    constexpr int most = 3;
    constexpr double near = 1e-5;  // of the volume
    if (!cloth.filling || !cloth.filling->keeps_volume()) return;
    FillingRow& filling = *cloth.filling;
    ClothState& now = cloth.state;
    for (int k = 0; k < most; ++k) {
        filling.linearise(worker.parallel, cloth.model, now.positions.span(), 0, now.velocities.span());
        const double missing = filling.missing_volume();
        const double give =
            dot(worker.parallel, filling.gradient(), filling.response(), cloth.partial_sums.span());
        if (std::abs(missing) <= near * filling.volume() || !(give > 0)) return;
        for (AlignedBuffer<Vec4>* places : {&now.positions, &now.record.arrivals})
            scale_and_add(worker.parallel, static_cast<float>(missing / give), filling.response(), 1,
                          places->span());
    }
}

}  // namespace weft
