#include "demo/headless/report_text.h"

#include <cmath>
#include <regex>

namespace weft::demo {

namespace {

constexpr float strong_wind = 25;  // alone drives cloth to the largest speed [m/s]
constexpr const char* blown =
    "The wind is so strong that particles were held to the largest speed: take less of it, or heavier cloth.";

struct FlagText {
    StepFlags flag;
    const char* text;
};
constexpr FlagText texts[] = {
    {StepFlags::invalid_dt, "The step's length was not in [1e-6, 1] s; nothing was done."},
    {StepFlags::state_restored,
     "A cloth ran away and was put back: raise substeps, or take a softer material or less wind."},
    {StepFlags::contacts_dropped,
     "More layers are close than are kept apart: lower the distance between layers."},
    {StepFlags::speed_limited,
     "Particles were held to the largest speed: look for a pin or a collider that jumps."},
    {StepFlags::unsolved,
     "The cloth was softer or slower than its material: more substeps or passes keep it true."},
    {StepFlags::pins_stopped, "A pin was stopped by cloth in its way: move it slower, or round it."},
    {StepFlags::crossed, "Cloth went through cloth, which contact should not let it: a fault of Weft."}};

}  // namespace

std::string flags_text(StepFlags flags, float wind_speed) {
    std::string result;
    for (const auto& [flag, text] : texts) {
        if (!has(flags, flag)) continue;
        const bool wind = flag == StepFlags::speed_limited && wind_speed > strong_wind;
        result.append(wind ? blown : text).append("\n");
    }
    return result;
}

StepFlags seen_flags(const StepReport& report) {
    constexpr float seen = 0.01f;  // [m]
    if (report.pin_lag > seen) return report.flags;
    return static_cast<StepFlags>(static_cast<unsigned>(report.flags) &
                                  ~static_cast<unsigned>(StepFlags::pins_stopped));
}

std::string plain_words(const std::string& message) {
    static const std::regex type("[A-Za-z_]+::");
    return std::regex_replace(message, type, "");
}

float speed_of(const Wind& wind) {
    return (1 + wind.gust) * std::hypot(wind.velocity.x, wind.velocity.y, wind.velocity.z);
}

}  // namespace weft::demo
