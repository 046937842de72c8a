#include "demo/report_text.h"

namespace weft::demo {

std::string flags_text(StepFlags flags) {
    std::string text;
    if (has(flags, StepFlags::invalid_dt))
        text += "The step's length was not in [1e-6, 1] s; nothing was done.\n";
    if (has(flags, StepFlags::state_restored)) {
        text += "A cloth ran away and was put back: raise substeps or soften the fabric.\n";
    }
    if (has(flags, StepFlags::contacts_dropped)) {
        text += "Contact lists were full: lower the self-collision distance.\n";
    }
    if (has(flags, StepFlags::speed_limited)) {
        text += "Particles were held to the largest speed: look for a pin or a collider that jumps.\n";
    }
    if (has(flags, StepFlags::unsolved)) {
        text += "The method left too much unsolved: raise its effort or passes, or substeps.\n";
    }
    return text;
}

}  // namespace weft::demo
