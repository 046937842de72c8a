#include "demo/report_text.h"

namespace weft::demo {

std::string flags_text(StepFlags flags) {
    std::string text;
    if (has(flags, StepFlags::invalid_dt))
        text.append("The step's length was not in [1e-6, 1] s; nothing was done.\n");
    if (has(flags, StepFlags::state_restored)) {
        text.append("A cloth ran away and was put back: raise substeps or soften the fabric.\n");
    }
    if (has(flags, StepFlags::contacts_dropped)) {
        text.append("Contact lists were full: lower the self-collision distance.\n");
    }
    if (has(flags, StepFlags::speed_limited)) {
        text.append("Particles were held to the largest speed: look for a pin or a collider that jumps.\n");
    }
    if (has(flags, StepFlags::unsolved)) {
        text.append("The method left too much unsolved: raise its effort or passes, or substeps.\n");
    }
    if (has(flags, StepFlags::pins_stopped)) {
        text.append("A pin was stopped by cloth in its way: move it slower, or round it.\n");
    }
    if (has(flags, StepFlags::crossed)) {
        text.append("Cloth went through cloth, which contact should not let it: a fault of Weft.\n");
    }
    return text;
}

}  // namespace weft::demo
