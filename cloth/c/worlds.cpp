// The World and its steps for C.

#include <utility>

#include "cloth/c/handles.h"

namespace weft::c {

namespace {

void run_by_host(void* user, std::uint32_t block_count, Executor::Body body, void* context) {
    const WeftExecutor& host = static_cast<const WeftWorld*>(user)->executor;
    host.run(host.user, block_count, body, context);
}

/// Settings for a World of this handle, and the host's executor, which the handle stores once they are
/// accepted.
struct TakenSettings {
    WorldSettings settings;
    WeftExecutor executor;
};
[[nodiscard]] Result<TakenSettings> take_settings(const WeftWorldSettings* given, WeftWorld& handle) {
    WeftWorldSettings all;
    weft_world_settings_init(&all, sizeof all);
    const Result<WeftWorldSettings> whole = taken("settings", given, all);
    if (!whole) return whole.error();
    auto settings = to_weft<WorldSettings>(*whole);
    if (!settings) return settings.error();
    if (whole->executor.run != nullptr)
        settings->executor = {.run = run_by_host, .user = &handle, .width = whole->executor.width};
    return TakenSettings{*settings, whole->executor};
}

[[nodiscard]] Result<void> replay_into(const Result<Replay>& done, WeftReplay* to) {
    if (!done) return done.error();
    WeftReplay all{};
    all.steps = done->steps;
    all.calls = done->calls;
    all.is_whole = done->is_whole;
    all.differs = done->difference.has_value();
    all.different_cloth = -1;
    if (done->difference) {
        all.different_step = done->difference->step;
        if (done->difference->cloth)
            all.different_cloth = static_cast<std::int32_t>(*done->difference->cloth);
    }
    return fill("replay", all, to);
}

/// Checks the struct for a result, before anything is done.
template <class Sized>
[[nodiscard]] Result<void> has_room(const char* name, const Sized* to) {
    if (auto there = are_there({{to, name}}); !there) return there;
    return check_size<Sized>(name, to->struct_size);
}

}  // namespace

}  // namespace weft::c

using namespace weft::c;

WeftResult weft_world_create(const WeftWorldSettings* settings, WeftWorld** world) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{world, "world"}}); !there) return there;
        auto made = std::make_unique<WeftWorld>();
        const auto of = take_settings(settings, *made);
        if (!of) return of.error();
        made->executor = of->executor;
        auto created = weft::World::create(of->settings);
        if (!created) return created.error();
        made->world.emplace(std::move(*created));
        *world = made.release();
        return {};
    });
}

void weft_world_destroy(WeftWorld* world) {
    delete world;
}

WeftResult weft_world_settings(const WeftWorld* world, WeftWorldSettings* settings) {
    return on(world, [&](const weft::World& of) {
        auto all = to_c<WeftWorldSettings>(of.settings());
        all.executor = world->executor;
        return fill("settings", all, settings);
    });
}

WeftResult weft_world_set_settings(WeftWorld* world, const WeftWorldSettings* settings) {
    return on(world, [&](weft::World& of) -> weft::Result<void> {
        const auto given = take_settings(settings, *world);
        if (!given) return given.error();
        // A call that is refused during a step must not change the executor, which the step reads.
        auto done = of.set_settings(given->settings);
        if (done) world->executor = given->executor;
        return done;
    });
}

WeftResult weft_world_step(WeftWorld* world, float dt) {
    if (world == nullptr) return fail(weft::ErrorCode::invalid_argument, "world is a null pointer");
    const weft::StepFlags flags = world->world->step(dt).flags;
    if (has(flags, weft::StepFlags::invalid_dt))
        return fail(weft::ErrorCode::invalid_argument,
                    "dt is out of range; it must be 1e-6 to 1 s, as 1/60 s");
    if (has(flags, weft::StepFlags::step_under_way))
        return fail(weft::ErrorCode::invalid_argument,
                    "step: a step was begun, and has to end first; call end_step; or another thread takes "
                    "one: make the World's calls one after the other");
    return WEFT_OK;
}

WeftResult weft_world_report(const WeftWorld* world, WeftStepReport* report) {
    return on(world, [&](const weft::World& of) {
        return fill("report", to_c<WeftStepReport>(of.report()), report);
    });
}

WeftResult weft_world_cloth_report(const WeftWorld* world, WeftClothId id, WeftClothReport* report) {
    return on(world, [&](const weft::World& of) {
        return hand("report", of.cloth_report(std::bit_cast<weft::ClothId>(id)), report);
    });
}

WeftResult weft_world_begin_step(WeftWorld* world, float dt) {
    return on(world, [&](weft::World& of) { return of.begin_step(dt); });
}
WeftResult weft_world_work(WeftWorld* world) {
    return on(world, [&](weft::World& of) { return of.work(); });
}
WeftResult weft_world_end_step(WeftWorld* world) {
    return on(world, [&](weft::World& of) { return of.end_step(); });
}

const WeftContact* weft_world_contacts(const WeftWorld* world, size_t* count) {
    return list<WeftContact>(world == nullptr ? std::span<const weft::Contact>() : world->world->contacts(),
                             count);
}

const WeftStageTime* weft_world_profile(const WeftWorld* world, size_t* count) {
    return list<WeftStageTime>(
        world == nullptr ? std::span<const weft::StageTime>() : world->world->profile(), count);
}
WeftResult weft_world_start_trace(WeftWorld* world, size_t max_events) {
    return on(world, [&](weft::World& of) { return of.start_trace(max_events); });
}
WeftResult weft_world_write_trace(const WeftWorld* world, const char* file) {
    return on(world, {{file, "file"}}, [&](const weft::World& of) { return of.write_trace(path_of(file)); });
}

WeftResult weft_world_debug_draw(const WeftWorld* world, const WeftDebugCanvas* canvas, uint32_t parts) {
    return on(world, {{canvas, "canvas"}}, [&](const weft::World& of) -> weft::Result<void> {
        weft::DebugCanvas to{.user = const_cast<WeftDebugCanvas*>(canvas)};
        if (canvas->line != nullptr)
            to.line = [](void* user, const weft::Vec3& from, const weft::Vec3& at, const weft::Vec3& colour) {
                const auto& host = *static_cast<const WeftDebugCanvas*>(user);
                const auto ends = std::bit_cast<std::array<WeftVec3, 3>>(std::array{from, at, colour});
                host.line(host.user, &ends[0], &ends[1], &ends[2]);
            };
        if (canvas->text != nullptr)
            to.text = [](void* user, const weft::Vec3& at, const char* words, const weft::Vec3& colour) {
                const auto& host = *static_cast<const WeftDebugCanvas*>(user);
                const auto both = std::bit_cast<std::array<WeftVec3, 2>>(std::array{at, colour});
                host.text(host.user, &both[0], words, &both[1]);
            };
        of.debug_draw(to, static_cast<weft::DebugParts>(parts));
        return {};
    });
}

WeftResult weft_world_describe(WeftWorld* world, int32_t format, const char** text) {
    return on(world, {{text, "text"}}, [&](const weft::World& of) -> weft::Result<void> {
        const auto as = enumerator<weft::DescriptionFormat>(format);
        if (!as) return as.error();
        auto description = of.describe(*as);
        if (!description) return description.error();
        world->description = *std::move(description);
        *text = world->description.c_str();
        return {};
    });
}

uint64_t weft_world_state_hash(const WeftWorld* world) {
    return world == nullptr ? 0 : world->world->state_hash();
}
size_t weft_world_save_size(const WeftWorld* world) {
    return world == nullptr ? 0 : world->world->save_size();
}
WeftResult weft_world_save(const WeftWorld* world, void* to, size_t bytes) {
    return on(world, {{to, "to"}}, [&](const weft::World& of) {
        return of.save({static_cast<std::byte*>(to), bytes});
    });
}
WeftResult weft_world_restore(WeftWorld* world, const void* saved, size_t bytes) {
    return on(world, {{saved, "saved"}}, [&](weft::World& of) {
        return of.restore({static_cast<const std::byte*>(saved), bytes});
    });
}

WeftResult weft_world_restore_cloths(WeftWorld* world, const void* saved, size_t bytes, uint32_t* restored) {
    return on(world, {{saved, "saved"}}, [&](weft::World& of) -> weft::Result<void> {
        const auto done = of.restore_cloths({static_cast<const std::byte*>(saved), bytes});
        if (!done) return done.error();
        if (restored != nullptr) *restored = *done;
        return {};
    });
}
size_t weft_world_cloth_save_size(const WeftWorld* world, WeftClothId id) {
    return world == nullptr ? 0 : world->world->cloth_save_size(id_of(id));
}
WeftResult weft_world_save_cloth(const WeftWorld* world, WeftClothId id, void* to, size_t bytes) {
    return on(world, {{to, "to"}}, [&](const weft::World& of) {
        return of.save_cloth(id_of(id), {static_cast<std::byte*>(to), bytes});
    });
}
WeftResult weft_world_restore_cloth(WeftWorld* world, WeftClothId id, const void* saved, size_t bytes) {
    return on(world, {{saved, "saved"}}, [&](weft::World& of) {
        return of.restore_cloth(id_of(id), {static_cast<const std::byte*>(saved), bytes});
    });
}

WeftResult weft_world_start_recording(WeftWorld* world, const char* file) {
    return on(world, {{file, "file"}}, [&](weft::World& of) { return of.start_recording(path_of(file)); });
}
WeftResult weft_world_start_recording_to(WeftWorld* world, const WeftRecordingSink* sink) {
    return on(world, {{sink, "sink"}}, [&](weft::World& of) -> weft::Result<void> {
        if (auto there = are_there({{reinterpret_cast<const void*>(sink->write), "sink.write"}}); !there)
            return there;
        auto host = std::make_unique<WeftRecordingSink>(*sink);
        const auto write = [](void* user, std::span<const std::byte> bytes) {
            const auto& to = *static_cast<const WeftRecordingSink*>(user);
            return to.write(to.user, bytes.data(), bytes.size()) != 0;
        };
        auto done = of.start_recording({.write = write, .user = host.get()});
        if (done) world->sink = std::move(host);
        return done;
    });
}
WeftResult weft_world_stop_recording(WeftWorld* world) {
    return on(world, [&](weft::World& of) { return of.stop_recording(); });
}

WeftResult weft_replay_file(const char* file, int32_t threads, WeftReplay* replay) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{file, "file"}}); !there) return there;
        if (auto room = has_room("replay", replay); !room) return room;
        return replay_into(weft::replay(path_of(file), {.threads = threads}), replay);
    });
}
WeftResult weft_replay_bytes(const void* recording, size_t bytes, int32_t threads, WeftReplay* replay) {
    return guarded([&]() -> weft::Result<void> {
        if (auto there = are_there({{recording, "recording"}}); !there) return there;
        if (auto room = has_room("replay", replay); !room) return room;
        return replay_into(
            weft::replay(std::span(static_cast<const std::byte*>(recording), bytes), {.threads = threads}),
            replay);
    });
}
