// Lines for the host's log.

#include <array>
#include <utility>

#include "cloth/record/world_calls.h"
#include "engine/memory/hooks.h"

namespace weft {

namespace {

constexpr std::array<std::pair<StepFlags, const char*>, 6> logged_flags{{
    {StepFlags::state_restored, "state_restored: a state was not finite, or too far off"},
    {StepFlags::contacts_dropped, "contacts_dropped: more is close than there is memory for"},
    {StepFlags::speed_limited, "speed_limited: particles were held to WorldSettings::max_speed"},
    {StepFlags::unsolved, "unsolved: more of the equation was left than the method tolerates"},
    {StepFlags::pins_stopped, "pins_stopped: cloth was in a pin's way"},
    {StepFlags::crossed, "crossed: something crosses that did not, a fault of Weft"},
}};

}  // namespace

void World::Impl::log_flags() noexcept {
    const StepFlags before = std::exchange(logged, simulation.report.flags);
    if (!is_logged() || logged == before) return;
    for (const auto& [flag, words] : logged_flags) {
        if (!has(logged, flag) || has(before, flag)) continue;
        bool is_first = true;
        simulation.cloths.for_each([&](ClothId id, const std::unique_ptr<Cloth>& cloth) {
            if (!is_first || !has(simulation.report_of(*cloth).flags, flag)) return;
            is_first = false;
            log_line(LogLevel::warning, "step %llu, cloth %u: %s",
                     static_cast<unsigned long long>(simulation.report.step), id.index, words);
        });
    }
}

}  // namespace weft
