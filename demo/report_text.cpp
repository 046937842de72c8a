#include "demo/report_text.h"

namespace weft::demo {

namespace {

struct FlagText {
    StepFlags flag;
    const char* text;
};
constexpr FlagText texts[] = {
    {StepFlags::invalid_dt, "The step's length was not in [1e-6, 1] s; nothing was done."},
    {StepFlags::state_restored, "A cloth ran away and was put back: raise substeps or soften the fabric."},
    {StepFlags::contacts_dropped, "Contact lists were full: lower the self-collision distance."},
    {StepFlags::speed_limited,
     "Particles were held to the largest speed: look for a pin or a collider that jumps."},
    {StepFlags::unsolved, "The method left too much unsolved: raise its effort or passes, or substeps."},
    {StepFlags::pins_stopped, "A pin was stopped by cloth in its way: move it slower, or round it."},
    {StepFlags::crossed, "Cloth went through cloth, which contact should not let it: a fault of Weft."}};

}  // namespace

std::string flags_text(StepFlags flags) {
    std::string result;
    for (const auto& [flag, text] : texts)
        if (has(flags, flag)) result.append(text).append("\n");
    return result;
}

}  // namespace weft::demo
