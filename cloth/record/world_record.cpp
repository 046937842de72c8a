// The World's calls for recordings.

#include "cloth/record/world_calls.h"

namespace weft {

namespace {

template <class WorldImpl, class Open>
Result<void> start(WorldImpl& world, const Open& open) {
    return without_exceptions([&]() -> Result<void> {
        if (auto ready = world.refuse_in_step("start_recording"); !ready) return ready;
        if (world.recorder)
            return Error{ErrorCode::invalid_argument,
                         "the World is recorded already; call stop_recording first"};
        if (world.has_changed)
            return Error{ErrorCode::invalid_argument,
                         "the World has changed since it was made, and a recording has no beginning then; "
                         "start it right after World::create"};
        auto made = open();
        if (!made) return made.error();
        world.recorder = std::move(made).value();
        return {};
    });
}

}  // namespace

Result<void> World::start_recording(const std::filesystem::path& file) {
    return start(*impl_, [&] { return Recorder::open(file, impl_->simulation.settings); });
}

Result<void> World::start_recording(const RecordingSink& sink) {
    return start(*impl_, [&] { return Recorder::begin(sink, impl_->simulation.settings); });
}

Result<void> World::stop_recording() {
    return without_exceptions([&]() -> Result<void> {
        if (auto ready = impl_->refuse_in_step("stop_recording"); !ready) return ready;
        if (!impl_->recorder)
            return Error{ErrorCode::invalid_argument, "nothing is recorded; call start_recording first"};
        const std::unique_ptr<Recorder> done = std::move(impl_->recorder);
        return done->stop();
    });
}

}  // namespace weft
