// The World's calls that take steps, whole or in three, and that return their results.

#include <algorithm>
#include <vector>

#include "cloth/record/world_calls.h"
#include "engine/error_text.h"

namespace weft {

namespace {

bool is_step(float dt) {
    return dt >= least_step && dt <= greatest_step;
}

void copy_state(const Cloth& cloth, ShownCloth& to) {
    const auto copy = [](const AlignedBuffer<Vec4>& from, AlignedBuffer<Vec4>& there) {
        std::ranges::copy(from.span(), there.data());
    };
    copy(cloth.state.positions, to.positions);
    copy(cloth.state.previous_positions, to.previous_positions);
    copy(cloth.state.velocities, to.velocities);
    copy(cloth.state.normals, to.normals);
    to.bounds = {cloth.extent.lower, cloth.extent.upper};
}

}  // namespace

void World::Impl::begin_step(float step) {
    std::vector<std::pair<Cloth*, std::unique_ptr<ShownCloth>>> made;
    made.reserve(simulation.cloths.size());
    simulation.cloths.for_each([&](ClothId, std::unique_ptr<Cloth>& cloth) {
        if (!cloth->shown) made.emplace_back(cloth.get(), std::make_unique<ShownCloth>(cloth->state.size()));
    });

    // From here on nothing can fail.
    for (auto& [cloth, shown] : made) cloth->shown = std::move(shown);
    simulation.cloths.for_each(
        [](ClothId, const std::unique_ptr<Cloth>& cloth) { copy_state(*cloth, *cloth->shown); });
    last = simulation.report;
    refused = {.flags = StepFlags::step_under_way, .step = last.step};
    dt = step;
}

void World::Impl::take_step() noexcept {
    simulation.parallel.lend([&] { simulation.step(dt); });
}

void World::Impl::end_step() noexcept {
    has_changed = true;
    simulation.take_chosen_levels();
    if (recorder) recorder->note_step(dt, simulation);
    log_flags();
}

const StepReport& World::step(float dt) noexcept {
    StepPhase before = StepPhase::none;
    if (!impl_->phase.compare_exchange_strong(before, StepPhase::stepping)) return impl_->refused;
    StepReport& report = impl_->simulation.report;
    if (is_step(dt)) {
        impl_->dt = dt;
        impl_->take_step();
        impl_->end_step();
    } else {
        impl_->simulation.clear_contacts();
        impl_->simulation.clear_body_impulses();
        report = {.flags = StepFlags::invalid_dt, .step = impl_->simulation.state.steps};
    }
    impl_->phase = StepPhase::none;
    return report;
}

Result<void> World::begin_step(float dt) {
    StepPhase before = StepPhase::none;
    if (!impl_->phase.compare_exchange_strong(before, StepPhase::stepping))
        return without_exceptions([&] { return Impl::refuse_in(before, "begin_step"); });
    auto begun = without_exceptions([&]() -> Result<void> {
        if (!is_step(dt))
            return out_of_range("dt", static_cast<double>(dt),
                                "from " + number_text(static_cast<double>(least_step)) + " to " +
                                    number_text(static_cast<double>(greatest_step)) + " s");
        impl_->begin_step(dt);
        return {};
    });
    impl_->phase = begun ? StepPhase::begun : StepPhase::none;
    return begun;
}

Result<void> World::work() {
    return without_exceptions([&]() -> Result<void> {
        StepPhase begun = StepPhase::begun;
        if (!impl_->phase.compare_exchange_strong(begun, StepPhase::working))
            return Error{ErrorCode::invalid_argument, begun == StepPhase::none || begun == StepPhase::stepping
                                                          ? "work: no step was begun; call begin_step first"
                                                          : "work: the step was taken; call end_step"};
        impl_->take_step();
        impl_->phase = StepPhase::done;
        return {};
    });
}

Result<void> World::end_step() {
    return without_exceptions([&]() -> Result<void> {
        // If several threads get here, the first one ends the step.
        StepPhase before = StepPhase::begun;
        if (impl_->phase.compare_exchange_strong(before, StepPhase::working))
            impl_->take_step();
        else if (before != StepPhase::done ||
                 !impl_->phase.compare_exchange_strong(before, StepPhase::working))
            return Error{ErrorCode::invalid_argument,
                         before == StepPhase::working
                             ? "end_step: work has not returned; wait for the task that called it"
                             : "end_step: no step was begun; call begin_step first"};
        impl_->end_step();
        impl_->phase = StepPhase::none;
        return {};
    });
}

const StepReport& World::report() const noexcept {
    const StepPhase phase = impl_->phase;
    if (phase == StepPhase::none) return impl_->simulation.report;
    return phase == StepPhase::stepping ? impl_->refused : impl_->last;
}

Result<ClothReport> World::cloth_report(ClothId id) const {
    return impl_->read("cloth_report", [&] {
        return with_cloth(impl_->simulation, id, [&](const Cloth& cloth) {
            return Result<ClothReport>(impl_->simulation.report_of(cloth));
        });
    });
}

std::span<const Contact> World::contacts() const noexcept {
    if (impl_->is_in_step()) return {};
    return impl_->simulation.contacts();
}

}  // namespace weft
